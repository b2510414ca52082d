#include "transpiler/dialects/prostep/source/lexer.h"

#include "tests/dialects/prostep_parsing.h"

namespace plcxx::prostep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "mnemonic A" of every token.
std::vector<std::string> TokensOf(const std::string& text) {
  Parsed parsed;
  ParseInto(parsed, {text});
  std::vector<std::string> tokens;
  std::string lines = PrintTokens(parsed.sources, parsed.files.front());
  for (size_t begin = 0; begin < lines.size();) {
    const size_t end = lines.find('\n', begin);
    const std::string line = lines.substr(begin, end - begin);
    tokens.push_back(line.substr(line.find(' ') + 1));
    begin = end + 1;
  }
  return tokens;
}

TEST(ProstepLexer, Lines) {
  EXPECT_THAT(TokensOf("%PLC"), ElementsAre("header %PLC"));
  EXPECT_THAT(TokensOf(" \t"), IsEmpty());
  EXPECT_THAT(TokensOf("  ; note  "), ElementsAre("comment ; note"));
  EXPECT_THAT(TokensOf("* note"), ElementsAre("comment * note"));
  EXPECT_THAT(TokensOf("free text"), ElementsAre("comment free text"));
  EXPECT_THAT(TokensOf("text ; with: a colon"), ElementsAre("comment text ; with: a colon"));
  EXPECT_THAT(TokensOf(":"), ElementsAre("colon :"));
  EXPECT_THAT(TokensOf(" START : ; note"), ElementsAre("label START", "colon :", "comment ; note"));
}

TEST(ProstepLexer, Instructions) {
  EXPECT_THAT(TokensOf(":A I 10.1    Komentarz"),
              ElementsAre("colon :", "mnemonic A", "operand I", "number 10.1", "comment Komentarz"));
  EXPECT_THAT(TokensOf("a b:=F0.0;x"),
              ElementsAre("label a", "label b", "colon :", "mnemonic =", "operand F", "number 0.0", "comment ;x"));
  EXPECT_THAT(TokensOf(":A ( I 0.0"), ElementsAre("colon :", "mnemonic A (", "comment I 0.0"));
  EXPECT_THAT(TokensOf(":AN( I 0.0"), ElementsAre("colon :", "unknown AN(", "comment I 0.0"));
  EXPECT_THAT(TokensOf(":) text"), ElementsAre("colon :", "mnemonic )", "comment text"));
  EXPECT_THAT(TokensOf(":<=>"), ElementsAre("colon :", "unknown <=>"));
  EXPECT_THAT(TokensOf(":AI0.0 x"), ElementsAre("colon :", "unknown AI0.0", "comment x"));
  EXPECT_THAT(TokensOf(":NOP 5"), ElementsAre("colon :", "mnemonic NOP", "comment 5"));
  EXPECT_THAT(TokensOf(":MOD PM20*x"), ElementsAre("colon :", "module MOD", "operand PM", "number 20", "comment *x"));
}

TEST(ProstepLexer, OperandsThatMayBeAbsent) {
  EXPECT_THAT(TokensOf(":O lub reczny"), ElementsAre("colon :", "mnemonic O", "comment lub reczny"));
  EXPECT_THAT(TokensOf(":O ab 5"), ElementsAre("colon :", "mnemonic O", "operand ab", "number 5"));
  EXPECT_THAT(TokensOf(":O 5"), ElementsAre("colon :", "mnemonic O", "junk 5"));
  EXPECT_THAT(TokensOf(":L K -5"), ElementsAre("colon :", "mnemonic L", "operand K", "number -5"));
  EXPECT_THAT(TokensOf(":L -5"), ElementsAre("colon :", "mnemonic L", "comment -5"));
  EXPECT_THAT(TokensOf(":> abc 5"), ElementsAre("colon :", "mnemonic >", "comment abc 5"));
}

TEST(ProstepLexer, OperandLines) {
  EXPECT_THAT(TokensOf(": K FFH x"), ElementsAre("colon :", "operand K", "number FFH", "comment x"));
  EXPECT_THAT(TokensOf(": DB20"), ElementsAre("colon :", "operand DB", "number 20"));
  EXPECT_THAT(TokensOf(": C 5"), ElementsAre("colon :", "operand C", "number 5"));
  EXPECT_THAT(TokensOf(": DB x"), ElementsAre("colon :", "unknown DB", "comment x"));
  EXPECT_THAT(TokensOf(": O 5.0"), ElementsAre("colon :", "mnemonic O", "junk 5.0"));
}

