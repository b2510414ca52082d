#include "transpiler/dialects/hnc/source/source_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <iterator>
#include <optional>
#include <utility>

#include "transpiler/dialects/hnc/syntax/characters.h"
#include "transpiler/source/characters.h"
#include "transpiler/source/decode.h"

namespace plcxx::hnc {
namespace {

bool IsAsciiByte(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// The ASCII character whose full-width form `c` is; 0 for others. Quotes and angle brackets of Chinese typography
/// count as such forms (specification 2.2).
char AsciiOfFullWidth(char32_t c) {
  constexpr char32_t kFirst = 0xFF01, kLast = 0xFF5E, kDistance = 0xFEE0;
  if (c >= kFirst && c <= kLast) return static_cast<char>(c - kDistance);
  switch (c) {
    case 0x3000:
      return ' ';
    case 0x3008:
      return '<';
    case 0x3009:
      return '>';
    case 0x201C:
    case 0x201D:
      return '"';
    case 0x2018:
    case 0x2019:
      return '\'';
    default:
      return 0;
  }
}

/// What a comment says: without its marks, and without blanks and stars that only draw a frame.
std::string CommentText(std::string_view comment) {
  const bool block = comment.starts_with("/*");
  comment.remove_prefix(std::min<size_t>(2, comment.size()));
  if (block && comment.ends_with("*/")) comment.remove_suffix(2);
  std::string text;
  while (true) {
    const size_t end = std::min(comment.find('\n'), comment.size());
    std::string_view line = comment.substr(0, end);
    while (!line.empty() && (IsLineBlank(line.back()) || line.back() == '\r' || line.back() == '*'))
      line.remove_suffix(1);
    size_t start = 0;
    while (start < line.size() && (IsLineBlank(line[start]) || line[start] == '*')) ++start;
    line.remove_prefix(start);
    if (!line.empty()) {
      if (!text.empty()) text += '\n';
      text += line;
    }
    if (end == comment.size()) break;
    comment.remove_prefix(end + 1);
  }
  return text;
}

/// Goes once through the text; `at_` is the place in the file's text, everything written goes to `out_.text`.
class Rewriter {
 public:
  Rewriter(const source::File& file, source::FileId id) : file_(file), text_(file.text) {
    out_.file = id;
    out_.base = file.base;
    out_.size = static_cast<source::Offset>(text_.size());
    out_.name = file.path.substr(file.path.find_last_of("/\\") + 1);
    out_.text.reserve(text_.size() + text_.size() / 8);
    out_.map.push_back({0, 0});
  }

  /// False: one of the parts is within something else than code.
  bool RunWithout(std::vector<LeftOutText>& parts) {
    for (LeftOutText& part : parts) {
      while (at_ < part.begin) Step();
      if (at_ != part.begin) return false;
      LeaveOut(part);
    }
    return true;
  }
  SourceText Run() {
    while (at_ < text_.size()) Step();
    if (!out_.text.ends_with('\n')) Put('\n');
    return std::move(out_);
  }

 private:
  char Peek(size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  source::Range Here(size_t length) const {
    const source::Offset begin = out_.base + static_cast<source::Offset>(at_);
    return {begin, begin + static_cast<source::Offset>(length)};
  }

  void Put(char c) { out_.text += c; }
  /// From here on the rewritten text corresponds to `at_` again.
  void Mark() {
    const SourceText::Stretch stretch{static_cast<uint32_t>(out_.text.size()), static_cast<uint32_t>(at_)};
    const SourceText::Stretch& last = out_.map.back();
    if (stretch.at - last.at == stretch.original - last.original) return;
    if (last.at == stretch.at) {
      out_.map.back() = stretch;
    } else {
      out_.map.push_back(stretch);
    }
  }
  void Copy(size_t count) {
    out_.text.append(text_, at_, count);
    at_ += count;
  }

  size_t LineEnd(size_t ahead = 0) const {
    if (Peek(ahead) == '\n') return 1;
    if (Peek(ahead) != '\r') return 0;
    return Peek(ahead + 1) == '\n' ? 2 : 1;
  }
  void CopyLineEnd() {
    at_ += LineEnd();
    Put('\n');
    Mark();
  }
  bool AtSplice() const { return Peek() == '\\' && LineEnd(1) != 0; }
  void CopySplice() {
    Copy(1);
    CopyLineEnd();
  }
  /// From a backslash on, how many backslashes and blanks are left of the line, the last one a blank; 0: something else
  /// is. No splice here, but the C parser would take the last backslash for one, and then perhaps the one before it.
  size_t BlankedBackslashes() {
    if (Peek() != '\\' || at_ < not_blanked_before_) return 0;
    size_t length = 1;
    while (Peek(length) == '\\' || IsLineBlank(Peek(length))) ++length;
    const bool ends = at_ + length >= text_.size() || LineEnd(length) != 0;
    if (ends && IsLineBlank(Peek(length - 1))) return length;
    not_blanked_before_ = at_ + length;
    return 0;
  }
  void PutBlanks(size_t count) {
    out_.text.append(count, ' ');
    at_ += count;
  }

  bool WasReplaced() const { return std::ranges::binary_search(file_.replaced, static_cast<uint32_t>(at_)); }

  void LeaveOut(LeftOutText& part);
  void Step();
  void CodeCharacter();
  void BlankedBackslash(size_t length);
  void ForeignCharacter();
  void Word();
  void Directive();
  void RestOfLine();
  void IncludeLine();
  void PragmaLine();
  void LineLine();
  void LineComment();
  void BlockComment();
  void KeepComment(size_t begin);
  void WarnOfTrailByte(size_t comment_end);
  void String();
  void CharacterConstant();
  std::optional<uint8_t> Escape(size_t& length) const;
  std::string CharacterBytes(size_t length) const;

  const source::File& file_;
  std::string_view text_;
  size_t at_ = 0;
  size_t not_blanked_before_ = 0;  // a run of backslashes and blanks up to there does not end the line
  bool line_start_ = true;         // nothing but blanks and comments on the logical line so far
  bool in_directive_ = false;
  size_t foreign_end_ = SIZE_MAX;  // where the last reported run of foreign characters ended
  SourceText out_;
};

void Rewriter::LeaveOut(LeftOutText& part) {
  for (; at_ < part.end; ++at_) {
    const size_t end = std::min(text_.find_first_of("\r\n", at_), size_t{part.end});
    at_ = end;
    if (end == part.end) break;
    if (LineEnd() == 2) ++at_;
    Put('\n');
  }
  Mark();
  std::ranges::move(part.comments, std::back_inserter(out_.comments));
}

void Rewriter::Step() {
  if (LineEnd() != 0) {
    CopyLineEnd();
    line_start_ = true;
    in_directive_ = false;
  } else if (AtSplice()) {
    CopySplice();
  } else if (Peek() == '/' && Peek(1) == '/') {
    LineComment();
  } else if (Peek() == '/' && Peek(1) == '*') {
    BlockComment();
  } else if (IsLineBlank(Peek())) {
    Copy(1);
  } else if (Peek() == '#' && line_start_) {
    line_start_ = false;
    Directive();
  } else {
    line_start_ = false;
    CodeCharacter();
  }
}

void Rewriter::CodeCharacter() {
  const char c = Peek();
  if (c == '"') return String();
  if (c == '\'') return CharacterConstant();
  if (IsWord(c)) return Word();
  if (const size_t length = BlankedBackslashes(); length != 0) return BlankedBackslash(length);
  // In an argument of a macro that becomes a text it is one character of it. What is left of it is no token (2.2).
  if (c == '\\' && Peek(1) != 'u' && Peek(1) != 'U') return Copy(1);
  const bool is_control = static_cast<unsigned char>(c) < ' ' || c == '\x7F';
  if (!IsAsciiByte(c) || is_control || c == '$' || c == '@' || c == '`' || c == '\\') return ForeignCharacter();
  Copy(1);
}

void Rewriter::Word() {
  while (IsWord(Peek())) Copy(1);
}

/// The line was to go on, so it does: one message. In a group that is left out it does not, and nobody continues a line
/// with a directive.
void Rewriter::BlankedBackslash(size_t length) {
  const source::Range range = Here(1);
  out_.findings
      .Report(range, diag::HncCharacterForeign, "\\", source::CodePointName('\\'),
              "a line goes on only where the backslash is its last character: delete the blanks behind it")
      .fixits.push_back({{range.end, range.begin + static_cast<source::Offset>(length)}, ""});
  size_t next = at_ + length;
  if (next < text_.size()) next += LineEnd(length);
  while (next < text_.size() && IsLineBlank(text_[next])) ++next;
  if (next >= text_.size() || text_[next] == '#') return PutBlanks(length);
  Copy(1);
  at_ += length - 1;
  Mark();
  CopyLineEnd();
}

void Rewriter::ForeignCharacter() {
  const source::CodePoint character = source::FirstCodePoint(text_.substr(at_));
  const source::Range range = Here(character.length);
  const std::string shown(text_.substr(at_, character.length));
  const char ascii = AsciiOfFullWidth(character.value);
  const bool goes_on = foreign_end_ == at_;  // a word is one fault
  if (ascii != 0) {
    out_.findings.Report(range, diag::HncFullWidth, shown, std::string(1, ascii))
        .fixits.push_back({range, std::string(1, ascii)});
  } else if (WasReplaced()) {
    if (!goes_on) out_.findings.Report(range, diag::HncUndefinedByte, source::Name(file_.encoding));
  } else if (!goes_on) {
    const bool is_control = character.value < ' ' || character.value == 0x7F;
    out_.findings.Report(range, diag::HncCharacter, is_control ? std::string_view("?") : std::string_view(shown),
                         source::CodePointName(character.value));
  }
  at_ += character.length;
  if (ascii == 0) foreign_end_ = at_;
  const bool opens_literal = ascii == '"' || ascii == '\'';
  Put(ascii == 0 || opens_literal ? ' ' : ascii);
  Mark();
}

void Rewriter::Directive() {
  in_directive_ = true;
  Copy(1);
  while (IsLineBlank(Peek()) || AtSplice()) AtSplice() ? CopySplice() : Copy(1);
  const size_t begin = at_;
  Word();
  const std::string_view name = text_.substr(begin, at_ - begin);
  if (name == "error") return RestOfLine();
  if (name == "include") return IncludeLine();
  if (name == "pragma") return PragmaLine();
  if (name == "line") return LineLine();
}

/// Free text up to the end of the logical line or a comment.
void Rewriter::RestOfLine() {
  while (at_ < text_.size() && LineEnd() == 0) {
    if (Peek() == '/' && (Peek(1) == '/' || Peek(1) == '*')) return;
    if (const size_t length = BlankedBackslashes(); length != 0) return PutBlanks(length);
    AtSplice() ? CopySplice() : Copy(1);
  }
}

/// The name in quotes or angle brackets as it is: a backslash in it separates folders.
void Rewriter::IncludeLine() {
  while (IsLineBlank(Peek())) Copy(1);
  const char close = Peek() == '<' ? '>' : Peek() == '"' ? '"' : '\0';
  if (close == '\0') return;
  const size_t end = text_.find_first_of(std::string{close, '\r', '\n'}, at_ + 1);
  if (end == std::string_view::npos || text_[end] != close) return;
  for (; at_ <= end; ++at_) Put(Peek() == '\\' ? '/' : Peek());
}

void Rewriter::PragmaLine() {
  const size_t begin = at_, out_begin = out_.text.size();
  RestOfLine();
  // What is passed over may have any words in it: "it's".
  std::replace_if(
      out_.text.begin() + static_cast<std::ptrdiff_t>(out_begin), out_.text.end(),
      [](char c) { return c == '\'' || c == '"'; }, ' ');
  std::string_view words = text_.substr(begin, at_ - begin);
  const size_t option = words.find_first_not_of(" \t");
  if (option == std::string_view::npos || !words.substr(option).starts_with("option")) return;
  const size_t key = words.find("-K", option);
  if (key == std::string_view::npos || IsWord(key + 2 < words.size() ? words[key + 2] : ' ')) return;
  out_.unsigned_char.push_back(out_.base + static_cast<source::Offset>(begin));
}

/// #line number "name"; what has another form is the C parser's to refuse, and so are other numbers.
void Rewriter::LineLine() {
  constexpr uint32_t kMostLines = 32767;
  const size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  std::string_view words = text_.substr(at_, end - at_);
  words.remove_prefix(std::min(words.find_first_not_of(" \t"), words.size()));
  SourceText::LineDirective directive;
  const auto read = std::from_chars(words.data(), words.data() + words.size(), directive.line);
  if (read.ec != std::errc{} || directive.line == 0 || directive.line > kMostLines) return;
  const size_t open = words.find('"');
  const size_t close = open == std::string_view::npos ? open : words.find('"', open + 1);
  if (close != std::string_view::npos) directive.name = words.substr(open + 1, close - open - 1);
  const size_t line_end = end + (text_.substr(end).starts_with("\r\n") ? 2 : 1);
  directive.at = static_cast<uint32_t>(std::min(line_end, text_.size()));
  out_.line_directives.push_back(std::move(directive));
}

void Rewriter::KeepComment(size_t begin) {
  const source::Range range{out_.base + static_cast<source::Offset>(begin),
                            out_.base + static_cast<source::Offset>(at_)};
  out_.comments.push_back({range, CommentText(text_.substr(begin, at_ - begin))});
}

void Rewriter::LineComment() {
  const size_t begin = at_;
  while (at_ < text_.size() && LineEnd() == 0) {
    if (AtSplice()) {
      out_.findings.Report(Here(1), diag::HncCommentContinues);
      CopySplice();
    } else if (const size_t length = BlankedBackslashes(); length != 0) {
      PutBlanks(length);
    } else {
      Copy(1);
    }
  }
  KeepComment(begin);
  WarnOfTrailByte(begin);
}

/// The original compiler splices bytes: a character at the end of a comment may hold a backslash (D4).
void Rewriter::WarnOfTrailByte(size_t comment_begin) {
  if (file_.encoding != source::Encoding::kGb18030 || LineEnd() == 0) return;
  size_t last = at_ - 1;
  while (last > comment_begin && (static_cast<unsigned char>(text_[last]) & 0xC0) == 0x80) --last;
  const std::string_view character = text_.substr(last, at_ - last);
  if (character.empty() || IsAsciiByte(character.front())) return;
  if (!source::EncodeGb18030(character).ends_with('\\')) return;
  const source::Offset begin = out_.base + static_cast<source::Offset>(last);
  out_.findings.Report({begin, begin + static_cast<source::Offset>(character.size())}, diag::HncCommentCharacter,
                       character);
}

void Rewriter::BlockComment() {
  const size_t begin = at_;
  Copy(2);
  while (at_ < text_.size()) {
    if (Peek() == '*' && Peek(1) == '/') {
      Copy(2);
      KeepComment(begin);
      return;
    }
    if (const size_t length = BlankedBackslashes(); length != 0) PutBlanks(length);  // between '*' and '/' it matters
    LineEnd() != 0 ? CopyLineEnd() : Copy(1);
  }
  KeepComment(begin);  // without an end: the C parser finds that, too
}

/// The bytes that the character at `at_` has in the file; what cannot be read is a question mark.
std::string Rewriter::CharacterBytes(size_t length) const {
  const std::string_view character = text_.substr(at_, length);
  return file_.encoding == source::Encoding::kGb18030 ? source::EncodeGb18030(character) : std::string(character);
}

void Rewriter::String() {
  Copy(1);
  while (at_ < text_.size() && LineEnd() == 0) {
    if (AtSplice()) {
      CopySplice();
    } else if (const size_t line_rest = BlankedBackslashes(); line_rest != 0) {
      PutBlanks(line_rest);
    } else if (Peek() == '\\' && Peek(1) != '\0' && IsAsciiByte(Peek(1))) {
      Copy(2);
    } else if (Peek() == '"') {
      Copy(1);
      return;
    } else if (IsAsciiByte(Peek())) {
      Copy(1);
    } else {
      const size_t length = source::FirstCodePoint(text_.substr(at_)).length;
      if (WasReplaced()) {
        out_.findings.Report(Here(length), diag::HncUndefinedByte, source::Name(file_.encoding));
        Put('?');
      } else {
        std::string bytes = CharacterBytes(length);
        // The second byte of a GBK character may be a backslash, which is no escape.
        if (bytes.ends_with('\\')) bytes.replace(bytes.size() - 1, 1, "\\134");
        out_.text += bytes;
      }
      at_ += length;
      Mark();
    }
  }
}

/// The value of the escape at `at_` and its length; none for one that the language does not have.
std::optional<uint8_t> Rewriter::Escape(size_t& length) const {
  constexpr std::string_view kLetters = "abfnrtv\\'\"?";
  constexpr std::string_view kValues = "\a\b\f\n\r\t\v\\'\"?";
  const size_t letter = kLetters.find(Peek(1));
  length = 2;
  if (letter != std::string_view::npos) return static_cast<uint8_t>(kValues[letter]);
  const bool hex = Peek(1) == 'x';
  const auto digit = [&](char c) -> int {
    if (c >= '0' && c <= '7') return c - '0';
    if (!hex || std::isxdigit(static_cast<unsigned char>(c)) == 0) return -1;
    return std::isdigit(static_cast<unsigned char>(c)) != 0 ? c - '0' : std::tolower(c) - 'a' + 10;
  };
  size_t count = hex ? 2 : 1;
  const size_t first = count;
  unsigned value = 0;
  while (digit(Peek(count)) >= 0 && (hex || count < 4)) {
    value = std::min(value * (hex ? 16U : 8U) + static_cast<unsigned>(digit(Peek(count))), 0xFFFFU);
    ++count;
  }
  length = std::max<size_t>(count, 2);
  if (count == first || value > 0xFF) return std::nullopt;
  return static_cast<uint8_t>(value);
}

void Rewriter::CharacterConstant() {
  const size_t begin = at_;
  std::string bytes;
  bool readable = true;  // else the C parser says what is wrong
  ++at_;
  while (at_ < text_.size() && LineEnd() == 0 && Peek() != '\'') {
    if (AtSplice()) {
      at_ += 1 + LineEnd(1);
      readable = false;
      continue;
    }
    size_t length = 1;
    if (Peek() == '\\') {
      const std::optional<uint8_t> value = Escape(length);
      readable = readable && value.has_value();
      bytes += static_cast<char>(value.value_or(0));
    } else if (IsAsciiByte(Peek())) {
      bytes += Peek();
    } else {
      length = source::FirstCodePoint(text_.substr(at_)).length;
      if (WasReplaced()) out_.findings.Report(Here(length), diag::HncUndefinedByte, source::Name(file_.encoding));
      bytes += CharacterBytes(length);
    }
    at_ += std::min(length, text_.size() - at_);
  }
  const bool closed = Peek() == '\'';
  if (closed) ++at_;
  const std::string_view written = text_.substr(begin, at_ - begin);
  const bool plain = std::ranges::all_of(written, IsAsciiByte);
  if (closed && bytes.size() > 2) {
    const source::Offset place = out_.base + static_cast<source::Offset>(begin);
    out_.findings.Report({place, place + static_cast<source::Offset>(written.size())}, diag::HncCharacterConstant,
                         written);
    out_.text += "'0'";
    // A line end inside stays one.
    for (size_t i = written.find('\n'); i != std::string_view::npos; i = written.find('\n', i + 1)) out_.text += "\\\n";
  } else if (closed && readable && (bytes.size() == 2 || !plain)) {
    // The C parser puts the first character into the high byte, the original compiler into the low one. In code that is
    // left to FilterTokens, since `#` of a macro wants what is written.
    const bool as_bytes = written.find('\\') == std::string_view::npos && bytes.find('\\') == std::string::npos;
    if (!in_directive_ && as_bytes) {
      out_.text += "'" + bytes + "'";
      return Mark();
    }
    std::ranges::reverse(bytes);
    Put('\'');
    for (const char byte : bytes) {
      std::array<char, 8> octal{};
      std::snprintf(octal.data(), octal.size(), "\\%03o", static_cast<unsigned>(static_cast<unsigned char>(byte)));
      out_.text += octal.data();
    }
    Put('\'');
  } else if (plain && closed) {
    for (const char c : written) {
      if (c != '\r') Put(c);
    }
  } else if (plain) {
    at_ = begin;
    Copy(1);
    while (at_ < text_.size() && LineEnd() == 0) {
      const size_t length = BlankedBackslashes();
      length != 0 ? PutBlanks(length) : AtSplice() ? CopySplice() : Copy(1);
    }
  } else {
    Put('\'');  // not closed
  }
  Mark();
}

}  // namespace

SourceText Rewrite(const source::SourceManager& sources, source::FileId file) {
  return Rewriter(sources.Get(file), file).Run();
}

std::optional<SourceText> RewriteWithout(const source::SourceManager& sources, source::FileId file,
                                         std::vector<LeftOutText> parts) {
  Rewriter rewriter(sources.Get(file), file);
  if (!rewriter.RunWithout(parts)) return std::nullopt;
  return rewriter.Run();
}

SourceText ProductText(std::string name, std::string text) {
  SourceText product;
  product.name = std::move(name);
  product.text = std::move(text);
  product.map.push_back({0, 0});
  return product;
}

}  // namespace plcxx::hnc
