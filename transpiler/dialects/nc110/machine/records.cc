#include "transpiler/dialects/nc110/machine/records.h"

#include <algorithm>

#include "transpiler/dialects/nc110/source/tokens.h"

namespace plcxx::nc110 {
namespace {

/// One line without comment and blanks, and where it stands.
struct Record {
  std::string key;    // in capitals, "T01"
  std::string value;  // "F4"; empty without '='
  source::Range range;
};

std::optional<uint32_t> NumberOf(std::string_view text) {
  if (text.empty() || !IsDigit(text[0])) return std::nullopt;
  const auto number = Evaluate(text);
  if (!number.well_formed) return std::nullopt;
  return number.value;
}

class RecordReader {
 public:
  RecordReader(RecordFile kind, Settings& settings, diag::Engine& diagnostics)
      : kind_(kind), settings_(settings), diagnostics_(diagnostics) {}

  void Read(const Record& record);

 private:
  void ReadIocfil(const Record& record);
  void ReadInitialByte(const Record& record);
  void Reject(const Record& record, std::string_view expected) {
    diagnostics_.Report(record.range, diag::BadOptionValue, record.key, record.value, expected);
  }

  RecordFile kind_;
  Settings& settings_;
  diag::Engine& diagnostics_;
  uint32_t section_ = 0;
};

void RecordReader::ReadInitialByte(const Record& record) {
  const std::string_view number = std::string_view(record.key).substr(1);
  const auto initial = ParseInitialByte(number, record.value);
  if (!initial) {
    diagnostics_.Report(record.range, diag::Nc110InitialValue, record.key + "=" + record.value);
    return;
  }
  settings_.t_initial[initial->offset] = initial->value;
}

void RecordReader::ReadIocfil(const Record& record) {
  if (section_ == 1 && record.key == "CLO") {
    const size_t comma = record.value.find(',');
    const auto period = NumberOf(std::string_view(record.value).substr(0, comma));
    const auto slot =
        comma == std::string::npos ? std::nullopt : NumberOf(std::string_view(record.value).substr(comma + 1));
    if (!period || !slot || *period == 0 || *slot == 0) return Reject(record, "P,S in ms");
    settings_.period_ms = *period;
    settings_.slot_ms = *slot;
  } else if (section_ == 1 && record.key == "SPL") {
    const auto count = NumberOf(record.value);
    if (!count) return Reject(record, "a number");
    settings_.parse.max_symbols = *count;
  } else if (section_ == 4 && record.key.size() > 1 && record.key[0] == 'T' &&
             std::all_of(record.key.begin() + 1, record.key.end(), IsDigit)) {
    ReadInitialByte(record);
  }
}

void RecordReader::Read(const Record& record) {
  if (record.key[0] == '*') {
    section_ = NumberOf(std::string_view(record.key).substr(1)).value_or(0);
    return;
  }
  switch (kind_) {
    case RecordFile::kIocfil:
      return ReadIocfil(record);
    case RecordFile::kAxcfil:
      if (section_ == 1 && record.key == "TIM") {
        const auto tick = NumberOf(record.value);
        if (!tick || *tick == 0) return Reject(record, "a time in ms");
        settings_.tim_ms = *tick;
      }
      return;
    case RecordFile::kPgcfil:
      if (record.key == "OLD") settings_.retention = record.value != "0";
      return;
  }
}

}  // namespace

void ReadRecords(const source::SourceManager& sources, source::FileId file, RecordFile kind, Settings& settings,
                 diag::Engine& diagnostics) {
  RecordReader reader(kind, settings, diagnostics);
  const source::File& text = sources.Get(file);
  for (uint32_t line = 1; line <= sources.LineCount(file); ++line) {
    std::string_view rest = sources.Line(file, line);
    const auto begin = static_cast<source::Offset>(text.base + (rest.data() - text.text.data()));
    rest = rest.substr(0, rest.find(';'));
    Record record;
    std::string* part = &record.key;
    for (const char c : rest) {
      if (c == ' ' || c == '\t' || c == '\f') continue;
      if (c == '=' && part == &record.key) {
        part = &record.value;
      } else {
        part->push_back(Upper(c));
      }
    }
    if (record.key.empty()) continue;
    record.range = {begin, begin + static_cast<source::Offset>(rest.size())};
    reader.Read(record);
  }
}

}  // namespace plcxx::nc110
