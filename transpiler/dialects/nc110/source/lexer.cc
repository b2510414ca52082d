#include "transpiler/dialects/nc110/source/lexer.h"

namespace plcxx::nc110 {
namespace {

constexpr bool IsLineEnd(char c) { return c == '\n' || c == '\r'; }
constexpr bool IsAscii(char c) { return static_cast<unsigned char>(c) < 0x80; }
constexpr bool IsRunCharacter(char c) { return IsLetter(c) || IsDigit(c); }

TokenKind Punctuation(char c) {
  switch (c) {
#define NC110_SIGN(Key, Character, ...) \
  case Character:                       \
    return TokenKind::k##Key;
#include "transpiler/dialects/nc110/source/tokens.def"
    default:
      return TokenKind::kBad;
  }
}

/// A character that begins nothing: alone it is error 10.
bool IsIllegal(char c) {
  return IsAscii(c) && !IsRunCharacter(c) && !IsBlank(c) && !IsLineEnd(c) && c != ';' && c != '$' && c != '!' &&
         c != '"' && Punctuation(c) == TokenKind::kBad;
}

class Lexer {
 public:
  Lexer(const source::File& file, Homoglyphs homoglyphs, diag::Engine& diagnostics)
      : text_(file.text), base_(file.base), diagnostics_(diagnostics), homoglyphs_(homoglyphs, diagnostics) {}

  LexedFile Run() {
    result_.tokens.reserve(text_.size() / 3 + 1);
    while (at_ < text_.size()) {
      Next();
    }
    Add(TokenKind::kEndOfFile, at_);
    return std::move(result_);
  }

