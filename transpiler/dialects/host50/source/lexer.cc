#include "transpiler/dialects/host50/source/lexer.h"

#include <iterator>

#include "transpiler/dialects/host50/source/token_reader.h"

namespace plcxx::host50 {
namespace {

constexpr std::string_view kPartNames[] = {"TITLE", "SYMBOLS", "ALARMS", "MCODES", "FAST", "SLOW", "SUB", "LADDER"};
constexpr std::string_view kEndPrefix = "END_";

bool HasExpression(std::string_view mnemonic) {
  const auto known = MnemonicByName(mnemonic);
  if (!known) return false;
  const InstructionInfo& info = Info(known->op);
  return info.operand_count == 1 &&
         (info.operands[0] == OperandRole::kComparison || info.operands[0] == OperandRole::kAssignment);
}

bool HasText(std::string_view mnemonic) {
  const auto known = MnemonicByName(mnemonic);
  return known && Info(known->op).operand_count == 1 && Info(known->op).operands[0] == OperandRole::kText;
}

class Lexer {
 public:
  Lexer(const source::File& file, source::FileId id)
      : text_(file.text), base_(file.base), starts_(file.line_starts), reader_(text_, base_, result_.tokens) {
    result_.file = id;
  }

  LexedFile Run() {
    while (line_ < starts_.size()) {
      Open();
      if (in_drawing_ && IsRow()) {
        AddRow();
      } else {
        AddStatement();
      }
    }
    return std::move(result_);
  }

 private:
  size_t EndOfLine(size_t line) const {
    size_t end = line + 1 < starts_.size() ? starts_[line + 1] : text_.size();
    if (end > starts_[line] && text_[end - 1] == '\n') --end;
    if (end > starts_[line] && text_[end - 1] == '\r') --end;
    return end;
  }

  /// The next physical line.
  void Open() {
    reader_.SetBounds(starts_[line_], EndOfLine(line_));
    ++line_;
  }

  source::Range RangeOf(size_t begin, size_t end) const {
    return {base_ + static_cast<source::Offset>(begin), base_ + static_cast<source::Offset>(end)};
  }

  bool IsRow() const {
    const size_t begin = starts_[line_ - 1];
    const std::string_view word = FirstWord(text_.substr(begin, EndOfLine(line_ - 1) - begin));
    return !EqualIgnoringCase(word, "NETWORK") && !PartByEnd(word);
  }

  void AddRow() {
    const size_t begin = reader_.at();
    reader_.SkipToStop();
    Line line;
    line.kind = LineKind::kRow;
    line.tokens = {static_cast<uint32_t>(result_.tokens.size()), 1};
    reader_.Add(TokenKind::kRow, begin);
    line.range = RangeOf(begin, reader_.at());
    result_.lines.push_back(line);
  }

  /// At the next token of the statement; false at its end. A '\' goes on in the next line.
  bool Advance() {
    for (;;) {
      reader_.SkipBlanks();
      if (reader_.AtStop() || reader_.Peek() == ';') return false;
      if (!reader_.AtContinuation()) return true;
      if (line_ >= starts_.size()) {
        reader_.SkipToStop();
        return false;
      }
      Open();
      if (continued_ == 0) continued_ = reader_.at();
    }
  }

  void AddStatement() {
    in_drawing_ = false;
    continued_ = 0;
    const size_t first_line = line_ - 1;
    const auto first = static_cast<uint32_t>(result_.tokens.size());
    Line line;
    if (Advance()) {
      reader_.ReadFirst();
      ReadRest(first);
    }
    line.tokens = {first, static_cast<uint32_t>(result_.tokens.size()) - first};
    if (reader_.Peek() == ';') {
      const size_t begin = reader_.at();
      reader_.SkipToStop();
      size_t end = reader_.at();
      while (end > begin + 1 && IsBlank(text_[end - 1])) --end;
      line.comment = RangeOf(begin, end);
      line.kind = LineKind::kComment;
    }
    if (line.tokens.count > 0) {
      line.kind = LineKind::kStatement;
      line.range = {result_.tokens[first].range.begin, result_.tokens.back().range.end};
    }
    if (continued_ != 0) {
      line.continuation.first = RangeOf(starts_[first_line], EndOfLine(first_line));
      line.continuation.rest = RangeOf(continued_, EndOfLine(line_ - 1));
    }
    result_.lines.push_back(line);
  }

