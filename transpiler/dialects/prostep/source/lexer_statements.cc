// Lines with a colon (specification 2.2 to 2.6).
#include <algorithm>

#include "transpiler/dialects/prostep/source/lexer_internal.h"

namespace plcxx::prostep {
namespace {

/// How a mnemonic is followed, whichever of its meanings is meant.
struct Form {
  bool known = false;
  bool alone = false;    // may stand without an operand on its line
  bool operand = false;  // may have one
  bool target = false;   // a label
};

Form FormOf(std::string_view mnemonic) {
  Form form;
  for (const InstructionInfo& info : Instructions()) {
    if (info.op == Op::kUnknown || info.mnemonic != mnemonic) continue;
    form.known = true;
    form.alone |= info.lines == Lines::kNone || info.lines == Lines::kOneOf;
    form.operand |= info.lines != Lines::kNone;
    form.target |= (info.own & kLabels) != 0;
  }
  return form;
}

constexpr bool IsRelation(char c) { return c == '!' || c == '<' || c == '>' || c == '='; }

bool IsPlain(char c) { return static_cast<unsigned char>(c) < 0x80 && c != '\x7F' && (c >= ' ' || c == '\t'); }

bool IsModuleClass(std::string_view word) {
  const OperandClass operand_class = ClassByName(word);
  return operand_class == OperandClass::kPM || operand_class == OperandClass::kFM;
}

}  // namespace

bool LooksLikeInstruction(std::string_view text) {
  const auto take = [&text](auto&& is_wanted) {
    const auto end = static_cast<size_t>(std::ranges::find_if_not(text, is_wanted) - text.begin());
    const std::string word = Upper(text.substr(0, end));
    text.remove_prefix(end);
    return word;
  };
  const auto skip_blanks = [&text] { text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size())); };
  const std::string mnemonic = take(!text.empty() && IsRelation(text.front()) ? IsRelation : IsLetter);
  const Form form = FormOf(mnemonic);
  const bool module = ModuleMarkByName(mnemonic).has_value();
  if ((!module && (!form.known || !form.operand)) || text.empty() || IsLetter(text.front())) return false;
  skip_blanks();
  const std::string operand = take(IsLetter);
  if (ClassByName(operand) == OperandClass::kNone || (module && operand != "PM")) return false;
  skip_blanks();
  if (text.empty() || !IsDigit(text.front())) return false;
  take([](char c) { return IsDigit(c) || IsLetter(c) || c == '.'; });
  skip_blanks();
  return text.empty() || text.front() == ';' || text.front() == '*';
}

void LineLexer::SkipBlanks() { at_ = std::min(text_.find_first_not_of(" \t", at_), text_.size()); }

size_t LineLexer::LettersEnd(size_t from) const {
  while (from < text_.size() && IsLetter(text_[from])) ++from;
  return from;
}

size_t LineLexer::RunEnd(size_t from) const { return std::min(text_.find_first_of(" \t;*", from), text_.size()); }

source::Range LineLexer::RangeOf(size_t begin, size_t end) const {
  return {begin_ + static_cast<source::Offset>(begin), begin_ + static_cast<source::Offset>(end)};
}

bool LineLexer::ReportCharacters(size_t begin, size_t end) {
  for (size_t i = begin; i < end; ++i) {
    if (IsPlain(text_[i])) continue;
    const source::CodePoint point = source::FirstCodePoint(text_.substr(i));
    const source::Range range = RangeOf(i, i + point.length);
    // A byte that could not be decoded has been reported with all others of the file.
    if (std::ranges::binary_search(file_.replaced, range.begin - file_.base)) return true;
    if (point.length == 1) {
      diagnostics_.Report(range, diag::ProstepControlCharacter, source::CodePointName(point.value));
    } else {
      diagnostics_.Report(range, diag::ProstepCharacter, "'" + std::string(text_.substr(i, point.length)) + "'",
                          source::CodePointName(point.value));
    }
    return true;  // one message for a token
  }
  return false;
}

bool LineLexer::ReportControlCharacters(size_t begin, size_t end) {
  for (size_t i = begin; i < end; ++i) {
    if (static_cast<unsigned char>(text_[i]) < 0x80 && !IsPlain(text_[i])) return ReportCharacters(i, i + 1);
  }
  return false;
}

void LineLexer::Take(TokenKind kind, size_t end) {
  Token token{.kind = kind, .range = RangeOf(at_, end)};
  if (kind == TokenKind::kText) {
    token.faulty = ReportControlCharacters(at_, end);
  } else if (kind != TokenKind::kComment && kind != TokenKind::kHeader) {
    token.faulty = ReportCharacters(at_, end);
  }
  tokens_.push_back(token);
  at_ = end;
}

void LineLexer::Whole(TokenKind kind) {
  SkipBlanks();
  Take(kind, at_ + TrimBlanks(Rest()).size());
}

