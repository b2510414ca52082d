// Reads the tokens of one physical line of dialect host50, from left to right. Only the lexer includes it.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "transpiler/dialects/host50/machine/machine.h"
#include "transpiler/dialects/host50/source/tokens.h"
#include "transpiler/source/characters.h"

namespace plcxx::host50 {

/// How operands are read: a bare symbol ends at a delimiter, or (in COMP and OPRT) at anything but letters and digits.
enum class Reading : uint8_t { kOperands, kExpression };

constexpr bool IsBlank(char c) { return c == ' ' || c == '\t'; }
constexpr bool IsWordCharacter(char c) { return IsLetter(c) || IsDigit(c) || c == '_'; }

class TokenReader {
 public:
  /// `text` begins at a file's first character, which has the offset `base`.
  TokenReader(std::string_view text, source::Offset base, std::vector<Token>& tokens)
      : text_(text), base_(base), tokens_(tokens) {}

  /// What is read from now on; `stop` is the end of a line or of a part of it.
  void SetBounds(size_t begin, size_t stop) {
    at_ = begin;
    stop_ = stop;
  }
  size_t at() const { return at_; }
  bool AtStop() const { return at_ >= stop_; }
  /// A line end where nothing is left.
  char Peek(size_t ahead = 0) const { return at_ + ahead < stop_ ? text_[at_ + ahead] : '\n'; }
  void SkipBlanks() {
    while (at_ < stop_ && IsBlank(text_[at_])) ++at_;
  }
  void SkipToStop() { at_ = stop_; }
  /// '\\' with nothing after it but blanks.
  bool AtContinuation() const;

  /// A token from `begin` to where the reader is.
  void Add(TokenKind kind, size_t begin) { AddRange(kind, begin, at_); }
  void AddRange(TokenKind kind, size_t begin, size_t end);

  // Each of these reads at least one character; the reader is neither at a blank nor at its stop.
  void ReadFirst();  // of a statement: a mnemonic or keyword ends where its letters end
  void ReadOperand();
  void ReadExpressionToken();
  void ReadQuotedExpression();  // the argument of COMP or OPRT in its quotes

 private:
  bool StartsNumber(size_t ahead) const {
    return IsDigit(Peek(ahead)) || (Peek(ahead) == '.' && IsDigit(Peek(ahead + 1)));
  }
  source::CodePoint CodePoint() const { return source::FirstCodePoint(text_.substr(at_, stop_ - at_)); }
  bool AtNameStart() const;
  /// Letters, marks and digits of any script, '_'; among operands and in quotes also + - / . #
  bool AtNameCharacter(Reading reading) const;
  bool AtOperandEnd() const;
  void ReadNumber(size_t sign);
  void ReadOther(Reading reading);
  void ReadName(Reading reading);
  void ReadAddress(Reading reading);
  void ReadAttribute();
  void ReadQuotedSymbol();
  void ReadString();

  std::string_view text_;
  source::Offset base_;
  std::vector<Token>& tokens_;
  size_t at_ = 0;
  size_t stop_ = 0;
};

}  // namespace plcxx::host50
