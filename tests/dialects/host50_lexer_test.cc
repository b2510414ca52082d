// covers: HOST50-004 HOST50-007 HOST50-009 HOST50-011..014
#include "transpiler/dialects/host50/source/lexer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "transpiler/dialects/host50/parser/parser.h"

namespace plcxx::host50 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Lexed {
  source::SourceManager sources;
  LexedFile file;
};

void LexInto(Lexed& lexed, const std::string& text) {
  lexed.file = Lex(lexed.sources, lexed.sources.AddText("a.il", text));
}

/// "word LD", "'='" ... of a whole text.
std::vector<std::string> TokensOf(const std::string& text) {
  Lexed lexed;
  LexInto(lexed, text);
  std::vector<std::string> tokens;
  for (const Token& token : lexed.file.tokens) {
    const std::string name(Name(token.kind));
    tokens.push_back(name.starts_with('\'') ? name : name + " " + std::string(lexed.sources.Text(token.range)));
  }
  return tokens;
}

TEST(Host50Lexer, WordsAndOperands) {
  EXPECT_THAT(TokensOf("  ld\t%I007 ; x"), ElementsAre("word ld", "address %I007"));
  EXPECT_THAT(TokensOf("LD%I0"), ElementsAre("word LD", "address %I0"));
  EXPECT_THAT(TokensOf("ADDW %W1,-5,%tm3.v"),
              ElementsAre("word ADDW", "address %W1", "','", "integer -5", "','", "address %tm3.v"));
  EXPECT_THAT(TokensOf("CNUD %C1, 8, P=!%I1,M=0"),
              ElementsAre("word CNUD", "address %C1", "','", "integer 8", "','", "word P", "'='", "'!'", "address %I1",
                          "','", "word M", "'='", "integer 0"));
  EXPECT_THAT(TokensOf("OPTION TP=IEC"), ElementsAre("word OPTION", "word TP", "'='", "word IEC"));
}

TEST(Host50Lexer, Symbols) {
  EXPECT_THAT(TokensOf("LD axis4-"), ElementsAre("word LD", "word axis4-"));
  EXPECT_THAT(TokensOf("LD 'axis4-'.Q;c"), ElementsAre("word LD", "quoted-symbol 'axis4-'.Q"));
  EXPECT_THAT(TokensOf("LD 泵_1+"), ElementsAre("word LD", "word 泵_1+"));
  EXPECT_THAT(TokensOf("LD _a.b#/c"), ElementsAre("word LD", "word _a.b#/c"));
  EXPECT_THAT(TokensOf("LD e\xCC\x81x"), ElementsAre("word LD", "word e\xCC\x81x"));  // a combining mark
  EXPECT_THAT(TokensOf("启动 %I0"), ElementsAre("word 启动", "address %I0"));
}

TEST(Host50Lexer, SymbolsOfExpressionsEndAtOperators) {
  EXPECT_THAT(TokensOf("COMP A+B>='C-D'.V"),
              ElementsAre("word COMP", "word A", "'+'", "word B", "'>='", "quoted-symbol 'C-D'.V"));
  EXPECT_THAT(TokensOf("OPRT T.V:=-1.5e-3*(a)"),
              ElementsAre("word OPRT", "word T.V", "':='", "'-'", "float 1.5e-3", "'*'", "'('", "word a", "')'"));
  EXPECT_THAT(TokensOf("COMP \"%W1 & $0F <> 3\" ; c"),
              ElementsAre("word COMP", "quote \"", "address %W1", "'&'", "hex $0F", "'<>'", "integer 3", "quote \""));
}

TEST(Host50Lexer, Numbers) {
  EXPECT_THAT(TokensOf("MOV 1. .5 1e3 +1.5E-2 1e $FF 12abc"),
              ElementsAre("word MOV", "float 1.", "float .5", "float 1e3", "float +1.5E-2", "integer 1", "word e",
                          "hex $FF", "integer 12", "word abc"));
}