void LineLexer::Comment() {
  SkipBlanks();
  if (!AtEnd()) Whole(TokenKind::kComment);
}

void LineLexer::Statement() {
  const size_t colon = text_.find(':');
  WordsBeforeColon(colon);
  at_ = colon;
  Take(TokenKind::kColon, colon + 1);
  SkipBlanks();
  if (!AtRest()) InstructionOrOperand();
  Comment();
}

void LineLexer::WordsBeforeColon(size_t colon) {
  SkipBlanks();
  while (at_ < colon) {
    Take(TokenKind::kLabel, std::min(text_.find_first_of(" \t:", at_), colon));
    SkipBlanks();
  }
}

void LineLexer::InstructionOrOperand() {
  const char c = text_[at_];
  if (IsLetter(c)) return Word();
  if (c == ')') return Take(TokenKind::kMnemonic, at_ + 1);
  if (!IsRelation(c)) return Take(TokenKind::kUnknown, RunEnd(at_));
  size_t end = at_;
  while (end < text_.size() && IsRelation(text_[end])) ++end;
  const std::string_view mnemonic = text_.substr(at_, end - at_);
  if (!FormOf(mnemonic).known) return Take(TokenKind::kUnknown, end);
  Take(TokenKind::kMnemonic, end);
  OperandBehind(mnemonic);
}

void LineLexer::Word() {
  const size_t end = LettersEnd(at_);
  const std::string word = Upper(text_.substr(at_, end - at_));
  if (IsOperandLine(word, end)) return Operand();
  if (TakeBracket(end)) return;
  const bool attached = end < text_.size() && (IsDigit(text_[end]) || static_cast<unsigned char>(text_[end]) >= 0x80);
  if (attached) return Take(TokenKind::kUnknown, RunEnd(at_));
  if (ModuleMarkByName(word)) {
    Take(TokenKind::kModuleMark, end);
    return Operand();
  }
  if (!FormOf(word).known) return Take(TokenKind::kUnknown, end);
  Take(TokenKind::kMnemonic, end);
  OperandBehind(word);
}

/// An operand class and its number (2.6). `K` takes whatever stands after it.
bool LineLexer::IsOperandLine(std::string_view word, size_t word_end) const {
  const OperandClass operand_class = ClassByName(word);
  if (operand_class == OperandClass::kNone || word == "O" || word == "T" || IsModuleClass(word)) return false;
  if (operand_class == OperandClass::kK) return true;
  const size_t next = text_.find_first_not_of(" \t", word_end);
  return next != std::string_view::npos && IsDigit(text_[next]);
}

/// 'A(' and 'O(', blanks between them or not; any other word with a bracket is no instruction.
bool LineLexer::TakeBracket(size_t word_end) {
  const size_t next = text_.find_first_not_of(" \t", word_end);
  if (next == std::string_view::npos || text_[next] != '(') return false;
  const std::string name = Upper(text_.substr(at_, word_end - at_)) + "(";
  const bool known = FormOf(name).known;
  if (!known && next != word_end && ForeignHint(name).empty()) return false;
  Take(known ? TokenKind::kMnemonic : TokenKind::kUnknown, next + 1);
  return true;
}

void LineLexer::OperandBehind(std::string_view mnemonic) {
  const Form form = FormOf(mnemonic);
  SkipBlanks();
  if (!form.operand || AtRest()) return;
  if (form.alone && !IsOperandLike(Rest())) return;
  if (form.target) return Target();
  Operand();
}

void LineLexer::Operand() {
  SkipBlanks();
  if (AtRest()) return;
  const size_t end = LettersEnd(at_);
  if (end == at_) return Take(TokenKind::kJunk, RunEnd(at_));
  const bool constant = Upper(text_.substr(at_, end - at_)) == "K";
  if (end < text_.size() && static_cast<unsigned char>(text_[end]) >= 0x80) {
    return Take(TokenKind::kJunk, RunEnd(at_));
  }
  Take(TokenKind::kClass, end);
  const size_t next = std::min(text_.find_first_not_of(" \t", at_), text_.size());
  if (next == text_.size() || text_[next] == ';' || text_[next] == '*') return;
  if (!constant && !IsDigit(text_[next])) {
    // What is attached belongs to it, what stands after a blank is a comment.
    if (next == at_) Take(TokenKind::kJunk, RunEnd(at_));
    return;
  }
  at_ = next;
  Number();
}

void LineLexer::Number() { Take(TokenKind::kNumber, RunEnd(at_)); }

void LineLexer::Target() {
  const size_t end = RunEnd(at_);
  const std::string run = Upper(text_.substr(at_, end - at_));
  const std::string_view letters = std::string_view(run).substr(0, 2);
  const std::string_view behind = std::string_view(run).substr(letters.size());
  if (IsModuleClass(letters) && std::ranges::all_of(behind, IsDigit)) return Operand();
  Take(TokenKind::kTarget, end);
}

}  // namespace plcxx::prostep
