// The tree of correct programs: decoding, precedence, statement borders, symbols, comments, warnings.
#include "tests/dialects/nc110_parsing.h"

namespace plcxx::nc110 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// covers: NC110-010 NC110-011 NC110-012 NC110-013
TEST(Nc110Parser, StatementsNeedNoSeparator) {
  const auto two = ElementsAre("assign U4A0 (and I0A0 (not I0A1))", "assign W1K0 (add W1K0 1)");
  EXPECT_THAT(ItemsOf("U4A0=I0A0*/I0A1 W1K0=[W1K0+1]"), two);
  EXPECT_THAT(ItemsOf("U4A0=I0A0*/I0A1\tW1K0=[W1K0+1]\f"), two);
  EXPECT_THAT(ItemsOf("U4A0\n=\nI0A0\n*\n/\nI0A1\nW1K0\n=\n[\nW1K0\n+\n1\n]\n"), two);
  EXPECT_THAT(ItemsOf("U4A0= ; target\nI0A0 ; first\n*/I0A1;second\n W1K0=[W1K0 ;!\n+1]"), two);
  EXPECT_THAT(ItemsOf("U4A0=I0A0/U4A1=I0A1"), ElementsAre("assign U4A0 I0A0", "assign-inverted U4A1 I0A1"));
}

// covers: NC110-017 NC110-048
TEST(Nc110Parser, LeadingZerosDoNotCount) {
  EXPECT_THAT(ItemsOf("U04A03=I00A20*T00I*P06*C05R"), ElementsAre("assign U4A3 (and (and (and I0A20 T0I) P6) C5R)"));
  EXPECT_THAT(ItemsOf("W03K00=C00W"), ElementsAre("assign W3K0 C0W"));
}

// covers: NC110-020 NC110-021 NC110-022 NC110-023 NC110-024 NC110-025 NC110-077
TEST(Nc110Parser, Constants) {
  const std::vector<std::pair<std::string, int>> table = {
      {"45", 45},  {"45D", 45}, {"022D", 22}, {"55O", 45}, {"377O", 255},    {"2DH", 45}, {"0FFH", 255}, {"33H", 51},
      {"1DH", 29}, {"1D", 1},   {"0DH", 13},  {"010", 10}, {"0000255", 255}, {"0", 0},    {"00001O", 1}};
  for (const auto& [text, value] : table) {
    EXPECT_THAT(ItemsOf("W1K0=" + text), ElementsAre("assign W1K0 " + std::to_string(value))) << text;
  }
}

// covers: NC110-063 NC110-064 NC110-065 NC110-066 NC110-067 NC110-068 NC110-069
TEST(Nc110Parser, SignalOperators) {
  EXPECT_THAT(ItemsOf("U4A0=I0A0+I0A1*/I0A2&I0A3"),
              ElementsAre("assign U4A0 (xor (or I0A0 (and I0A1 (not I0A2))) I0A3)"));
  EXPECT_THAT(ItemsOf("U4A0=/(I0A0+I0A1)*//I0A2*/[W1K0=3]"),
              ElementsAre("assign U4A0 (and (and (not (or I0A0 I0A1)) I0A2) (not (equal W1K0 3)))"));
  EXPECT_THAT(ItemsOf("W4K0=W1K0&W2K0*/W3K0+0FH"), ElementsAre("assign W4K0 (or (xor W1K0 (and W2K0 (not W3K0))) 15)"));
  ParseOptions options;
  options.xor_precedence = XorPrecedence::kAboveOr;
  EXPECT_THAT(ItemsOf("U4A0=I0A0+I0A1&I0A2+I0A3&I0A4*I0A5", options),
              ElementsAre("assign U4A0 (or (or I0A0 (xor I0A1 I0A2)) (xor I0A3 (and I0A4 I0A5)))"));
  EXPECT_THAT(ItemsOf("U4A0=I0A0&I0A1+I0A2", options), ElementsAre("assign U4A0 (or (xor I0A0 I0A1) I0A2)"));
}

// covers: NC110-072 NC110-073 NC110-075 NC110-147 NC110-168 NC110-182
TEST(Nc110Parser, SignalOperands) {
  EXPECT_THAT(ItemsOf("/U4A0=T1I+T1A+T1U+T1D+C1I+C1R+C1Z+C1A+P1+0+1+\"GO\""),
              ElementsAre("assign-inverted U4A0 (or (or (or (or (or (or (or (or (or (or (or T1I T1A) T1U) T1D) C1I) "
                          "C1R) C1Z) C1A) P1) 0) 1) \"GO\")"));
}