TEST(Host50Lexer, Strings) {
  EXPECT_THAT(TokensOf("NETWORK \"a;\"\"b\\\" ; c"), ElementsAre("word NETWORK", "string \"a;\"\"b\\\""));
  EXPECT_THAT(TokensOf("NETWORK \"open ; c"), ElementsAre("word NETWORK", "open-string \"open ; c"));
  EXPECT_THAT(TokensOf("LD 'open"), ElementsAre("word LD", "open-quoted-symbol 'open"));
}

TEST(Host50Lexer, BadCharacters) {
  EXPECT_THAT(TokensOf("LD PU?MP"), ElementsAre("word LD", "character ?"));
  EXPECT_THAT(TokensOf("LD 'a b'"), ElementsAre("word LD", "character  "));
  EXPECT_THAT(TokensOf("LD '1'"), ElementsAre("word LD", "character 1"));
  EXPECT_THAT(TokensOf("LD ''"), ElementsAre("word LD", "character '"));
  EXPECT_THAT(TokensOf("@ LD"), ElementsAre("character @", "word LD"));
  EXPECT_THAT(TokensOf("LD $G"), ElementsAre("word LD", "character $", "word G"));
  EXPECT_THAT(TokensOf("LD \\ x"), ElementsAre("word LD", "character \\", "word x"));
}

TEST(Host50Lexer, Continuations) {
  EXPECT_THAT(
      TokensOf("ADDW %W1, \\ \n  2,\\\r\n%W3\nLD 1"),
      ElementsAre("word ADDW", "address %W1", "','", "integer 2", "','", "address %W3", "word LD", "integer 1"));
  Lexed lexed;
  LexInto(lexed, "LD a\\\nOUT b ; c \\\nLD 1");
  ASSERT_EQ(lexed.file.lines.size(), 2u) << "a comment does not go on";
  EXPECT_EQ(lexed.sources.Text(lexed.file.lines[0].comment), "; c \\");
  EXPECT_EQ(lexed.sources.Text(lexed.file.lines[0].continuation.first), "LD a\\");
  EXPECT_EQ(lexed.sources.Text(lexed.file.lines[0].continuation.rest), "OUT b ; c \\");
}

TEST(Host50Lexer, Remarks) {
  EXPECT_THAT(TokensOf("REMARK  all ; of \\ \nLD 1"),
              ElementsAre("word REMARK", "text all ; of \\", "word LD", "integer 1"));
  EXPECT_THAT(TokensOf("remark \"a\" ; c"), ElementsAre("word remark", "string \"a\""));
  EXPECT_THAT(TokensOf("REMARK"), ElementsAre("word REMARK"));
}

TEST(Host50Lexer, Drawings) {
  EXPECT_THAT(TokensOf("LADDER\n |-- ; c\n\n END_LADDER\nLD 1"),
              ElementsAre("word LADDER", "row  |-- ; c", "row ", "word END_LADDER", "word LD", "integer 1"));
  EXPECT_THAT(TokensOf("LADDER\n|\n NETWORK\nLD 1"),
              ElementsAre("word LADDER", "row |", "word NETWORK", "word LD", "integer 1"));
}

TEST(Host50Lexer, LineEndsAndComments) {
  Lexed lexed;
  LexInto(lexed, "LD 1\r\n\n ; above  \nOUT %Q0;row\t\r\nEND");
  std::vector<LineKind> kinds;
  for (const Line& line : lexed.file.lines) kinds.push_back(line.kind);
  EXPECT_THAT(kinds, ElementsAre(LineKind::kStatement, LineKind::kBlank, LineKind::kComment, LineKind::kStatement,
                                 LineKind::kStatement));
  EXPECT_EQ(lexed.sources.Text(lexed.file.lines[2].comment), "; above");
  EXPECT_EQ(lexed.sources.Text(lexed.file.lines[3].comment), ";row");
  EXPECT_EQ(lexed.sources.Text(lexed.file.lines[3].range), "OUT %Q0");
}

TEST(Host50Lexer, PrintedTokens) {
  source::SourceManager sources;
  const source::FileId file = sources.AddText("a.il", "LD %I0\n OUT %Q0");
  EXPECT_EQ(PrintTokens(sources, file), "1:1 word LD\n1:4 address %I0\n2:2 word OUT\n2:6 address %Q0\n");
}

