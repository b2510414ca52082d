// From the tokens of the program to tokens that Clang understands as the language means them (specification 2.3 to 2.5,
// 3.5, 3.6): Borland's words go, `asm cli` becomes a call, what is an extension is reported and replaced by something
// that costs no second message.
#include <clang/Lex/Preprocessor.h>
#include <llvm/ADT/DenseSet.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transpiler/dialects/hnc/machine/product_names.h"
#include "transpiler/dialects/hnc/parser/clang/foreign_forms.h"
#include "transpiler/dialects/hnc/parser/clang/session.h"
#include "transpiler/source/characters.h"

namespace plcxx::hnc {
namespace {

namespace tok = clang::tok;

constexpr size_t kMostLevels = 127;         // 10.1
constexpr size_t kSignificantLetters = 32;  // 2.3
constexpr const char* kWithoutPrefix = "write it without the letter in front";

enum class Treatment : uint8_t {
  kIgnored,
  kWithoutMeaning,
  kInterrupt,
  kAssembler,
  kPseudoRegister,
  kForeignType,
  kForeignValue,
  kForeignCall,
  kForeignTypeCall,
  kForeignQualifierCall,
  kForeignStatement,
};

const std::unordered_map<std::string, Treatment>& Words() {
  static const auto* const words = [] {
    auto* made = new std::unordered_map<std::string, Treatment>();
    const auto add = [&](std::string word, int underscores, Treatment treatment) {
      for (int i = 0; i <= underscores; ++i, word.insert(0, "_")) made->emplace(word, treatment);
    };
#define HNC_WORD(Word, Underscores, Name) add(Word, Underscores, Treatment::k##Name);
#include "transpiler/dialects/hnc/parser/clang/words.def"
    return made;
  }();
  return *words;
}

constexpr std::string_view kKeywords[] = {"auto",     "break",  "case",     "char",   "const",    "continue", "default",
                                          "do",       "double", "else",     "enum",   "extern",   "float",    "for",
                                          "goto",     "if",     "int",      "long",   "register", "return",   "short",
                                          "signed",   "sizeof", "static",   "struct", "switch",   "typedef",  "union",
                                          "unsigned", "void",   "volatile", "while"};

bool IsKeyword(std::string_view name) { return std::ranges::find(kKeywords, name) != std::end(kKeywords); }

bool IsPrefixOperator(const clang::Token& token) {
  return token.isOneOf(tok::exclaim, tok::tilde, tok::minus, tok::plus, tok::star, tok::amp, tok::plusplus,
                       tok::minusminus, tok::kw_sizeof);
}

class Filter {
 public:
  explicit Filter(Session& session) : session_(session), preprocessor_(session.clang.getPreprocessor()) {}

  void Run() {
    in_.swap(session_.tokens);
    session_.tokens.reserve(in_.size() + in_.size() / 16);
    while (at_ < in_.size() && !session_.stopped) Next();
    CompareNames();
    if (last_.isValid()) session_.output.unit.last_token = session_.places.OfToken(last_);
    Close();
  }

 private:
  const clang::Token& Peek(size_t ahead = 0) const { return in_[std::min(at_ + ahead, in_.size() - 1)]; }
  std::string Spelling(const clang::Token& token) const { return preprocessor_.getSpelling(token); }
  source::Range RangeOf(const clang::Token& token) const { return session_.places.OfToken(token.getLocation()); }
  void Put(const clang::Token& token) { session_.tokens.push_back(token); }

  /// A token that the program does not write, at the place of one that it does.
  clang::Token Made(const clang::Token& place, tok::TokenKind kind) const {
    clang::Token token;
    token.startToken();
    token.setKind(kind);
    token.setLocation(place.getLocation());
    token.setLength(place.isAnnotation() ? 1 : place.getLength());
    return token;
  }
  clang::Token MadeName(const clang::Token& place, const std::string& name, tok::TokenKind kind) const {
    clang::Token token = Made(place, kind);
    token.setIdentifierInfo(preprocessor_.getIdentifierInfo(name));
    return token;
  }
  clang::Token MadeLiteral(const clang::Token& place, const std::string& text, tok::TokenKind kind) const {
    clang::Token token = Made(place, kind);
    preprocessor_.CreateString(text, token, place.getLocation(), place.getLocation());
    if (place.isAtStartOfLine()) token.setFlag(clang::Token::StartOfLine);
    return token;
  }

