#include "transpiler/dialects/host50/parser/structure_reader.h"

#include <algorithm>

#include "transpiler/support/near_words.h"

namespace plcxx::host50 {
namespace {

constexpr std::string_view kNetwork = "NETWORK";
constexpr std::string_view kDirectives[] = {"SLOWDIV", "CHANNELS", "OPTION"};

bool IsSection(PartKind part) { return part == PartKind::kFast || part == PartKind::kSlow || part == PartKind::kSub; }

/// A part that begins at top level.
std::optional<PartKind> Opener(std::string_view word) {
  const auto part = PartByName(word);
  return part == PartKind::kLadder ? std::nullopt : part;
}

bool IsDirective(std::string_view word) {
  for (const std::string_view directive : kDirectives) {
    if (EqualIgnoringCase(directive, word)) return true;
  }
  return false;
}

}  // namespace

Parts StructureReader::ReadStructure() {
  for (uint32_t file = 0; file < files_.size(); ++file) {
    EnterFile(file);
    sections_.ForgetComments();
    last_section_.reset();
    for (line_ = 0; !AtEndOfFile();) ReadTopLevelLine();
    if (last_section_) sections_.AddEndComments(*last_section_);
  }
  return std::move(parts_);
}

bool StructureReader::AtNextPart() { return AtEndOfFile() || Opener(WordOf(CurrentLine())); }

void StructureReader::ReadTopLevelLine() {
  Line& line = CurrentLine();
  if (line.kind == LineKind::kBlank || line.kind == LineKind::kComment) {
    if (line.kind == LineKind::kComment) sections_.AddComment(line.comment);
    ++line_;
    return;
  }
  const std::string_view word = WordOf(line);
  if (const auto part = Opener(word)) {
    IsSection(*part) ? ReadSection(*part) : ReadTable(*part);
  } else if (IsDirective(word)) {
    ForgetCommentsOfTable();
    parts_.directives.push_back({now_.file, line_++});
  } else if (PartByEnd(word)) {
    Begin(line);
    Fault(Peek().range, diag::Host50UnexpectedEnd, word, "closes nothing");
    sections_.ForgetComments();
    ++line_;
  } else if (!ReadRowsWithoutSymbols() && !ReadMisspeltOpening()) {
    ReadStray();
  }
}

std::optional<uint32_t> StructureReader::NextEnd() const {
  const std::vector<Line>& lines = files_[now_.file].lines;
  for (uint32_t line = line_; line < lines.size(); ++line) {
    const std::string_view word = WordOf(lines[line]);
    if (const auto part = PartByEnd(word); part && part != PartKind::kLadder) return line;
    if (Opener(word) || IsDirective(word)) break;
  }
  return std::nullopt;
}

bool StructureReader::ReadMisspeltOpening() {
  const auto end = NextEnd();
  if (!end) return false;
  const PartKind part = *PartByEnd(WordOf(files_[now_.file].lines[*end]));
  std::string word(WordOf(CurrentLine()));
  std::ranges::transform(word, word.begin(), Upper);
  constexpr size_t kShortName = 4;
  const size_t most_edits = Name(part).size() > kShortName ? 2 : 1;
  if (MnemonicByName(word) || support::EditDistance(word, Name(part)) > most_edits) return false;
  Begin(CurrentLine());
  Fault(Peek().range, diag::Host50UnknownInstructionNear, TextOf(Peek()), Name(part));
  IsSection(part) ? ReadSection(part) : ReadTable(part);
  return true;
}

bool StructureReader::IsSymbolRow(const Line& line) const {
  if (line.kind != LineKind::kStatement || line.tokens.count < 2) return false;
  const auto& tokens = files_[now_.file].tokens;
  const TokenKind named = tokens[line.tokens.first + 1].kind;
  return tokens[line.tokens.first].kind == TokenKind::kAddress &&
         (named == TokenKind::kWord || named == TokenKind::kQuotedSymbol || named == TokenKind::kString);
}

/// Rows of a table of symbols that no SYMBOLS opens: they are read as what they are.
bool StructureReader::ReadRowsWithoutSymbols() {
  if (!IsSymbolRow(CurrentLine())) return false;
  sections_.ForgetComments();
  Begin(CurrentLine());
  Fault(Peek().range, diag::Host50UnknownInstructionHint, TextOf(Peek()),
        "SYMBOLS in front of the names of addresses, and END_SYMBOLS behind them");
  TablePart table{.part = PartKind::kSymbols, .file = now_.file, .first = line_};
  while (!AtEndOfFile() && (IsSymbolRow(CurrentLine()) || CurrentLine().kind != LineKind::kStatement)) ++line_;
  table.last = line_;
  if (!AtEndOfFile() && PartByEnd(WordOf(CurrentLine())) == PartKind::kSymbols) ++line_;
  parts_.tables.push_back(table);
  return true;
}

/// What stands above a table or a directive is about it; in front of the first section it may be the head of the file.
void StructureReader::ForgetCommentsOfTable() {
  if (last_section_) sections_.ForgetComments();
}

void StructureReader::ReadTable(PartKind part) {
  ForgetCommentsOfTable();
  const source::Range opening = CurrentLine().range;
  Begin(CurrentLine());
  Take();
  ExpectEnd();
  TablePart table{.part = part, .file = now_.file, .first = ++line_};
  for (bool open = true; open; ++line_) {
    if (AtNextPart()) {
      Report(opening, diag::Host50MissingEnd, Name(part));
      break;
    }
    Line& line = CurrentLine();
    const std::string_view word = WordOf(line);
    const auto end = PartByEnd(word);
    if (end) line.consumed = true;
    if (end == part) {
      ReadEnd();
      open = false;
    } else if (end) {
      open = !ReadWrongEnd(part);
    } else if (IsDirective(word)) {
      ReportDirectiveInside(part);
    } else if (ReadMisspeltEnd(part)) {
      line.consumed = true;
      open = false;
    }
  }
  table.last = line_;
  parts_.tables.push_back(table);
}

void StructureReader::ReadEnd() {
  Begin(CurrentLine());
  Take();
  ExpectEnd();
}

void StructureReader::ReportDirectiveInside(PartKind part) {
  CurrentLine().consumed = true;
  Begin(CurrentLine());
  std::string word(TextOf(Peek()));
  for (char& c : word) c = Upper(c);
  Fault(Peek().range, diag::Host50DirectiveInside, word, Name(part));
}

/// What was found once holds up to there: thousands of wrong ends would each look through the rest of the file.
bool StructureReader::EndsLater(PartKind part) {
  if (ahead_.file == now_.file && ahead_.part == part && ahead_.from <= line_ && line_ < ahead_.line)
    return ahead_.ends;
  const LexedFile& file = files_[now_.file];
  ahead_ = {now_.file, part, line_, line_ + 1, false};
  for (; ahead_.line < file.lines.size(); ++ahead_.line) {
    const std::string_view word = WordOf(file.lines[ahead_.line]);
    ahead_.ends = PartByEnd(word) == part;
    if (ahead_.ends || Opener(word)) break;
  }
  return ahead_.ends;
}

bool StructureReader::ReadWrongEnd(PartKind part) {
  Begin(CurrentLine());
  const std::string open = "does not close " + std::string(Name(part));
  Fault(Peek().range, diag::Host50UnexpectedEnd, TextOf(Peek()), open);
  return !EndsLater(part);
}

bool StructureReader::ReadMisspeltEnd(PartKind part) {
  std::string word(WordOf(CurrentLine()));
  std::ranges::transform(word, word.begin(), Upper);
  const std::string end = "END_" + std::string(Name(part));
  constexpr size_t kMostEdits = 2;
  const bool is_meant = word == "END" || (word.starts_with("END") && support::EditDistance(word, end) <= kMostEdits) ||
                        (word.size() + 1 >= end.size() && support::EditDistance(word, end) == 1);
  if (!is_meant || EndsLater(part)) return false;
  Begin(CurrentLine());
  Fault(Peek().range, diag::Host50UnknownInstructionNear, TextOf(Peek()), end);
  return true;
}

void StructureReader::ReadSection(PartKind part) {
  const source::Range opening = CurrentLine().range;
  const SectionId id = sections_.OpenSection(part, CurrentLine());
  last_section_ = id;
  ++line_;
  for (bool open = true; open; ++line_) {
    if (AtNextPart()) {
      sections_.CloseBody(line_);
      Report(opening, diag::Host50MissingEnd, Name(part));
      break;
    }
    Line& line = CurrentLine();
    const std::string_view word = WordOf(line);
    const auto end = PartByEnd(word);
    if (end == part) {
      sections_.CloseBody(line_);
      program_.sections[id].end_comments = sections_.TakeComments(line);
      ReadEnd();
      open = false;
    } else if (end && end != PartKind::kLadder) {
      sections_.CloseLadder();
      line.consumed = true;
      open = !ReadWrongEnd(part);
      if (!open) sections_.CloseBody(line_);
    } else if (IsDirective(word)) {
      ReportDirectiveInside(part);
    } else if (EqualIgnoringCase(word, kNetwork)) {
      sections_.CloseBody(line_);
      sections_.OpenNetwork(id, line, line_);
    } else if (ReadMisspeltEnd(part)) {
      line.consumed = true;
      sections_.CloseBody(line_);
      open = false;
    } else {
      sections_.TakeBodyLine(id, line, line_);
    }
  }
}

void StructureReader::ReadStray() {
  const SectionId id = sections_.OpenStraySection(CurrentLine());
  bool reported = false;
  bool at_end = false;
  for (; !AtEndOfFile(); ++line_) {
    Line& line = CurrentLine();
    const std::string_view word = WordOf(line);
    const auto end = PartByEnd(word);
    if (Opener(word) || IsDirective(word)) break;
    if (end && end != PartKind::kLadder) {
      at_end = IsSection(*end);  // what it would close has been reported as standing outside of it
      break;
    }
    if (!EqualIgnoringCase(word, kNetwork)) {
      sections_.TakeBodyLine(id, line, line_);
      continue;
    }
    sections_.CloseBody(line_);
    Begin(line);
    if (!std::exchange(reported, true)) Fault(line.range, diag::Host50OutsideSection);
    sections_.OpenStrayNetwork(id, line, line_ + 1);
  }
  sections_.CloseBody(line_);
  if (at_end) ++line_;
}

}  // namespace plcxx::host50