TEST(ProstepLexer, Targets) {
  EXPECT_THAT(TokensOf(":JU START;x"), ElementsAre("colon :", "mnemonic JU", "target START", "comment ;x"));
  EXPECT_THAT(TokensOf(":JU PM20"), ElementsAre("colon :", "mnemonic JU", "operand PM", "number 20"));
  EXPECT_THAT(TokensOf(":JC fm 4 x"), ElementsAre("colon :", "mnemonic JC", "operand fm", "number 4", "comment x"));
  EXPECT_THAT(TokensOf(":JC PM2X"), ElementsAre("colon :", "mnemonic JC", "target PM2X"));
}

TEST(ProstepLexer, Declarations) {
  EXPECT_THAT(TokensOf("DDB10 5 note"), ElementsAre("declaration DDB", "number 10", "number 5", "comment note"));
  EXPECT_THAT(TokensOf("DMF 3 P S 1 D2;x"),
              ElementsAre("declaration DMF", "number 3", "switch P", "switch S 1", "switch D2", "comment ;x"));
  EXPECT_THAT(TokensOf("DM 1 .  a ; b  "), ElementsAre("declaration DM", "number 1", "text   a ; b"));
  EXPECT_THAT(TokensOf("DT2.: x"), ElementsAre("declaration DT", "number 2", "text : x"));
  EXPECT_THAT(TokensOf("DT1 :A I 0.0"), ElementsAre("label DT1", "colon :", "mnemonic A", "operand I", "number 0.0"));
  EXPECT_THAT(TokensOf(" DDB 1 2"), ElementsAre("comment DDB 1 2"));
  EXPECT_THAT(TokensOf("DDBX 1 2"), ElementsAre("comment DDBX 1 2"));
}

TEST(ProstepLexer, Characters) {
  EXPECT_THAT(ErrorsOf("; zażółć \x01\nzażółć\n" + InModule(":A I 0.0 ż")), IsEmpty());
  EXPECT_THAT(ErrorsOf(InModule(":Ż")), ElementsAre("2:2 E01"));
  EXPECT_THAT(ErrorsOf(InModule(":L\n:Kż")), ElementsAre("3:3 E01"));
  EXPECT_THAT(ErrorsOf(InModule("ŁAD:A I 0.0")), ElementsAre("2:1 E01"));
  EXPECT_THAT(ErrorsOf(InModule(":A Ł 0.0")), ElementsAre("2:4 E01"));
  EXPECT_THAT(ErrorsOf(InModule(":A I 0.0\u0142")), ElementsAre("2:9 E01"));
  EXPECT_THAT(ErrorsOf(InModule(":A\x01I 0.0")), ElementsAre("2:3 E01"));
  EXPECT_THAT(ErrorsOf("DM 1 .a\x01\n"), ElementsAre("1:8 E01"));
  EXPECT_THAT(ErrorsOf("DDB 1 5\u0142\n"), ElementsAre("1:8 E01"));
}

TEST(ProstepLexer, Headers) {
  EXPECT_THAT(ErrorsOf("%PLC\n\n; x\n %again\n" + InModule(":NOP")), IsEmpty());
  EXPECT_THAT(ErrorsOf("DDB 1 2\n%PLC\n"), ElementsAre("2:1 E02"));
  EXPECT_THAT(ErrorsOf("free text\n%PLC: x\n"), ElementsAre("2:1 E02"));
  EXPECT_THAT(ErrorsOf(InModule("%PLC")), ElementsAre("2:1 E02"));
}

TEST(ProstepLexer, DeclarationsThatAreComments) {
  EXPECT_THAT(WarningsOf(" DDB 1 2\n"), ElementsAre("1:2 W01"));
  EXPECT_THAT(WarningsOf("DM text\n"), ElementsAre("1:1 W01"));
  EXPECT_THAT(WarningsOf("ddw\n"), ElementsAre("1:1 W01"));
  EXPECT_THAT(WarningsOf("DMX 1\n dm text\nDDZIAL\n"), IsEmpty());
}

TEST(ProstepLexer, Recognize) {
  EXPECT_TRUE(Recognize(":MOD PM 1\n"));
  EXPECT_TRUE(Recognize("%PLC\r; x: y\r\r  : mod\tpm9 x\r"));
  EXPECT_TRUE(Recognize("DM 1 .text: x\n\n* a\nfree\n:MOD PM 20"));
  EXPECT_FALSE(Recognize(":A I 0.0\n:MOD PM 1\n"));
  EXPECT_FALSE(Recognize("x:MOD PM 1\n"));
  EXPECT_FALSE(Recognize(":MODPM 1\n"));
  EXPECT_FALSE(Recognize(":MOD PM\n"));
  EXPECT_FALSE(Recognize("\x1A\n:MOD PM 1\n"));
  EXPECT_FALSE(Recognize(""));
}

}  // namespace
}  // namespace plcxx::prostep
