#include "transpiler/dialects/hnc/source/c_words.h"

#include <algorithm>

#include "transpiler/dialects/hnc/machine/machine.h"

namespace plcxx::hnc {
namespace {

using dialects::EditorToken;
using dialects::TokenRole;

/// Sorted.
constexpr std::string_view kKeywords[] = {"asm",     "auto",     "break",  "case",     "char",   "const",    "continue",
                                          "default", "do",       "double", "else",     "enum",   "extern",   "float",
                                          "for",     "goto",     "if",     "int",      "long",   "register", "return",
                                          "short",   "signed",   "sizeof", "static",   "struct", "switch",   "typedef",
                                          "union",   "unsigned", "void",   "volatile", "while"};

bool IsNameStart(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }

class CReader {
 public:
  explicit CReader(const source::File& file) : text_(file.text), base_(file.base) {}

  std::vector<EditorToken> Run() {
    while (at_ < text_.size()) Step();
    return std::move(tokens_);
  }

 private:
  bool Starts(std::string_view with) const { return std::string_view(text_).substr(at_).starts_with(with); }

  void Add(size_t end, TokenRole role) {
    tokens_.push_back({{base_ + static_cast<source::Offset>(at_), base_ + static_cast<source::Offset>(end)}, role});
    at_ = end;
  }

  size_t EndOfLine() const { return std::min(text_.find_first_of("\r\n", at_), text_.size()); }

  /// Up to the closing quote, or the end of the line where there is none.
  size_t EndOfText(char quote) const {
    size_t end = at_ + 1;
    while (end < text_.size() && text_[end] != quote && text_[end] != '\n') end += text_[end] == '\\' ? 2 : 1;
    return std::min(end + (end < text_.size() && text_[end] == quote ? 1 : 0), text_.size());
  }

  size_t EndOfName() const {
    size_t end = at_;
    while (end < text_.size() && (IsNameStart(text_[end]) || IsDigit(text_[end]))) ++end;
    return end;
  }

  void Step() {
    const char c = text_[at_];
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
      ++at_;
    } else if (Starts("//")) {
      Add(EndOfLine(), TokenRole::kComment);
    } else if (Starts("/*")) {
      const size_t end = text_.find("*/", at_ + 2);
      Add(end == std::string::npos ? text_.size() : end + 2, TokenRole::kComment);
    } else if (c == '"' || c == '\'') {
      Add(EndOfText(c), TokenRole::kText);
    } else if (c == '#') {
      Directive();
    } else if (IsDigit(c)) {
      size_t end = at_;
      while (end < text_.size() && (IsNameStart(text_[end]) || IsDigit(text_[end]) || text_[end] == '.')) ++end;
      Add(end, TokenRole::kNumber);
    } else if (IsNameStart(c)) {
      const size_t end = EndOfName();
      Add(end, RoleOfName(std::string_view(text_).substr(at_, end - at_)));
    } else {
      const bool arrow = Starts("->");
      member_ = arrow || c == '.';
      Add(at_ + (arrow ? 2 : 1), TokenRole::kOperator);
      return;
    }
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') member_ = false;
  }

  TokenRole RoleOfName(std::string_view name) const {
    if (std::ranges::binary_search(kKeywords, name)) return TokenRole::kKeyword;
    if (member_) return TokenRole::kMember;
    return FindSystemFunction(name) != nullptr ? TokenRole::kFunction : TokenRole::kName;
  }

  void Directive() {
    size_t end = at_ + 1;
    while (end < text_.size() && (text_[end] == ' ' || text_[end] == '\t')) ++end;
    while (end < text_.size() && IsNameStart(text_[end])) ++end;
    const bool is_include = std::string_view(text_).substr(at_, end - at_).ends_with("include");
    Add(end, TokenRole::kKeyword);
    if (!is_include) return;
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    if (at_ < text_.size() && text_[at_] == '<') {
      const size_t close = std::min(text_.find('>', at_), EndOfLine());
      Add(std::min(close + 1, EndOfLine()), TokenRole::kText);
    }
  }

  const std::string& text_;
  source::Offset base_;
  size_t at_ = 0;
  bool member_ = false;  // after '.' or '->'
  std::vector<EditorToken> tokens_;
};

}  // namespace

std::span<const std::string_view> CKeywords() { return kKeywords; }

std::vector<EditorToken> CWords(const source::File& file) { return CReader(file).Run(); }

}  // namespace plcxx::hnc
