#include "transpiler/dialects/nc110/parser/symbol_file_reader.h"

namespace plcxx::nc110 {
namespace {

constexpr size_t kMaxSymbol = 127;

bool IsForeign(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// Reads one line from left to right.
struct LineReader {
  std::string_view line;
  source::Offset begin;
  size_t at = 0;

  void SkipBlanks() {
    while (at < line.size() && IsBlank(line[at])) {
      ++at;
    }
  }
  bool AtEnd() const { return at == line.size() || line[at] == ';'; }
  source::Range RangeFrom(size_t from) const {
    return {begin + static_cast<source::Offset>(from), begin + static_cast<source::Offset>(at)};
  }
  source::Range Here() const {
    const auto place = begin + static_cast<source::Offset>(at);
    return {place, place + (at < line.size() ? source::FirstCodePoint(line.substr(at)).length : 0)};
  }
  template <class Accepts>
  std::string_view Word(Accepts accepts) {
    const size_t from = at;
    while (at < line.size() && (IsForeign(line[at]) || accepts(line[at]))) {
      ++at;
    }
    return line.substr(from, at - from);
  }
};

bool HasForeign(std::string_view text) {
  for (const char c : text) {
    if (IsForeign(c)) {
      return true;
    }
  }
  return false;
}

bool HasSmallLetter(std::string_view text) {
  for (const char c : text) {
    if (c >= 'a' && c <= 'z') {
      return true;
    }
  }
  return false;
}

}  // namespace

void SymbolFileReader::ParseSymbolFile(source::FileId file, bool is_late) {
  now_.file = &sources_.Get(file);
  now_.case_warned = false;
  if (is_late) {
    diagnostics_.Report({now_.file->base, now_.file->base + 1}, diag::Nc110SymbolFileLate);
  }
  HomoglyphReader homoglyphs(options_.accept_homoglyphs ? Homoglyphs::kAccept : Homoglyphs::kReject, diagnostics_);
  const uint32_t lines = sources_.LineCount(file);
  for (uint32_t line = 2; line <= lines; ++line) {
    now_.failed = now_.panic = false;
    ParseSymbolLine(sources_.Line(file, line), now_.file->base + now_.file->line_starts[line - 1], homoglyphs);
  }
}

void SymbolFileReader::ParseSymbolLine(std::string_view line, source::Offset begin, HomoglyphReader& homoglyphs) {
  LineReader reader{line, begin};
  reader.SkipBlanks();
  if (reader.AtEnd()) {
    return;
  }
  std::string mapped_name;
  const size_t name_at = reader.at;
  std::string_view name = reader.Word(IsNameCharacter);
  Symbol symbol;
  symbol.range = reader.RangeFrom(name_at);
  if (HasForeign(name)) {
    now_.failed = homoglyphs.Read(name, symbol.range.begin, mapped_name) == HomoglyphReader::Outcome::kReported;
    name = mapped_name;
    if (name.empty()) {
      return;
    }
  }
  if (name.empty()) {
    Fault(reader.Here(), diag::Nc110SymbolLine, "a line begins with a name of letters, digits and @ # . ' ?");
    return;
  }
  if (name.size() > kMaxSymbol) {
    Fault(symbol.range, diag::Nc110SymbolTooLong, static_cast<diag::Number>(name.size()));
    return;
  }
  reader.SkipBlanks();
  if (reader.AtEnd() || line[reader.at] != '=') {
    Fault(reader.Here(), diag::Nc110SymbolLine, "'=' expected after the name");
    return;
  }
  ++reader.at;
  reader.SkipBlanks();
  const size_t run_at = reader.at;
  std::string mapped_run;
  std::string_view run = reader.Word([](char c) { return IsLetter(c) || IsDigit(c); });
  const source::Range run_range = reader.RangeFrom(run_at);
  if (run.empty()) {
    Fault(reader.Here(), diag::Nc110SymbolLine, "operand expected after '='");
    return;
  }
  if (HasForeign(run)) {
    now_.failed =
        homoglyphs.Read(run, run_range.begin, mapped_run) == HomoglyphReader::Outcome::kReported || now_.failed;
    run = mapped_run;
  }
  reader.SkipBlanks();
  if (!reader.AtEnd()) {
    Fault(reader.Here(), diag::Nc110SymbolLine, "nothing but a comment may follow the operand");
    return;
  }
  if (reader.at < line.size()) {
    const size_t comment_at = reader.at;
    reader.at = line.size();
    symbol.comment = reader.RangeFrom(comment_at);
  }
  if (HasSmallLetter(run)) {
    if (options_.strict_case) {
      Fault(run_range, diag::Nc110LowerCaseRejected, run);
    } else if (!std::exchange(now_.case_warned, true)) {
      diagnostics_.Report(run_range, diag::Nc110LowerCase, run, Capitals(run));
    }
  }
  symbol.operand = run.empty() ? Operand{} : operands_.ReadOperand(run, run_range);
  symbol.name = name;
  operands_.DefineSymbol(std::move(symbol));
}

}  // namespace plcxx::nc110