  void Next();
  bool CountLevels();
  void CountChains(const clang::Token& token);
  void Identifier();
  bool Apply(Treatment treatment, const std::string& name);
  void SkipParentheses();
  void Assembler();
  void AssemblerLine();
  void Enumeration();
  void LongDouble();
  void Number();
  clang::Token InOrder(const clang::Token& token) const;
  void Character();
  void String();
  void CompareNames();
  void Close();

  Session& session_;
  clang::Preprocessor& preprocessor_;
  std::vector<clang::Token> in_;
  size_t at_ = 0;
  clang::SourceLocation last_;  // of what the program writes
  size_t levels_ = 0, prefixes_ = 0;
  size_t heads_ = 0;                        // `while (a) if (b) ...` without a brace or a statement's end between
  size_t dimensions_ = 0;                   // `[1][2]...` without anything between
  std::vector<size_t> conditionals_ = {0};  // `a ? b : c ? ...`, by level of brackets
  size_t parentheses_ = 0;
  bool behind_bracket_ = false;
  unsigned enumerations_ = 0;
  llvm::DenseSet<const clang::IdentifierInfo*> plain_;  // names that are nothing else
};

void Filter::Next() {
  const clang::Token& token = Peek();
  if (session_.places.InProduct(token.getLocation())) {
    Put(token);
    ++at_;
    return;
  }
  if (!CountLevels()) return;
  if (token.getIdentifierInfo() != nullptr) return Identifier();
  if (token.is(tok::numeric_constant)) return Number();
  if (tok::isStringLiteral(token.getKind())) return String();
  if (token.isOneOf(tok::char_constant, tok::wide_char_constant, tok::utf8_char_constant, tok::utf16_char_constant,
                    tok::utf32_char_constant)) {
    return Character();
  }
  if (token.is(tok::unknown) && Spelling(token) == "\\") {
    // In an argument of a macro: there.
    const clang::SourceLocation place = preprocessor_.getSourceManager().getFileLoc(token.getLocation());
    session_.findings().Report(session_.places.OfToken(place), diag::HncCharacterForeign, "\\",
                               source::CodePointName('\\'),
                               "outside literals a backslash only ends a line that goes on");
    ++at_;
    return;
  }
  if (token.isNot(tok::eof)) last_ = token.getLocation();
  Put(token);
  ++at_;
}

/// What nests without a bracket.
void Filter::CountChains(const clang::Token& token) {
  if (token.is(tok::l_paren)) ++parentheses_;
  if (token.is(tok::r_paren) && parentheses_ > 0) --parentheses_;
  if (token.isOneOf(tok::kw_for, tok::kw_while, tok::kw_do, tok::kw_if, tok::kw_switch)) ++heads_;
  const bool ends = token.is(tok::semi) && parentheses_ == 0;
  if (ends || token.isOneOf(tok::l_brace, tok::r_brace, tok::kw_else)) heads_ = 0;
  if (token.is(tok::question)) ++conditionals_.back();
  if (token.isOneOf(tok::semi, tok::comma)) conditionals_.back() = 0;
  if (token.is(tok::l_square)) dimensions_ = behind_bracket_ ? dimensions_ + 1 : 1;
  behind_bracket_ = token.is(tok::r_square);
}

/// False, with a message, where it is nested too deep: nothing after it is looked at.
bool Filter::CountLevels() {
  const clang::Token& token = Peek();
  prefixes_ = IsPrefixOperator(token) ? prefixes_ + 1 : 0;
  if (token.isOneOf(tok::l_paren, tok::l_brace, tok::l_square)) {
    ++levels_;
    conditionals_.push_back(0);
  }
  if (token.isOneOf(tok::r_paren, tok::r_brace, tok::r_square) && levels_ > 0) {
    --levels_;
    conditionals_.pop_back();
  }
  CountChains(token);
  if (std::max({levels_, prefixes_, heads_, dimensions_, conditionals_.back()}) <= kMostLevels) return true;
  session_.findings().Report(RangeOf(token), diag::HncSyntaxDepth);
  session_.stopped = true;
  return false;
}

void Filter::Identifier() {
  const clang::Token& token = Peek();
  if (token.is(tok::identifier) && plain_.contains(token.getIdentifierInfo())) {
    last_ = token.getLocation();
    Put(token);
    ++at_;
    return;
  }
  const std::string name = token.getIdentifierInfo()->getName().str();
  last_ = token.getLocation();
  const auto word = Words().find(name);
  if (word != Words().end()) {
    if (Apply(word->second, name)) return;
  } else if (name.starts_with("__builtin_") || name == "__extension__" || name == "__extension") {
    session_.findings().Report(RangeOf(token), diag::HncExtension, name, InsteadOfWord(name));
    ++at_;
    if (name.starts_with("__builtin_")) {
      Put(MadeName(token, std::string(kPoisonName), tok::identifier));
      SkipParentheses();
    }
    return;
  } else if (token.isNot(tok::identifier) && !IsKeyword(name)) {
    session_.findings().Report(RangeOf(token), diag::HncExtension, name, InsteadOfWord(name));
    ++at_;
    return;
  }
  if (token.is(tok::kw_enum)) return Enumeration();
  if (token.isOneOf(tok::kw_long, tok::kw_double)) return LongDouble();
  if (token.is(tok::identifier)) {
    session_.NoteName(name, token.getLocation());
    if (name.size() < kSignificantLetters && word == Words().end()) plain_.insert(token.getIdentifierInfo());
  }
  Put(token);
  ++at_;
}

/// False: the word is an ordinary name after all.
bool Filter::Apply(Treatment treatment, const std::string& name) {
  const clang::Token token = Peek();
  const source::Range range = RangeOf(token);
  const auto extension = [&] { session_.findings().Report(range, diag::HncExtension, name, InsteadOfWord(name)); };
  ++at_;
  switch (treatment) {
    case Treatment::kIgnored:
      return true;
    case Treatment::kWithoutMeaning:
      session_.findings().Report(range, diag::HncWithoutMeaning, "'" + name + "'");
      return true;
    case Treatment::kInterrupt:
      session_.findings().Report(range, diag::HncInterrupt);
      return true;
    case Treatment::kAssembler:
      --at_;
      Assembler();
      return true;
    case Treatment::kPseudoRegister:
      session_.findings().Report(range, diag::HncPseudoRegister, name);
      Put(MadeName(token, std::string(kPoisonName), tok::identifier));
      return true;
    case Treatment::kForeignType:
      extension();
      Put(MadeName(token, "int", tok::kw_int));
      return true;
    case Treatment::kForeignValue:
      extension();
      Put(MadeName(token, std::string(kPoisonName), tok::identifier));
      return true;
    case Treatment::kForeignCall:
      extension();
      Put(MadeName(token, std::string(kPoisonName), tok::identifier));
      SkipParentheses();
      return true;
    case Treatment::kForeignTypeCall:
      extension();
      Put(MadeName(token, "int", tok::kw_int));
      SkipParentheses();
      return true;
    case Treatment::kForeignQualifierCall:
      extension();
      SkipParentheses();
      return true;
    case Treatment::kForeignStatement:
      extension();
      while (!Peek().isOneOf(tok::semi, tok::r_brace, tok::eof)) ++at_;
      return true;
  }
  return true;
}

void Filter::SkipParentheses() {
  if (Peek().isNot(tok::l_paren)) return;
  size_t open = 0;
  do {
    if (Peek().is(tok::l_paren)) ++open;
    if (Peek().is(tok::r_paren)) --open;
    ++at_;
  } while (open > 0 && Peek().isNot(tok::eof));
}

/// asm line, or asm { lines }; each line ends with ';' or with the line of the text.
void Filter::Assembler() {
  ++at_;
  if (Peek().isNot(tok::l_brace)) return AssemblerLine();
  Put(Peek());
  ++at_;
  while (!Peek().isOneOf(tok::r_brace, tok::eof)) {
    if (Peek().is(tok::semi)) {
      ++at_;
    } else {
      AssemblerLine();
    }
  }
  if (Peek().is(tok::r_brace)) {
    Put(Peek());
    ++at_;
  }
}

void Filter::AssemblerLine() {
  const clang::Token first = Peek();
  const size_t begin = at_;
  while (!Peek().isOneOf(tok::semi, tok::r_brace, tok::eof)) {
    if (at_ > begin && Peek().isAtStartOfLine()) break;
    ++at_;
  }
  std::string instruction;
  source::Range range = RangeOf(first);
  for (size_t i = begin; i < at_; ++i) {
    if (!instruction.empty()) instruction += ' ';
    instruction += Spelling(in_[i]);
    range.end = std::max(range.end, RangeOf(in_[i]).end);
  }
  std::string lower = instruction;
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const clang::Token last = in_[at_ > begin ? at_ - 1 : begin];
  if (levels_ == 0) {
    session_.findings().Report(range, diag::HncAssembler, "outside a function");
    if (Peek().is(tok::semi)) ++at_;
    return;
  }
  if (lower == "cli" || lower == "sti") {
    Put(MadeName(first, std::string(kProductPrefix) + lower, tok::identifier));
    Put(Made(first, tok::l_paren));
    Put(Made(last, tok::r_paren));
  } else {
    session_.findings().Report(range, diag::HncAssembler,
                               instruction.empty() ? "no instruction" : "'" + instruction + "'");
  }
  if (Peek().is(tok::semi)) {
    Put(Peek());
    ++at_;
  } else {
    Put(Made(last, tok::semi));
  }
}

/// The type of an enumeration is int; Clang takes unsigned int where no enumerator is negative. So the first one is.
void Filter::Enumeration() {
  Put(Peek());
  ++at_;
  if (Peek().is(tok::identifier)) {
    session_.NoteName(Peek().getIdentifierInfo()->getName().str(), Peek().getLocation());
    Put(Peek());
    ++at_;
  }
  if (Peek().isNot(tok::l_brace) || Peek(1).isNot(tok::identifier)) return;
  const clang::Token brace = Peek();
  CountLevels();
  Put(brace);
  ++at_;
  Put(MadeName(brace, std::string(kProductPrefix) + "negative_" + std::to_string(enumerations_++), tok::identifier));
  Put(Made(brace, tok::equal));
  Put(Made(brace, tok::minus));
  Put(MadeLiteral(brace, "1", tok::numeric_constant));
  Put(Made(brace, tok::comma));
}

void Filter::LongDouble() {
  const clang::Token token = Peek();
  const bool is_long_double =
      (token.is(tok::kw_long) && Peek(1).is(tok::kw_double)) || (token.is(tok::kw_double) && Peek(1).is(tok::kw_long));
  if (!is_long_double) {
    Put(token);
    ++at_;
    return;
  }
  source::Range range = RangeOf(token);
  range.end = std::max(range.end, RangeOf(Peek(1)).end);
  session_.findings().Report(range, diag::HncLongDouble);
  Put(token.is(tok::kw_double) ? token : Peek(1));
  at_ += 2;
}

/// 2.5: Clang knows more bases, suffixes and widths.
void Filter::Number() {
  const clang::Token token = Peek();
  const std::string text = Spelling(token);
  last_ = token.getLocation();
  ++at_;
  constexpr size_t kShort = 5;  // a decimal number of so many digits is in order
  const auto is_decimal = [](unsigned char c) { return std::isdigit(c) != 0; };
  if (text.size() <= kShort && std::ranges::all_of(text, is_decimal) && (text.size() == 1 || text[0] != '0')) {
    return Put(token);
  }
  const auto replace = [&] { Put(MadeLiteral(token, "0", tok::numeric_constant)); };
  const auto report = [&](const diag::Message<diag::Text>& message) {
    session_.findings().Report(RangeOf(token), message, text);
    replace();
  };
  const bool hex = text.size() > 1 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
  const bool binary = text.size() > 1 && text[0] == '0' && (text[1] == 'b' || text[1] == 'B');
  const auto extension = [&](const std::string& remedy) {
    session_.findings().Report(RangeOf(token), diag::HncExtension, text, remedy);
    replace();
  };
  if (binary) return extension(InsteadOfBinary(text));
  const bool real = !hex && text.find_first_of(".eE") != std::string::npos;
  if (hex && text.find_first_of(".pP") != std::string::npos) return extension("write the number with decimal digits");
  size_t digits = hex ? 2 : 0;
  if (real) {
    while (digits < text.size()) {
      const char c = text[digits];
      const bool sign = (c == '+' || c == '-') && (text[digits - 1] == 'e' || text[digits - 1] == 'E');
      if (std::isdigit(static_cast<unsigned char>(c)) == 0 && c != '.' && c != 'e' && c != 'E' && !sign) break;
      ++digits;
    }
  } else {
    const auto is_digit = [&](unsigned char c) { return (hex ? std::isxdigit(c) : std::isdigit(c)) != 0; };
    while (digits < text.size() && is_digit(static_cast<unsigned char>(text[digits]))) ++digits;
  }
  std::string suffix = text.substr(digits);
  std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (real) {
    if (suffix == "l") {
      session_.findings().Report(RangeOf(token), diag::HncLongDouble);
      return replace();
    }
    if (!suffix.empty() && suffix != "f") return report(diag::HncConstantSuffix);
    Put(token);
    return;
  }
  if (suffix == "ll" || suffix == "ull" || suffix == "llu") {
    return extension("write " + text.substr(0, digits) + (suffix == "ll" ? "L" : "UL") + ", which has 32 bits");
  }
  if (!suffix.empty() && suffix != "u" && suffix != "l" && suffix != "ul" && suffix != "lu") {
    return report(diag::HncConstantSuffix);
  }
  const bool octal = !hex && text[0] == '0';
  const unsigned base = hex ? 16 : octal ? 8 : 10;
  uint64_t value = 0;
  for (size_t i = hex ? 2 : 0; i < digits; ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const unsigned digit = std::isdigit(c) != 0 ? c - '0' : static_cast<unsigned>(std::tolower(c)) - 'a' + 10;
    if (digit >= base) return report(diag::HncConstantDigits);
    value = std::min<uint64_t>(value * base + digit, uint64_t{1} << 40);
  }
  if (value > 0xFFFFFFFFU) return report(diag::HncConstantTooLarge);
  if (hex && digits == 2) return report(diag::HncConstantSuffix);
  Put(token);
}

/// Two characters that stand as they are written (source_text.h): the first one is the low byte.
clang::Token Filter::InOrder(const clang::Token& token) const {
  constexpr size_t kTwo = 4;
  if (token.getLength() != kTwo) return token;
  const std::string text = Spelling(token);
  if (text.size() != kTwo || text[1] == '\\') return token;
  std::string swapped = "'";
  for (const size_t at : {2, 1}) {
    std::array<char, 8> octal{};
    std::snprintf(octal.data(), octal.size(), "\\%03o", static_cast<unsigned>(static_cast<unsigned char>(text[at])));
    swapped += octal.data();
  }
  return MadeLiteral(token, swapped + "'", tok::char_constant);
}

void Filter::Character() {
  const clang::Token token = Peek();
  last_ = token.getLocation();
  ++at_;
  if (token.is(tok::char_constant)) return Put(InOrder(token));
  session_.findings().Report(RangeOf(token), diag::HncExtension, Spelling(token), kWithoutPrefix);
  Put(MadeLiteral(token, "0", tok::numeric_constant));
}

void Filter::String() {
  const clang::Token token = Peek();
  last_ = token.getLocation();
  ++at_;
  if (token.is(tok::string_literal)) return Put(token);
  session_.findings().Report(RangeOf(token), diag::HncExtension, Spelling(token), kWithoutPrefix);
  Put(MadeLiteral(token, "\"\"", tok::string_literal));
}

/// Names that agree in their significant letters are one name for the original compiler.
void Filter::CompareNames() {
  std::vector<Session::LongName>& names = session_.long_names;
  std::ranges::stable_sort(names, [&](const Session::LongName& a, const Session::LongName& b) {
    return session_.sources().isBeforeInTranslationUnit(a.place, b.place);
  });
  std::unordered_map<std::string, std::string> first;  // by the significant letters
  std::set<std::string> reported;
  for (const auto& [name, place] : names) {
    const auto [known, is_new] = first.emplace(name.substr(0, kSignificantLetters), name);
    if (is_new || known->second == name || !reported.insert(name).second) continue;
    session_.findings().Report(session_.places.OfToken(place), diag::HncNameLength, name, known->second);
  }
}

/// Clang may look at some tokens after the last one.
void Filter::Close() {
  clang::Token end = in_.back();
  end.startToken();
  end.setKind(tok::eof);
  end.setLocation(in_.back().getLocation());
  constexpr int kEnough = 8;
  session_.tokens.erase(std::ranges::find_if(session_.tokens, [](const clang::Token& t) { return t.is(tok::eof); }),
                        session_.tokens.end());
  for (int i = 0; i < kEnough; ++i) Put(end);
}

}  // namespace

void Session::NoteName(const std::string& name, clang::SourceLocation place) {
  if (name.size() < kSignificantLetters || places.InProduct(place)) return;
  output.can_keep = false;  // which of two is reported depends on what stands in front
  long_names.push_back({name, place});
}

void FilterTokens(Session& session) { Filter(session).Run(); }

}  // namespace plcxx::hnc