// covers: NC110-078 NC110-079 NC110-080 NC110-081 NC110-083 NC110-084 NC110-088 NC110-114 NC110-115 NC110-116
TEST(Nc110Parser, Words) {
  EXPECT_THAT(ItemsOf("C5W=[W1K0+1-(W2K0-3)]+W3K0"),
              ElementsAre("assign C5W (or (subtract (add W1K0 1) (subtract W2K0 3)) W3K0)"));
  EXPECT_THAT(ItemsOf("W1K0=[17-19]"), ElementsAre("assign W1K0 (subtract 17 19)"));
  EXPECT_THAT(ItemsOf("W1K0=HIG(XCH(W1K0+W2K0))*/ENC(1)"),
              ElementsAre("assign W1K0 (and (HIG (XCH (or W1K0 W2K0))) (not (ENC 1)))"));
  EXPECT_THAT(ItemsOf("W1K0=[BCD(W1K0)+ABS(W2K0-W3K0)]"),
              ElementsAre("assign W1K0 (add (BCD W1K0) (ABS (subtract W2K0 W3K0)))"));
  EXPECT_THAT(ItemsOf("W1K0=ABS(W1K0)"), ElementsAre("assign W1K0 (ABS W1K0)"));
}

// covers: NC110-112 NC110-117 NC110-111
TEST(Nc110Parser, Sgn) {
  EXPECT_THAT(ItemsOf("U4A0=SGN[W1K0-W2K0]*/SGN(W1K0)"),
              ElementsAre("assign U4A0 (and (SGN (subtract W1K0 W2K0)) (not (SGN W1K0)))"));
  EXPECT_THAT(ItemsOf("W1K0=/DEC(W1K0)"), ElementsAre("assign W1K0 (not (DEC W1K0))"));
}

// covers: NC110-089 NC110-091 NC110-092 NC110-093
TEST(Nc110Parser, Comparators) {
  EXPECT_THAT(ItemsOf("U4A0=[W1K0<5]+[5=C5W]*/[W1K0>W2K0]"),
              ElementsAre("assign U4A0 (or (less W1K0 5) (and (equal 5 C5W) (not (greater W1K0 W2K0))))"));
  EXPECT_THAT(ItemsOf("DOF:[W1K0=1] P6=[W1K0=2] ENDF"),
              ElementsAre("DOF level 1: (equal W1K0 1)", "assign P6 (equal W1K0 2)", "ENDF of #0"));
}

// covers: NC110-120 NC110-123 NC110-124 NC110-126
TEST(Nc110Parser, Mux) {
  EXPECT_THAT(ItemsOf("C5W = MUX ( W1K0 , 5 , C6W ) , ( I0A0 , /T5U , P6 ) U4A0=I0A0"),
              ElementsAre("assign C5W (MUX (I0A0 -> W1K0) ((not T5U) -> 5) (P6 -> C6W))", "assign U4A0 I0A0"));
  EXPECT_THAT(ItemsOf("W1K0=MUX(1,2,3,4,5,6,7,8),(I0A0,I0A1,I0A2,I0A3,I0A4,I0A5,I0A6,I0A7)").size(), 1u);
}

// covers: NC110-136 NC110-138 NC110-166 NC110-133 NC110-134
TEST(Nc110Parser, Parameters) {
  EXPECT_THAT(ItemsOf("T254I(0FFH)=I0A0 C99I(2)=I0A0 T5I(W15T2)=I0A0 C5I(W0A3)=I0A0"),
              ElementsAre("assign T254I [255] I0A0", "assign C99I [2] I0A0", "assign T5I [W15T2] I0A0",
                          "assign C5I [W0A3] I0A0"));
  EXPECT_THAT(ItemsOf("C5A=I0A0 C5Z=I0A1 T5A=I0A2 /T5I(3)=I0A3"),
              ElementsAre("assign C5A I0A0", "assign C5Z I0A1", "assign T5A I0A2", "assign-inverted T5I [3] I0A3"));
}