 private:
  char Peek(size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\n'; }
  bool AtLineEnd() const { return IsLineEnd(Peek()); }
  source::Range RangeFrom(size_t begin) const {
    return {base_ + static_cast<source::Offset>(begin), base_ + static_cast<source::Offset>(at_)};
  }

  Token& Add(TokenKind kind, size_t begin) {
    Token token;
    token.kind = kind;
    token.first_on_line = line_is_fresh_;
    token.range = RangeFrom(begin);
    line_is_fresh_ = false;
    line_ends_ = 0;
    result_.tokens.push_back(token);
    return result_.tokens.back();
  }

  void Next() {
    const char c = text_[at_];
    if (IsBlank(c)) {
      ++at_;
    } else if (IsLineEnd(c)) {
      at_ += c == '\r' && Peek(1) == '\n' ? 2 : 1;
      line_is_fresh_ = true;
      ++line_ends_;
    } else if (IsRunCharacter(c)) {
      LexRun();
    } else if (c == ';') {
      LexComment(at_);
    } else if (c == '$') {
      ++at_;
      Add(TokenKind::kCycleMark, at_ - 1);
      SkipBlanks();
      if (!AtLineEnd()) {
        LexComment(at_);
      }
    } else if (c == '!') {
      LexSymbol();
    } else if (c == '"') {
      LexAscii();
    } else if (!IsAscii(c)) {
      LexRun();
    } else if (IsIllegal(c)) {
      LexIllegal();
    } else {
      ++at_;
      Add(Punctuation(c), at_ - 1);
    }
  }

  void SkipBlanks() {
    while (at_ < text_.size() && IsBlank(text_[at_])) {
      ++at_;
    }
  }

  void SkipToLineEnd() {
    while (!AtLineEnd()) {
      ++at_;
    }
  }

  void LexComment(size_t begin) {
    SkipToLineEnd();
    Comment comment;
    comment.range = RangeFrom(begin);
    while (comment.range.end > comment.range.begin + 1 && IsBlank(text_[comment.range.end - base_ - 1])) {
      --comment.range.end;
    }
    comment.place = line_is_fresh_ ? CommentPlace::kLeading : CommentPlace::kTrailing;
    // The line end of what stands above counts too, so two of them make a blank line.
    comment.blank_line_before = line_ends_ >= 2 && !(result_.tokens.empty() && result_.comments.empty());
    line_ends_ = 0;
    result_.comments.push_back(comment);
  }

  void SkipIllegal() {
    while (at_ < text_.size() && (IsIllegal(text_[at_]) || !IsAscii(text_[at_]))) {
      ++at_;
    }
  }

  void LexIllegal() {
    const size_t begin = at_;
    const source::CodePoint point = source::FirstCodePoint(text_.substr(at_));
    const std::string remedy = MeantBy(begin);
    SkipIllegal();
    if (text_[begin] == '%') SkipAddress();
    if (text_[begin] == '.' && BeginOfRun(begin) < begin && !result_.tokens.empty() &&
        result_.tokens.back().kind == TokenKind::kRun) {
      result_.tokens.back().faulty = true;  // U4.0: one cause
    }
    if (text_[begin] == '\'') SkipSingleQuoted();
    const source::Range range = {RangeFrom(begin).begin, RangeFrom(begin).begin + point.length};
    const std::string picture = Picture(text_.substr(begin), point);
    if (remedy.empty()) {
      diagnostics_.Report(range, diag::Nc110UnknownCharacter, picture, source::CodePointName(point.value));
    } else {
      diagnostics_.Report(range, diag::Nc110UnknownCharacterHint, picture, source::CodePointName(point.value), remedy);
    }
    Add(TokenKind::kBad, begin).faulty = true;
  }

  /// %I0.1: one cause, though its point is no character of this language either.
  void SkipAddress() {
    while (at_ < text_.size() && (IsRunCharacter(text_[at_]) || text_[at_] == '.')) {
      ++at_;
    }
  }

  /// 'A': one cause, to the second quote if the line has one.
  void SkipSingleQuoted() {
    size_t end = at_;
    while (end < text_.size() && !IsLineEnd(text_[end]) && text_[end] != '\'') {
      ++end;
    }
    if (end < text_.size() && text_[end] == '\'') {
      at_ = end + 1;
    }
  }

  /// Of the run that ends in front of `at`.
  size_t BeginOfRun(size_t at) const {
    while (at > 0 && IsRunCharacter(text_[at - 1])) --at;
    return at;
  }

  /// What a character of other languages is in this one, as a remedy; empty: nobody knows.
  std::string MeantBy(size_t at) const {
    const auto digit = [&](size_t place) { return place < text_.size() && IsDigit(text_[place]); };
    switch (text_[at]) {
      case '.':
        if (BeginOfRun(at) < at && !digit(BeginOfRun(at))) {
          return "operands have no point: the letter of the package is between their numbers, U4A0";
        }
        if (at == 0 || !digit(at - 1) || !digit(at + 1)) return {};
        return "numbers are whole: a delay counts 100 ms (T48 to T63: 10 ms), so that 3.5 s are 35";
      case '%':
        return "operands are written without '%': I0A1, U4K3";
      case '|':
        return "OR is written '+'";
      case '~':
        return "NOT is written '/' in front of its operand";
      case '^':
        return "exclusive OR is written '&'";
      case '#':
        return "a hexadecimal number ends with H and begins with a digit: 0FFH";
      case '\'':
        return "a text is compared in double quotes: \"ABC\"";
      case '{':
      case '}':
        return "a block begins with DOF: and its condition, and ends with ENDF";
      default:
        return {};
    }
  }

  /// What has been read of a run of letters and digits.
  struct RunText {
    std::string text;  // with Latin letters only
    bool lower = false;
    bool foreign = false;  // the source has letters that look like Latin ones
    HomoglyphReader::Outcome outcome = HomoglyphReader::Outcome::kMapped;
  };

  void LexRun() {
    const size_t begin = at_;
    RunText run;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (!IsAscii(c)) {
        run.foreign = true;
      } else if (!IsRunCharacter(c)) {
        break;
      }
      run.lower = run.lower || (c >= 'a' && c <= 'z');
    }
    const std::string_view source = text_.substr(begin, at_ - begin);
    run.text = source;
    if (run.foreign) {
      run.outcome = homoglyphs_.Read(source, RangeFrom(begin).begin, run.text);
      if (run.text.empty()) {
        SkipIllegal();  // one message for a stretch of bad characters
        Add(TokenKind::kBad, begin).faulty = true;
        return;
      }
    }
    const Word word = Classify(run.text);
    TokenKind kind = word.kind;
    if (kind == TokenKind::kEnd) {
      kind = JoinEnd(run);
    }
    Token& token = Add(kind, begin);
    token.function = word.function;
    token.lower_case = run.lower;
    token.faulty = run.outcome == HomoglyphReader::Outcome::kReported;
    if (run.foreign) {
      token.mapped = true;
      result_.mapped[token.range.begin] = run.text;
    }
    if (kind == TokenKind::kMsg) {
      LexMsgTail();
    }
  }

  /// END F, END E, END W on one line are one word, also with a letter that only looks like the E.
  TokenKind JoinEnd(RunText& run) {
    size_t letter = at_;
    while (letter < text_.size() && IsBlank(text_[letter])) {
      ++letter;
    }
    if (letter >= text_.size()) {
      return TokenKind::kEnd;
    }
    const source::CodePoint point = source::FirstCodePoint(text_.substr(letter));
    const size_t behind = letter + point.length;
    if (behind < text_.size() && (IsRunCharacter(text_[behind]) || !IsAscii(text_[behind]))) {
      return TokenKind::kEnd;
    }
    const char latin = point.value < 0x80 ? static_cast<char>(point.value) : LatinFor(point.value);
    TokenKind kind = TokenKind::kEnd;
    switch (Upper(latin)) {
      case 'F':
        kind = TokenKind::kEndf;
        break;
      case 'E':
        kind = TokenKind::kEnde;
        break;
      case 'W':
        kind = TokenKind::kEndw;
        break;
      default:
        return kind;
    }
    run.lower = run.lower || latin >= 'a';
    at_ = letter;
    std::string tail(1, latin);
    if (point.value >= 0x80) {
      const auto begin = RangeFrom(at_).begin;
      const HomoglyphReader::Outcome outcome = homoglyphs_.Read(text_.substr(letter, point.length), begin, tail);
      if (outcome == HomoglyphReader::Outcome::kReported) {
        run.outcome = outcome;
      }
      run.foreign = true;
    }
    run.text += ' ' + tail;
    at_ = behind;
    return kind;
  }

