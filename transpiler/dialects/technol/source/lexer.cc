#include "transpiler/dialects/technol/source/lexer.h"

#include <algorithm>

#include "transpiler/source/characters.h"

namespace plcxx::technol {
namespace {

constexpr std::string_view kPunctuation = ":,.[]()<>+-*/=&\\";
constexpr std::string_view kTitles[] = {"TITLE", "PAGE", "SUBTTL", "NAME"};
constexpr std::string_view kIncludes[] = {"T_INCLUDE", "INCLUDE"};

bool IsLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

class LineLexer {
 public:
  LineLexer(std::string_view text, const LinePlace& place, std::vector<Token>& tokens)
      : text_(text), place_(place), tokens_(tokens), first_(tokens.size()) {}

  void Run() {
    while (at_ < text_.size()) {
      if (IsBlank(text_[at_])) {
        ++at_;
      } else {
        TakeToken();
      }
    }
  }

 private:
  void TakeToken() {
    const char c = text_[at_];
    if (c == ';') return TakeComment();
    if (IsNameStart(c)) {
      Add(TokenKind::kWord, WordEnd());
      return TakeRestOfDirective();
    }
    if (IsDigit(c)) return Add(TokenKind::kNumber, WordEnd());
    if (c == '\'' || c == '"') return TakeQuoted(c);
    if (kPunctuation.find(c) != std::string_view::npos) return Add(TokenKind::kPunctuation, at_ + 1);
    Add(TokenKind::kInvalid, at_ + source::FirstCodePoint(text_.substr(at_)).length);
  }

  size_t WordEnd() const {
    size_t end = at_ + 1;
    while (end < text_.size() && IsNameCharacter(text_[end])) ++end;
    return end;
  }

  void TakeComment() {
    const std::string_view comment = TrimBlanks(text_.substr(at_));
    Add(TokenKind::kComment, at_ + comment.size());
    at_ = text_.size();
  }

  /// At least one character stands between the quotes, so ''' is a quote.
  void TakeQuoted(char quote) {
    const size_t end = at_ + 2 < text_.size() ? text_.find(quote, at_ + 2) : std::string_view::npos;
    if (end == std::string_view::npos) return Add(TokenKind::kOpenString, text_.size());
    Add(quote == '"' ? TokenKind::kQuoted : TokenKind::kString, end + 1);
  }

  /// Paths and titles are no tokens of the language.
  void TakeRestOfDirective() {
    const size_t count = tokens_.size() - first_;
    if (count != 1 && (count != 3 || tokens_[first_ + 1].text != ":")) return;
    const std::string_view word = tokens_.back().text;
    const auto means = [word](std::string_view directive) { return Means(word, directive); };
    if (std::ranges::any_of(kTitles, means)) {
      SkipBlanks();
      if (at_ < text_.size()) Add(TokenKind::kText, text_.size());
    } else if (std::ranges::any_of(kIncludes, means)) {
      SkipBlanks();
      if (at_ >= text_.size() || text_[at_] == ';' || text_[at_] == '\'' || text_[at_] == '"') return;
      size_t end = at_;
      while (end < text_.size() && !IsBlank(text_[end]) &&
             std::string_view(";'\"").find(text_[end]) == std::string::npos) {
        ++end;
      }
      Add(TokenKind::kPath, end);
    }
  }

  void SkipBlanks() {
    while (at_ < text_.size() && IsBlank(text_[at_])) ++at_;
  }

  void Add(TokenKind kind, size_t end) {
    Token token{.kind = kind, .glued = at_ > 0 && last_end_ == at_, .text = text_.substr(at_, end - at_)};
    token.range = place_.call;
    if (place_.call.begin == place_.call.end) {
      token.range = {place_.begin + static_cast<source::Offset>(at_), place_.begin + static_cast<source::Offset>(end)};
    }
    tokens_.push_back(token);
    at_ = last_end_ = end;
  }

  std::string_view text_;
  const LinePlace& place_;
  std::vector<Token>& tokens_;
  size_t first_;
  size_t at_ = 0;
  size_t last_end_ = 0;
};

}  // namespace

std::string_view Name(TokenKind kind) {
  switch (kind) {
    case TokenKind::kWord:
      return "word";
    case TokenKind::kNumber:
      return "number";
    case TokenKind::kString:
      return "string";
    case TokenKind::kQuoted:
      return "quoted";
    case TokenKind::kOpenString:
      return "open-string";
    case TokenKind::kPunctuation:
      return "punctuation";
    case TokenKind::kPath:
      return "path";
    case TokenKind::kText:
      return "text";
    case TokenKind::kComment:
      return "comment";
    case TokenKind::kInvalid:
      return "invalid";
  }
  return "";
}

void LexLine(std::string_view text, const LinePlace& place, std::vector<Token>& tokens) {
  LineLexer(text, place, tokens).Run();
}

bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v' || c == '\r' || c == '\n'; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsNameStart(char c) { return IsLetter(c) || c == '_' || c == '?' || c == '@'; }
bool IsNameCharacter(char c) { return IsNameStart(c) || IsDigit(c); }

std::string Upper(std::string_view text) {
  std::string upper(text);
  for (char& c : upper) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return upper;
}

bool Means(std::string_view text, std::string_view upper) {
  return std::ranges::equal(text, upper,
                            [](char a, char b) { return a == b || (a >= 'a' && a <= 'z' && a - 'a' + 'A' == b); });
}

std::string_view TrimBlanks(std::string_view text) {
  while (!text.empty() && IsBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && IsBlank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace plcxx::technol