// covers: NC110-016
TEST(Nc110Parser, LowerCase) {
  Parsed parsed;
  ParseInto(parsed, {"$\nu4a0=i0a0 dof x: i0a1 end f x w1k0=2dh"});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  EXPECT_THAT(parsed.Warnings(), ElementsAre("2:1 nc110-W305"));
  EXPECT_THAT(parsed.Items(), ElementsAre("cycle-mark", "assign U4A0 I0A0", "DOF 'x' level 1: I0A1", "ENDF 'x' of #0",
                                          "assign W1K0 45"));
}

// covers: NC110-009 NC110-205 NC110-206 NC110-207
TEST(Nc110Parser, PartsAndRemarks) {
  EXPECT_THAT(WarningsOf("; nothing\n"), ElementsAre("1:1 nc110-W301"));
  EXPECT_THAT(WarningsOf(""), ElementsAre("1:1 nc110-W301"));
  EXPECT_THAT(WarningsOf("U4A0=I0A0"), ElementsAre("1:1 nc110-W303"));
  EXPECT_THAT(WarningsOf("U4A0=I0A0 $ slow = % part\n$ again\nU4A1=I0A0"), ElementsAre("2:1 nc110-W302"));
  Parsed parsed;
  ParseInto(parsed, {"U4A0=I0A0 $ slow = % part\nU4A1=I0A0"});
  EXPECT_EQ(parsed.program.first_cycle_mark.index, 1u);
  EXPECT_EQ(parsed.program.statement_count, 2u);
  EXPECT_EQ(parsed.program.line_count, 2u);
}

// covers: NC110-065 NC110-096 NC110-098 NC110-131
TEST(Nc110Parser, Warnings) {
  EXPECT_THAT(WarningsOf("$\nU4A0=I0A0+I0A1&I0A2+I0A3"), ElementsAre("2:15 nc110-W320"));
  EXPECT_THAT(WarningsOf("$\nU4A0=(I0A0+I0A1)&I0A2"), IsEmpty());
  EXPECT_THAT(WarningsOf("$\nU4A0=[3=4]"), ElementsAre("2:6 nc110-W321"));
  EXPECT_THAT(WarningsOf("$\nDOF: 1 ENDF"), ElementsAre("2:6 nc110-W321"));
  EXPECT_THAT(WarningsOf("$\nU4A0=[W1K0<0]"), ElementsAre("2:6 nc110-W322"));
  EXPECT_THAT(WarningsOf("$\nU4A0=[255<W1K0]"), ElementsAre("2:6 nc110-W322"));
  EXPECT_THAT(WarningsOf("$\nU4A0=[W1K0<1]+[W1K0>254]"), IsEmpty());
  EXPECT_THAT(WarningsOf("$\nU4A0=[ENC(W1K0)=3]"), ElementsAre("2:7 nc110-W330"));
  EXPECT_THAT(WarningsOf("$\nW1K0=MUX(W1K0+80H),(I0A0)"), ElementsAre("2:10 nc110-W330"));
  EXPECT_THAT(WarningsOf("$\nW1K0=MUX(W1K0),(I0A0*I0A1)"), ElementsAre("2:17 nc110-W330"));
  EXPECT_THAT(WarningsOf("$\nU4A0=1"), ElementsAre("2:6 nc110-W330"));
  EXPECT_THAT(WarningsOf("$\nU4A0=1\nU4A1=0"), ElementsAre("2:6 nc110-W330")) << "once in a file";
  EXPECT_THAT(WarningsOf("$\nW200K0=W200K0+1"), ElementsAre("2:14 nc110-W323"));
  EXPECT_THAT(WarningsOf("$\nW200K0=W200K0+80H"), IsEmpty());
}

// covers: NC110-226
TEST(Nc110Parser, Messages) {
  EXPECT_THAT(
      ItemsOf("MSG 5 \"a;b\" U4A0=I0A0\nMSG 6 Нет масла $5 ; remark\nMSG 0AH = text"),
      ElementsAre("message 5 \"a;b\"", "assign U4A0 I0A0", "message 6 \"Нет масла $5\"", "message 10 \"text\""));
  EXPECT_THAT(WarningsOf("$\nMSG 255 x"), ElementsAre("2:1 nc110-W364"));
}

// covers: NC110-099 NC110-169
TEST(Nc110Parser, LiteralsAndCounterWords) {
  const std::string longest(32, '~');
  EXPECT_THAT(ItemsOf("U4A0=\" \"*\"" + longest + "\""), ElementsAre("assign U4A0 (and \" \" \"" + longest + "\")"));
  EXPECT_THAT(ItemsOf("W1K0=[C5W-ENC(C6W)] U4A0=[C5W=C6W]"),
              ElementsAre("assign W1K0 (subtract C5W (ENC C6W))", "assign U4A0 (equal C5W C6W)"));
}