Integer IntegerFrom(TokenKind kind, std::string_view text) { return IntegerOf({kind, {}}, text); }

TEST(Host50Numbers, Integers) {
  EXPECT_EQ(IntegerFrom(TokenKind::kInteger, "-2147483648").value, -2147483648LL);
  EXPECT_TRUE(IntegerFrom(TokenKind::kInteger, "-2147483648").fits);
  EXPECT_TRUE(IntegerFrom(TokenKind::kInteger, "+2147483647").fits);
  EXPECT_FALSE(IntegerFrom(TokenKind::kInteger, "2147483648").fits);
  EXPECT_FALSE(IntegerFrom(TokenKind::kInteger, "99999999999999999999999").fits);
  EXPECT_EQ(IntegerFrom(TokenKind::kHex, "$FFFFFFFF").value, -1);
  EXPECT_EQ(IntegerFrom(TokenKind::kHex, "$7fffffff").value, 2147483647);
  EXPECT_FALSE(IntegerFrom(TokenKind::kHex, "$123456789").fits);
}

std::optional<float> FloatFrom(std::string_view text, TokenKind kind = TokenKind::kFloat) {
  const auto bits = FloatBitsOf({kind, {}}, text);
  if (!bits) return std::nullopt;
  return std::bit_cast<float>(*bits);
}

TEST(Host50Numbers, FloatsAreRoundedToNearestEven) {
  EXPECT_EQ(FloatFrom("1."), 1.0f);
  EXPECT_EQ(FloatFrom("-.5"), -0.5f);
  EXPECT_EQ(FloatFrom("+1e3"), 1000.0f);
  EXPECT_EQ(FloatFrom("16777217", TokenKind::kInteger), 16777216.0f);
  EXPECT_EQ(FloatFrom("16777219", TokenKind::kInteger), 16777220.0f);
  EXPECT_EQ(FloatFrom("3000000000", TokenKind::kInteger), 3e9f);
  EXPECT_EQ(FloatFrom("$FFFFFFFF", TokenKind::kHex), -1.0f);
  EXPECT_EQ(FloatFrom("0.1"), 0.1f);
}

TEST(Host50Numbers, FloatsTooLargeAndTooSmall) {
  EXPECT_EQ(FloatFrom("3.4028235e38"), 3.4028235e38f);
  EXPECT_EQ(FloatFrom("3.4028236e38"), std::nullopt);
  EXPECT_EQ(FloatFrom("1e39"), std::nullopt);
  EXPECT_EQ(FloatFrom("1e99999999999999999999"), std::nullopt);
  EXPECT_EQ(FloatFrom("1" + std::string(60, '0'), TokenKind::kInteger), std::nullopt);
  EXPECT_EQ(FloatFrom("1e-45"), std::ldexp(1.0f, -149));  // the least denormal
  EXPECT_EQ(FloatFrom("1e-46"), 0.0f);
  EXPECT_EQ(FloatFrom("0." + std::string(70, '0') + "1"), 0.0f);
  EXPECT_EQ(FloatFrom("0e99999999999999999999"), 0.0f);
  EXPECT_TRUE(std::signbit(*FloatFrom("-1e-50")));
}

TEST(Host50Numbers, Labels) {
  EXPECT_EQ(NumberBehind("SR", "sr0001"), 1u);
  EXPECT_EQ(NumberBehind("J", "J9999"), 9999u);
  EXPECT_EQ(NumberBehind("J", "J99999999999"), 100'000u);
  EXPECT_EQ(NumberBehind("L", "L"), std::nullopt);
  EXPECT_EQ(NumberBehind("L", "L1a"), std::nullopt);
  EXPECT_EQ(NumberBehind("SR", "S1"), std::nullopt);
}

TEST(Host50Lexer, AnEmptyText) { EXPECT_THAT(TokensOf(""), IsEmpty()); }

}  // namespace
}  // namespace plcxx::host50
