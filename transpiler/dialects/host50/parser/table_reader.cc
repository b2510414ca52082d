#include "transpiler/dialects/host50/parser/table_reader.h"

#include <algorithm>
#include <vector>

#include "transpiler/support/near_words.h"

namespace plcxx::host50 {
namespace {

std::string_view Trim(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// The severity that a text names before its first '-'; the text loses it.
std::optional<Severity> TakeSeverityPrefix(std::string& text) {
  const size_t dash = text.find('-');
  if (dash == std::string::npos) return std::nullopt;
  for (const SeverityInfo& row : Severities()) {
    if (Trim(std::string_view(text).substr(0, dash)) != row.prefix) continue;
    text = Trim(std::string_view(text).substr(dash + 1));
    return row.severity;
  }
  return std::nullopt;
}

std::optional<Severity> SeverityByName(std::string_view word) {
  for (const SeverityInfo& row : Severities()) {
    if (EqualIgnoringCase(row.keyword, word)) return row.severity;
  }
  return std::nullopt;
}

}  // namespace

void TableReader::ReadTables(std::span<const TablePart> tables) {
  // A name, a text and a title are needed by nothing that stands in the same tables: one walk is enough.
  for (const TablePart& table : tables) {
    EnterFile(table.file);
    for (uint32_t i = table.first; i < table.last; ++i) {
      const Line& line = files_[now_.file].lines[i];
      if (line.kind != LineKind::kStatement || line.consumed) continue;
      Begin(line);
      if (FaultOfBadToken()) continue;
      if (table.part == PartKind::kTitle) ReadTitleRow(line);
      if (table.part == PartKind::kSymbols) symbols_.ReadSymbolRow(line);
      if (table.part == PartKind::kAlarms) ReadAlarmRow(line);
      if (table.part == PartKind::kMCodes) ReadMCodeRow(line);
    }
  }
  if (program_.settings.predefined == PredefinedOption::kOn) symbols_.AddPredefinedSymbols();
}

std::string TableReader::ReadLastString(std::string_view what) {
  if (!At(TokenKind::kString)) {
    FaultOfMissing(what);
    return {};
  }
  std::string text = StringOf(Take());
  ExpectEnd();
  return text;
}

void TableReader::ReadTitleRow(const Line& line) {
  const Token word = Peek();
  const auto keys = TitleKeys();
  const auto row =
      std::ranges::find_if(keys, [&](const TitleKeyInfo& key) { return EqualIgnoringCase(key.name, TextOf(word)); });
  if (word.kind != TokenKind::kWord || row == keys.end()) {
    std::string capitals(TextOf(word));
    std::ranges::transform(capitals, capitals.begin(), Upper);
    std::vector<std::string_view> names;
    for (const TitleKeyInfo& key : keys) names.push_back(key.name);
    const std::string_view near = support::NearestWord(capitals, names);
    if (near.empty()) {
      Fault(word.range, diag::Host50UnknownInstruction, TextOf(word));
    } else {
      Fault(word.range, diag::Host50UnknownInstructionNear, TextOf(word), near);
    }
    return;
  }
  if (!title_keys_.insert(row->key).second) Fault(word.range, diag::Host50DirectiveTwice, row->name);
  Take();
  TitleField field{.key = row->key, .text = ReadLastString("a text in double quotes"), .range = line.range};
  if (!now_.failed) program_.title.push_back(std::move(field));
}

void TableReader::ReadAlarmRow(const Line& line) {
  const Token token = Peek();
  if (token.kind != TokenKind::kAddress) {
    Fault(token.range, diag::Host50AddressExpected, Found());
    return;
  }
  const AddressText address = ReadAddressText(TextOf(token), program_.settings.channels);
  const bool is_alarm = address.fault == AddressFault::kNone && address.address.area == Area::kQ &&
                        address.address.number >= kFirstAlarm && address.address.number < kFirstAlarm + kAlarmCount;
  if (address.fault != AddressFault::kNone && address.fault != AddressFault::kRange) {
    symbols_.ResolveAddress(token);
  } else if (!is_alarm) {
    Fault(token.range, diag::Host50AlarmAddress, TextOf(token));
  }
  Take();
  Alarm alarm{.index = is_alarm ? address.address.number - kFirstAlarm : 0, .range = line.range};
  std::optional<Severity> severity;
  if (At(TokenKind::kWord)) {
    severity = SeverityByName(TextOf(Peek()));
    if (!severity) return FaultOfMissing("NOTICE, CAUTION, WARNING or a text in double quotes");
    Take();
  }
  alarm.text = ReadLastString("a text in double quotes");
  if (!severity) severity = TakeSeverityPrefix(alarm.text);
  alarm.severity = severity.value_or(Severity::kNotice);
  if (is_alarm && !alarms_.insert(alarm.index).second) {
    Fault(token.range, diag::Host50DuplicateAlarm, TextOf(token));
  }
  if (!now_.failed) program_.alarms.push_back(std::move(alarm));
}

void TableReader::ReadMCodeRow(const Line& line) {
  const Token token = Peek();
  if (token.kind != TokenKind::kInteger || !IsDigit(TextOf(token).front())) {
    return FaultOfMissing("the number of an M code");
  }
  const int64_t value = IntegerOf(token, TextOf(token)).value;
  if (value > kGreatestMCode) Fault(token.range, diag::Host50MCodeRange, TextOf(token));
  Take();
  MCode code{
      .number = static_cast<uint32_t>(value), .text = ReadLastString("a text in double quotes"), .range = line.range};
  if (!now_.failed && !mcodes_.insert(code.number).second) Fault(token.range, diag::Host50DuplicateMCode, value);
  if (!now_.failed) program_.mcodes.push_back(std::move(code));
}

}  // namespace plcxx::host50