// covers: NC110-102
// The examples of the programming manual, with the damage of its print repaired.
TEST(Nc110Parser, ExamplesOfTheManual) {
  EXPECT_EQ(ItemsOf("T12I(10)=/T12U\nT2I(10)=/T3D T3I(10)=/T2D\nT7I(50)=I4K16+T7D\n"
                    "U4A8=[W3K0=33H]+U4A8*/I0A7*/T5U\nT5I(30)=U4A8\nU21K8=T5U+U21K8*/I0K1\n"
                    "C3I(2) = I2N0 U4A3 = [C3W=1]\n"
                    "C5I(4) = [C5W=0]*I4K17*/[W2K2=W15T0] + [C5W=1]*[W2K2=W0A0] +\n[C5W=2]*I0A8 + [C5W=3]*I0K27\n")
                .size(),
            10u);
  EXPECT_EQ(ItemsOf("DOF:I4K17\nW18K1=LOW(W4K0)\nW18K1=XCH(W18K1)\nW18K2=HIG(W4K0)\nENDF\n"
                    "DOF BLOCK1: U225K0\nU100K4=U100K8 * U00T0\nDOF BLOCK2: U123K0\nU100K3=U100K2\nEND F BLOCK2\n"
                    "U100K12=U100K3 * U00T0\nEND F BLOCK1\nW13K0=MUX(W1A0),(I1A1)\n"
                    "DOF: U100K1\nEND F\nDOE: U100K2\nW28K1=0FH\nU100K1=[W28K1=0FH] * I0A4\nEND E\n"
                    "DOE: U100K3\nW101K0=MUX(W28K1), (I0A4)\nEND E\nDOE:\nU104K0=U100K0\nEND E\nW102K0=BIN(W102K1)\n")
                .size(),
            26u);
}

TEST(Nc110Parser, EqualLiteralsAreOne) {
  Parsed parsed;
  ParseInto(parsed, {"U4A0=\"GO\"+\"STOP\" U4A1=\"GO\" U4A2=\"go\""});
  EXPECT_EQ(parsed.program.literals.size(), 3u);
}

TEST(Nc110Parser, CommentsBelongToItems) {
  Parsed parsed;
  ParseInto(parsed, {"; machine\n; 1999\n\n; lamp\nU4A0= ; inside\nI0A0 ; behind\n; next\n$ slow\n\n; end\n"});
  const Program& program = parsed.program;
  std::vector<std::pair<std::string, CommentPlace>> found;
  for (const Comment& comment : program.comments) {
    found.emplace_back(parsed.sources.Text(comment.range), comment.place);
  }
  EXPECT_THAT(found,
              ElementsAre(std::pair{"; machine", CommentPlace::kHeader}, std::pair{"; 1999", CommentPlace::kHeader},
                          std::pair{"; lamp", CommentPlace::kLeading}, std::pair{"; inside", CommentPlace::kInside},
                          std::pair{"; behind", CommentPlace::kTrailing}, std::pair{"; next", CommentPlace::kLeading},
                          std::pair{"slow", CommentPlace::kTrailing}, std::pair{"; end", CommentPlace::kRest}));
  EXPECT_EQ(program.files[0].header.count, 2u);
  EXPECT_EQ(program.items[ItemId(0)].first_comment, 2u);
  EXPECT_EQ(program.items[ItemId(0)].comment_count, 3u);
  EXPECT_EQ(program.items[ItemId(1)].comment_count, 2u);
  EXPECT_EQ(program.files[0].rest.count, 1u);
}

TEST(Nc110Parser, RangesReachFromFirstToLastToken) {
  Parsed parsed;
  ParseInto(parsed, {"/U4A0 = (I0A0 +\n I0A1) DOF A : I0A2\nENDF A"});
  const auto text = [&](uint32_t item) { return parsed.sources.Text(parsed.program.items[ItemId(item)].range); };
  EXPECT_EQ(text(0), "/U4A0 = (I0A0 +\n I0A1)");
  EXPECT_EQ(text(1), "DOF A : I0A2");
  EXPECT_EQ(text(2), "ENDF A");
}

}  // namespace
}  // namespace plcxx::nc110
