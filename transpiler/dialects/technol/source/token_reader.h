// The tokens of one statement, read from left to right.
#pragma once

#include <span>
#include <string_view>

#include "transpiler/dialects/technol/source/lexer.h"

namespace plcxx::technol {

class TokenReader {
 public:
  /// `tokens` without a comment.
  explicit TokenReader(std::span<const Token> tokens) : tokens_(tokens) {}

  bool AtEnd() const { return at_ >= tokens_.size(); }
  /// The token `ahead` of the next one; null after the end.
  const Token* Peek(size_t ahead = 0) const { return at_ + ahead < tokens_.size() ? &tokens_[at_ + ahead] : nullptr; }
  const Token& Take() { return tokens_[at_++]; }
  bool IsPunctuation(char c, size_t ahead = 0) const {
    const Token* token = Peek(ahead);
    return token != nullptr && token->kind == TokenKind::kPunctuation && token->text.front() == c;
  }
  bool TakePunctuation(char c) {
    if (!IsPunctuation(c)) return false;
    ++at_;
    return true;
  }
  bool IsWord(std::string_view upper, size_t ahead = 0) const {
    const Token* token = Peek(ahead);
    return token != nullptr && token->kind == TokenKind::kWord && Means(token->text, upper);
  }
  bool TakeWord(std::string_view upper) {
    if (!IsWord(upper)) return false;
    ++at_;
    return true;
  }
  bool IsKind(TokenKind kind, size_t ahead = 0) const {
    const Token* token = Peek(ahead);
    return token != nullptr && token->kind == kind;
  }

  size_t position() const { return at_; }
  void Return(size_t position) { at_ = position; }
  void TakeRest() { at_ = tokens_.size(); }
  /// From token `first` to the one before the next; the place after the last token when nothing has been read since.
  source::Range RangeFrom(size_t first) const {
    if (tokens_.empty()) return {};
    if (first >= tokens_.size()) return EndOf(tokens_.back().range);
    const size_t last = at_ > first ? at_ - 1 : first;
    return {tokens_[first].range.begin, tokens_[last].range.end};
  }
  /// Where the next token is, or the place after the last one.
  source::Range Here() const { return AtEnd() && !tokens_.empty() ? EndOf(tokens_.back().range) : RangeFrom(at_); }
  /// The text from token `first` to the one before the next, blanks as between words.
  std::string TextFrom(size_t first) const {
    std::string text;
    for (size_t i = first; i < at_ && i < tokens_.size(); ++i) {
      if (i > first && !tokens_[i].glued) text += ' ';
      text += tokens_[i].text;
    }
    return text;
  }

 private:
  static source::Range EndOf(source::Range range) { return {range.end, range.end}; }

  std::span<const Token> tokens_;
  size_t at_ = 0;
};

}  // namespace plcxx::technol
