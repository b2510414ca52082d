// Tokens of the nc110 lexer: words, numbers, comments, line ends, encodings already decoded.
#include "transpiler/dialects/nc110/source/lexer.h"

#include "tests/dialects/nc110_parsing.h"

namespace plcxx::nc110 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> TokensOf(const std::string& text) {
  source::SourceManager sources;
  const source::FileId file = sources.AddText("file", text);
  const std::string printed = PrintTokens(sources, file, {});
  std::vector<std::string> result;
  for (size_t begin = 0; begin < printed.size();) {
    const size_t end = printed.find('\n', begin);
    result.push_back(printed.substr(begin, end - begin));
    begin = end + 1;
  }
  return result;
}

// covers: NC110-003 NC110-010
TEST(Nc110Lexer, LineEndsAndPlaces) {
  EXPECT_THAT(TokensOf("U4A0=\r\n I0A0\rP1\nT5U"), ElementsAre("1:1 operand U4A0", "1:5 operator =", "2:2 operand I0A0",
                                                               "3:1 operand P1", "4:1 operand T5U", "4:4 end"));
}

// covers: NC110-007 NC110-008 NC110-205
TEST(Nc110Lexer, CommentsRemarksLiterals) {
  EXPECT_THAT(TokensOf("U4A0=\"A;!$B\" ; U4A1=%\n$ any % text\n;%"),
              ElementsAre("1:1 operand U4A0", "1:5 operator =", "1:6 ascii \"A;!$B\"", "2:1 cycle-mark $", "3:3 end"));
}

// covers: NC110-006
TEST(Nc110Lexer, CommentsInAnyScript) {
  EXPECT_THAT(WarningsOf("; Привет, \xEF\xBF\xBD %@ \"\n$ Медленная часть\nU4A0=I0A0 ; конец"), IsEmpty());
}

std::vector<std::string> ErrorsOfBytes(std::string_view bytes) {
  Parsed parsed;
  const auto loaded = parsed.sources.AddBytes("file", bytes, {});
  const auto* file = std::get_if<source::FileId>(&loaded);
  if (file == nullptr) {
    return {"not loaded"};
  }
  parsed.program = Parse(parsed.sources, std::vector<source::FileId>{*file}, {}, parsed.diagnostics);
  EXPECT_EQ(parsed.program.assignments.size(), 1u);
  return parsed.Errors();
}

// covers: NC110-004 NC110-005 NC110-006
TEST(Nc110Lexer, BytesOfOldEditors) {
  EXPECT_THAT(ErrorsOfBytes("U4A0=I0A0\r\n\x1A%%% U4A1=I0A0"), IsEmpty());
  EXPECT_THAT(ErrorsOfBytes("\xEF\xBB\xBFU4A0=I0A0"), IsEmpty());
  EXPECT_THAT(ErrorsOfBytes("; \x8F\xE3\xE1\xAA\nU4A0=I0A0 ; \xE1\xE2\xAE\xAF\n"), IsEmpty());  // CP866
  EXPECT_THAT(ErrorsOfBytes("; \xCF\xF3\xF1\xEA\nU4A0=I0A0 ; \xF1\xF2\xEE\xEF\n"), IsEmpty());  // CP1251
}

// covers: NC110-018 NC110-019 NC110-027
TEST(Nc110Lexer, RunsAreNeverSplit) {
  EXPECT_THAT(TokensOf("W13K 5ENDF I0A0U4A0 P1000 T5"),
              ElementsAre("1:1 unknown W13K", "1:6 number 5ENDF", "1:12 unknown I0A0U4A0", "1:21 unknown P1000",
                          "1:27 unknown T5", "1:29 end"));
}

// covers: NC110-184
TEST(Nc110Lexer, EndFIsOneWordOnOneLine) {
  EXPECT_THAT(TokensOf("END F END\tE\nEND\nF ENDF ENDX END FX"),
              ElementsAre("1:1 keyword END F", "1:7 keyword END\tE", "2:1 keyword END", "3:1 unknown F",
                          "3:3 keyword ENDF", "3:8 unknown ENDX", "3:13 keyword END", "3:17 unknown FX", "3:19 end"));
}

TEST(Nc110Lexer, Numbers) {
  for (const char* text : {"0", "45D", "377O", "0FFH", "1DH", "0DH"}) {
    EXPECT_TRUE(Evaluate(text).well_formed) << text;
  }
  for (const char* text : {"0FF", "08O", "5X", "9O", "0AD", "1HH", "1O1"}) {
    EXPECT_FALSE(Evaluate(text).well_formed) << text;
  }
  EXPECT_EQ(Evaluate("99999999999999999999").value, 1'000'000u);
}

TEST(Nc110Lexer, LookAlikes) {
  EXPECT_EQ(LookAlike("IOA7"), "I0A7");
  EXPECT_EQ(LookAlike("COW"), "C0W");
  EXPECT_EQ(LookAlike("TOI"), "T0I");
  EXPECT_EQ(LookAlike("D0E"), "DOE");
  EXPECT_EQ(LookAlike("LAMP"), "");
}

TEST(Nc110Lexer, EveryOperandForm) {
  for (const char* text :
       {"I0A7", "U255K31", "W15T3", "T254I", "T0A", "T0U", "T0D", "C99I", "C0R", "C0Z", "C0A", "C0W", "P0"}) {
    const Decoded decoded = Decode(text);
    EXPECT_EQ(decoded.fault, OperandFault::kNone) << text;
    EXPECT_EQ(ToText(decoded.operand), text);
    EXPECT_EQ(OperandFromText(text), decoded.operand);
  }
  EXPECT_EQ(OperandFromText("U4A32").kind, OperandKind::kNone);
  EXPECT_EQ(OperandFromText("!X").kind, OperandKind::kNone);
  EXPECT_EQ(OperandFromText("").kind, OperandKind::kNone);
}

TEST(Nc110Lexer, OneMessageForAStretchOfBadCharacters) {
  std::string binary;
  for (int i = 1; i < 0x20; ++i) {
    if (i != '\t' && i != '\n' && i != '\f' && i != '\r') {
      binary += static_cast<char>(i);
    }
  }
  Parsed parsed;
  ParseInto(parsed, {binary + "Ж%" + binary});
  EXPECT_EQ(parsed.Errors().size(), 1u);
}

}  // namespace
}  // namespace plcxx::nc110
