// Tokens of single lines, and how bytes become lines.
#include "transpiler/dialects/technol/source/lexer.h"

#include "tests/dialects/technol_parsing.h"

namespace plcxx::technol {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// "word LDR" of every token.
std::vector<std::string> TokensOf(std::string_view line) {
  std::vector<Token> tokens;
  LexLine(line, {.begin = 1}, tokens);
  std::vector<std::string> shown;
  for (const Token& token : tokens) shown.push_back(std::string(Name(token.kind)) + " " + std::string(token.text));
  return shown;
}

TEST(TechnolLexer, WordsAndNumbers) {
  EXPECT_THAT(
      TokensOf("Lab_1:\tLOD\fWORD.X?@[BX+0FFh] ;text "),
      ElementsAre("word Lab_1", "punctuation :", "word LOD", "word WORD", "punctuation .", "word X?@", "punctuation [",
                  "word BX", "punctuation +", "number 0FFh", "punctuation ]", "comment ;text"));
  EXPECT_THAT(TokensOf("DB?"), ElementsAre("word DB?"));
  EXPECT_THAT(TokensOf("DB ?"), ElementsAre("word DB", "word ?"));
  EXPECT_THAT(TokensOf("12AB.5"), ElementsAre("number 12AB", "punctuation .", "number 5"));
  EXPECT_THAT(TokensOf(" \t\f "), IsEmpty());
}

TEST(TechnolLexer, Strings) {
  EXPECT_THAT(TokensOf("DB 'a;b','''"), ElementsAre("word DB", "string 'a;b'", "punctuation ,", "string '''"));
  EXPECT_THAT(TokensOf("DB 'ab"), ElementsAre("word DB", "open-string 'ab"));
  EXPECT_THAT(TokensOf("DB '"), ElementsAre("word DB", "open-string '"));
  EXPECT_THAT(TokensOf("DB ''"), ElementsAre("word DB", "open-string ''"));
}

TEST(TechnolLexer, PathsAndTitles) {
  EXPECT_THAT(TokensOf("T_INCLUDE ..\\a-b.inc ;x"), ElementsAre("word T_INCLUDE", "path ..\\a-b.inc", "comment ;x"));
  EXPECT_THAT(TokensOf("L: t_include 'a b.inc'"),
              ElementsAre("word L", "punctuation :", "word t_include", "string 'a b.inc'"));
  EXPECT_THAT(TokensOf("INCLUDE T_04.ASH;y"), ElementsAre("word INCLUDE", "path T_04.ASH", "comment ;y"));
  EXPECT_THAT(TokensOf("TITLE it's ; 5%"), ElementsAre("word TITLE", "text it's ; 5%"));
}

TEST(TechnolLexer, OtherCharacters) {
  EXPECT_THAT(TokensOf("A%\xC4\x8D"), ElementsAre("word A", "invalid %", "invalid \xC4\x8D"));
  EXPECT_THAT(CodeErrors("LDR \xC4\x8D\nLOD X#\nLOD X \\\nLOD X &\n"),
              ElementsAre("1:5 TE004", "2:6 TE004", "3:7 TE002", "4:7 TE002"));
}

TEST(TechnolLexer, LinesAndEncodings) {
  Parsed parsed;
  // CP852, ends of three kinds, and a DOS end of file.
  ParseInto(parsed,
            {"DATA\rX: DS 1 ;p\x9Fiprava\r\nDATA_END\nMODULE_MAIN\nLOD X\nSTO X\nMODULE_MAIN_END\nSTOP\n\x1A LOD"});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  EXPECT_THAT(parsed.Warnings(), IsEmpty());
  EXPECT_EQ(parsed.program.line_count, 8u);
  EXPECT_THAT(parsed.sources.Get(parsed.request.files[0]).text, HasSubstr("p\xC4\x8Diprava"));
  EXPECT_THAT(ErrorsOf("\xEF\xBB\xBF" + InProgram("X: DS 1\n", "LOD X\n")), IsEmpty());
}

TEST(TechnolLexer, LongLinesAreWarnedAbout) {
  const std::string long_line = "LOD X ;" + std::string(506, 'x') + "\n";
  EXPECT_THAT(WarningsOf(InProgram("X: DS 1\n", long_line)), ElementsAre("5:1 TW001"));
  EXPECT_THAT(WarningsOf(InProgram("X: DS 1\n", "LOD X ;" + std::string(505, 'x') + "\n")), IsEmpty())
      << "512 bytes are not too long";
}

}  // namespace
}  // namespace plcxx::technol