  void LexSymbol() {
    const size_t begin = at_++;
    if (Peek() == '=') {
      ++at_;
      diagnostics_.Report(RangeFrom(begin), diag::Nc110ComparisonSignForeign, "!=", "/[a=b] for 'not equal'");
      Add(TokenKind::kBad, begin).faulty = true;
      return;
    }
    bool foreign = false;
    while (at_ < text_.size() && (IsNameCharacter(text_[at_]) || !IsAscii(text_[at_]))) {
      foreign = foreign || !IsAscii(text_[at_]);
      ++at_;
    }
    const std::string_view name = text_.substr(begin + 1, at_ - begin - 1);
    if (name.empty()) {
      diagnostics_.Report(RangeFrom(begin), diag::Nc110SymbolEmpty);
      Add(TokenKind::kSymbol, begin).faulty = true;
      return;
    }
    bool faulty = false;
    std::string mapped;
    if (foreign) {
      faulty = homoglyphs_.Read(name, RangeFrom(begin + 1).begin, mapped) == HomoglyphReader::Outcome::kReported;
    } else if (name.size() > 127) {
      diagnostics_.Report(RangeFrom(begin), diag::Nc110SymbolTooLong, static_cast<diag::Number>(name.size()));
      faulty = true;
    }
    Token& token = Add(TokenKind::kSymbol, begin);
    token.faulty = faulty;
    if (foreign && !mapped.empty()) {
      token.mapped = true;
      result_.mapped[token.range.begin] = "!" + mapped;
    }
  }

  /// The closing quote or, reported, the line end.
  bool SkipQuoted(size_t begin) {
    ++at_;
    while (!AtLineEnd() && text_[at_] != '"') {
      ++at_;
    }
    if (AtLineEnd()) {
      diagnostics_.Report({RangeFrom(begin).begin, RangeFrom(begin).begin + 1}, diag::Nc110AsciiQuote);
      return false;
    }
    ++at_;
    return true;
  }

  void LexAscii() {
    const size_t begin = at_;
    bool faulty = !SkipQuoted(begin);
    if (!faulty) {
      faulty = ReportLiteral(text_.substr(begin + 1, at_ - begin - 2), begin);
    }
    Add(TokenKind::kAscii, begin).faulty = faulty;
  }

  bool ReportLiteral(std::string_view literal, size_t begin) {
    if (literal.empty()) {
      diagnostics_.Report(RangeFrom(begin), diag::Nc110AsciiEmpty);
      return true;
    }
    for (size_t i = 0; i < literal.size(); ++i) {
      if (literal[i] < 0x20 || literal[i] > 0x7E) {
        const source::CodePoint point = source::FirstCodePoint(literal.substr(i));
        const source::Offset place = base_ + static_cast<source::Offset>(begin + 1 + i);
        diagnostics_.Report({place, place + point.length}, diag::Nc110AsciiCharacter, Picture(literal.substr(i), point),
                            source::CodePointName(point.value));
        return true;
      }
    }
    if (literal.size() > 32) {
      diagnostics_.Report(RangeFrom(begin), diag::Nc110AsciiTooLong, static_cast<diag::Number>(literal.size()));
      return true;
    }
    return false;
  }

  /// MSG number [=] text: the text is anything, so only the lexer can tell where it ends.
  void LexMsgTail() {
    SkipBlanks();
    if (IsDigit(Peek())) {
      LexRun();
      SkipBlanks();
      if (Peek() == '=') {
        ++at_;
        Add(TokenKind::kAssign, at_ - 1);
        SkipBlanks();
      }
    }
    if (AtLineEnd() || Peek() == ';') {
      return;
    }
    const size_t begin = at_;
    if (Peek() == '"') {
      const bool closed = SkipQuoted(begin);
      Add(TokenKind::kMsgText, begin).faulty = !closed;
      return;
    }
    while (!AtLineEnd() && text_[at_] != ';') {
      ++at_;
    }
    const size_t end = at_;
    while (IsBlank(text_[at_ - 1])) {
      --at_;
    }
    Add(TokenKind::kMsgText, begin);
    at_ = end;
  }

  std::string_view text_;
  source::Offset base_;
  diag::Engine& diagnostics_;
  HomoglyphReader homoglyphs_;
  LexedFile result_;
  size_t at_ = 0;
  bool line_is_fresh_ = true;
  uint32_t line_ends_ = 0;  // since the last token or comment
};

}  // namespace

LexedFile Lex(const source::SourceManager& sources, source::FileId file, Homoglyphs homoglyphs,
              diag::Engine& diagnostics) {
  return Lexer(sources.Get(file), homoglyphs, diagnostics).Run();
}

}  // namespace plcxx::nc110