  void ReadRest(uint32_t first) {
    const Token& token = result_.tokens[first];
    const std::string_view word = token.kind == TokenKind::kWord ? TextOf(token) : std::string_view();
    in_drawing_ = EqualIgnoringCase(word, Name(PartKind::kLadder));
    if (HasText(word)) {
      reader_.SkipBlanks();
      if (reader_.Peek() != '"') return ReadText();
    }
    if (HasExpression(word)) {
      if (Advance() && reader_.Peek() == '"') {
        reader_.ReadQuotedExpression();
      } else {
        while (Advance()) reader_.ReadExpressionToken();
      }
    }
    while (Advance()) reader_.ReadOperand();
  }

  /// Of a REMARK: up to the end of the physical line, whatever stands there.
  void ReadText() {
    const size_t begin = reader_.at();
    reader_.SkipToStop();
    size_t end = reader_.at();
    while (end > begin && IsBlank(text_[end - 1])) --end;
    if (end > begin) reader_.AddRange(TokenKind::kText, begin, end);
  }

  std::string_view TextOf(const Token& token) const {
    return text_.substr(token.range.begin - base_, token.range.end - token.range.begin);
  }

  std::string_view text_;
  source::Offset base_;
  const std::vector<uint32_t>& starts_;
  LexedFile result_;
  TokenReader reader_;
  size_t line_ = 0;       // the next physical line
  size_t continued_ = 0;  // where the second physical line of the statement begins; 0: it has none
  bool in_drawing_ = false;
};

}  // namespace

std::string_view FirstWord(std::string_view line) {
  size_t begin = 0;
  while (begin < line.size() && IsBlank(line[begin])) ++begin;
  size_t end = begin;
  while (end < line.size() && IsWordCharacter(line[end])) ++end;
  return line.substr(begin, end - begin);
}

std::string_view Name(PartKind part) { return kPartNames[static_cast<size_t>(part)]; }

std::optional<PartKind> PartByName(std::string_view word) {
  for (size_t i = 0; i < std::size(kPartNames); ++i) {
    if (EqualIgnoringCase(kPartNames[i], word)) return static_cast<PartKind>(i);
  }
  return std::nullopt;
}

std::optional<PartKind> PartByEnd(std::string_view word) {
  if (!EqualIgnoringCase(word.substr(0, kEndPrefix.size()), kEndPrefix)) return std::nullopt;
  return PartByName(word.substr(kEndPrefix.size()));
}

LexedFile Lex(const source::SourceManager& sources, source::FileId file) {
  return Lexer(sources.Get(file), file).Run();
}

std::vector<Token> LexElement(const source::File& file, source::Range range, ElementKind kind) {
  std::vector<Token> tokens;
  TokenReader reader(file.text, file.base, tokens);
  reader.SetBounds(range.begin - file.base, range.end - file.base);
  reader.SkipBlanks();
  bool expression = false;
  if (kind == ElementKind::kBlock && !reader.AtStop()) {
    const size_t begin = reader.at();
    reader.ReadFirst();
    expression = HasExpression(std::string_view(file.text).substr(begin, reader.at() - begin));
    reader.SkipBlanks();
    if (expression && reader.Peek() == '"') {
      reader.ReadQuotedExpression();
      expression = false;
    }
  }
  for (reader.SkipBlanks(); !reader.AtStop(); reader.SkipBlanks()) {
    expression ? reader.ReadExpressionToken() : reader.ReadOperand();
  }
  return tokens;
}

}  // namespace plcxx::host50
