// Every error of the specification's section 10.2 that the parser raises: place, code and words, and no second one.
#include "tests/dialects/nc110_parsing.h"

namespace plcxx::nc110 {
namespace {

using testing::ElementsAre;

void ExpectAll(const std::vector<Wrong>& table) {
  for (const Wrong& wrong : table) {
    ExpectWrong(wrong);
  }
}

TEST(Nc110Errors, WhatIsMeantIsTheRemedy) {
  const auto remedy = [](const std::string& text) {
    Parsed parsed;
    ParseInto(parsed, {"$\n" + text});
    return parsed.diagnostics.all().empty() ? "" : parsed.diagnostics.all().front().remedy;
  };
  EXPECT_THAT(remedy("U4A0=I0A0 I0A1\nU4A1=I0A2"), testing::HasSubstr("'I0A1' begins a statement here"));
  EXPECT_THAT(remedy("U4A0=(I0A0)/I0A1\nU4A1=I0A2"), testing::HasSubstr("'I0A1' begins a statement here"));
  EXPECT_THAT(remedy("P2\nU4A1=I0A2"), testing::HasSubstr("'P2' begins a statement: assign to it"));
  EXPECT_THAT(remedy("U4A0==I0A0"), testing::HasSubstr("'=' alone"));
  EXPECT_THAT(remedy("U4A0=I0A0)"), testing::HasSubstr("remove it"));
  EXPECT_THAT(remedy("P2(5)=I0A0"), testing::HasSubstr("only the inputs of timers and counters"));
  ExpectAll({
      {"C30I 200=I0A0", "1:6 nc110-2", {"modulus expected"}},
      {"T3I[20]=I0A0", "1:4 nc110-2", {"delay expected"}},
      {"U4.0=I0A0", "1:3 nc110-10", {"character"}},
  });
}

// covers: NC110-014 NC110-018 NC110-019 NC110-026 NC110-139 NC110-046 NC110-047 NC110-132 NC110-155 NC110-175 NC110-249
TEST(Nc110Errors, OperandsOutOfRange) {
  ExpectAll({
      {"U32A0=I0A0", "1:1 nc110-1", {"operand", "connector"}},
      {"U4A0=I16T0", "1:6 nc110-1", {"operand", "connector"}},
      {"U4A0=I256K0", "1:6 nc110-1", {"operand", "connector"}},
      {"U4A0=I256N0", "1:6 nc110-1", {"operand", "connector"}},
      {"U4A32=I0A0", "1:1 nc110-1", {"operand", "bit"}},
      {"U4A0=I0A99", "1:6 nc110-1", {"operand", "bit"}},
      {"W4K4=1", "1:1 nc110-1", {"operand", "word index"}},
      {"W4K0=W13K", "1:6 nc110-1", {"operand", "word index"}},
      {"W13K=5\nU4A0=I0A0", "1:1 nc110-1", {"operand", "word index"}},
      {"U4A0=I0A", "1:6 nc110-1", {"operand", "bit"}},
      {"C100I(5)=I0A0", "1:1 nc110-1", {"operand", "counter number"}},
      {"W4K0=C100W", "1:6 nc110-1", {"operand", "counter number"}},
      {"P100=I0A0", "1:1 nc110-1", {"operand", "one-shot number"}},
      {"U4A0=P100", "1:6 nc110-1", {"operand", "one-shot number"}},
      {"U4A0=P1000", "1:6 nc110-1", {"operand", "unknown identifier"}},
      {"T255I(5)=I0A0", "1:1 nc110-50", {"timer number"}},
      {"U4A0=T255U", "1:6 nc110-50", {"timer number"}},
      {"U4A0=I1000A0", "1:6 nc110-1", {"operand", "unknown identifier"}},
      {"U4A0=LAMP", "1:6 nc110-1", {"operand", "unknown identifier"}},
      {"LAMP=I0A0", "1:1 nc110-1", {"operand", "unknown identifier"}},
      {"W4K0=FFH", "1:6 nc110-1", {"operand", "unknown identifier"}},
      {"END", "1:1 nc110-1", {"operand", "unknown identifier"}},
      {"T5I(W31A3)=I0A0", "1:5 nc110-1", {"operand", "word pair"}},
      {"T5I(W15T3)=I0A0", "1:5 nc110-1", {"operand", "word pair"}},
      {"C5I(W255K3)=I0A0", "1:5 nc110-1", {"operand", "word pair"}},
      {"C5I(W255N3)=I0A0", "1:5 nc110-1", {"operand", "word pair"}},
  });
}

// covers: NC110-018
TEST(Nc110Errors, LettersInsteadOfDigitsAreSuggestedButNotReplaced) {
  ExpectAll({
      {"U4A0=IOA7", "1:6 nc110-1", {"operand", "I0A7"}},
      {"W4K0=COW", "1:6 nc110-1", {"operand", "C0W"}},
      {"TOI(5)=I0A0", "1:1 nc110-1", {"operand", "T0I"}},
      {"U4A0=10A7", "1:6 nc110-2", {"malformed number", "I0A7"}},
      {"D0F", "1:1 nc110-1", {"operand", "DOF"}},
  });
}

// covers: NC110-027 NC110-028 NC110-240 NC110-135 NC110-156
TEST(Nc110Errors, Numbers) {
  ExpectAll({
      {"W4K0=08O", "1:6 nc110-2", {"syntax", "malformed number"}},
      {"W4K0=0FF", "1:6 nc110-2", {"syntax", "malformed number"}},
      {"W4K0=5ENDF", "1:6 nc110-2", {"syntax", "malformed number"}},
      {"5ENDF", "1:1 nc110-2", {"syntax", "malformed number"}},
      {"W4K0=256", "1:6 nc110-NC100", {"constant"}},
      {"W4K0=100H", "1:6 nc110-NC100", {"constant"}},
      {"W4K0=99999999999999999999999999", "1:6 nc110-NC100", {"constant"}},
      {"U4A0=[W1K0=0FFFFFFFFFFFFFFFFFH]", "1:12 nc110-NC100", {"constant"}},
      {"T5I(0)=I0A0", "1:5 nc110-NC101", {"delay"}},
      {"T5I(256)=I0A0", "1:5 nc110-NC101", {"delay"}},
      {"C5I(1)=I0A0", "1:5 nc110-NC102", {"modulus"}},
      {"C5I(256)=I0A0", "1:5 nc110-NC102", {"modulus"}},
      {"C5I(400O)=I0A0", "1:5 nc110-NC102", {"modulus"}},
  });
}

// covers: NC110-085 NC110-148 NC110-200
TEST(Nc110Errors, Syntax) {
  ExpectAll({
      {"U4A0 I0A0", "1:6 nc110-2", {"syntax", "'=' expected"}},
      {"U4A0=", "1:6 nc110-2", {"syntax", "expected"}},
      {"U4A0=I0A0+ +I0A1", "1:12 nc110-2", {"syntax", "expected"}},
      {"U4A0=I0A0*\nU4A1=I0A1", "2:1 nc110-2", {"syntax", "expected"}},
      {"U4A0=(I0A0+I0A1\nU4A1=I0A1", "2:1 nc110-2", {"syntax", "')' expected"}},
      {"U4A0=I0A0)", "1:10 nc110-2", {"syntax", "statement"}},
      {"U4A0=I0A0,I0A1", "1:10 nc110-2", {"syntax"}},
      {"U4A0=I0A0 5", "1:11 nc110-2", {"syntax"}},
      {"W4K0=W1K0-W2K0", "1:10 nc110-2", {"syntax", "'-' is allowed only inside [ ]"}},
      {"W4K0=(W1K0-1)", "1:11 nc110-2", {"'-' is allowed only inside [ ]"}},
      {"W4K0=-5", "1:6 nc110-2", {"'-' is allowed only inside [ ]"}},
      {"W4K0=ENC(W1K0-1)", "1:14 nc110-2", {"'-' is allowed only inside [ ]"}},
      {"W4K0=[-W1K0]", "1:7 nc110-2", {"syntax", "expected"}},
      {"T5I=I0A0", "1:4 nc110-2", {"syntax", "delay expected"}},
      {"T5I()=I0A0", "1:5 nc110-2", {"syntax", "delay expected"}},
      {"C5I=I0A0", "1:4 nc110-2", {"syntax", "modulus expected"}},
      {"T5I(30=I0A0", "1:7 nc110-2", {"syntax", "')' expected"}},
      {"P6(3)=I0A0", "1:3 nc110-2", {"syntax", "'=' expected"}},
      {"U4A0(3)=I0A0", "1:5 nc110-2", {"syntax", "'=' expected"}},
      {"DOF I0A0\nU4A0=I0A1\nENDF", "2:1 nc110-2", {"syntax", "':' expected"}},
      {"DOF I0A0*I0A1\nU4A0=I0A1\nENDF", "1:9 nc110-2", {"syntax", "':' expected"}},
      {"DOF:\n I0A0 ENDF", "1:4 nc110-2", {"syntax", "condition expected"}},
      {"DOF: ;I0A0\nENDF", "1:4 nc110-2", {"syntax", "condition expected"}},
      {"DOF: U1K0=I0A0 ENDF", "1:4 nc110-2", {"syntax", "condition expected"}},
      {"DOF ENC: I0A0\nENDF", "1:5 nc110-2", {"syntax", "':' expected"}},
      {")", "1:1 nc110-2", {"syntax"}},
      {"U4A0=I0A0\n]\nU4A1=I0A0", "2:1 nc110-2", {"syntax"}},
      {"U4A0=[W1K0=1]]", "1:14 nc110-2", {"syntax"}},
  });
}

// covers: NC110-036 NC110-051 NC110-074 NC110-087 NC110-097 NC110-140 NC110-148 NC110-168 NC110-244
TEST(Nc110Errors, Types) {
  ExpectAll({
      {"U4A0=W1K0", "1:6 nc110-3", {"signal expected"}},
      {"U4A0=I0A0*C5W", "1:11 nc110-3", {"signal expected"}},
      {"U4A0=2", "1:6 nc110-3", {"signal expected"}},
      {"U4A0=I0A0*300", "1:11 nc110-3", {"signal expected"}},
      {"W4K0=I0A0", "1:6 nc110-3", {"word expected"}},
      {"W4K0=\"A\"", "1:6 nc110-3", {"word expected"}},
      {"W4K0=[W1K0+T5U]", "1:12 nc110-3", {"word expected"}},
      {"W4K0=ENC(I0A0)", "1:10 nc110-3", {"word expected"}},
      {"U4A0=[I0A0=3]", "1:7 nc110-3", {"word expected"}},
      {"U4A0=[W1K0=P3]", "1:12 nc110-3", {"word expected"}},
      {"U4A0=[(W1K0)=3]", "1:7 nc110-3", {"word expected"}},
      {"U4A0=[/W1K0=3]", "1:7 nc110-3", {"word expected"}},
      {"I0A0=I0A1", "1:1 nc110-3", {"input"}},
      {"T5U=I0A1", "1:1 nc110-3", {"read-only"}},
      {"T5D=I0A1", "1:1 nc110-3", {"read-only"}},
      {"C5R=I0A1", "1:1 nc110-3", {"read-only"}},
      {"/W4K0=1", "1:2 nc110-3", {"signal expected"}},
      {"/C5W=1", "1:2 nc110-3", {"signal expected"}},
      {"T5I(C5W)=I0A0", "1:5 nc110-3", {"parameter"}},
      {"T5I(I0A1)=I0A0", "1:5 nc110-3", {"parameter"}},
      {"C5I(ENC(W1K0))=I0A0", "1:5 nc110-3", {"parameter"}},
      {"DOF: W1K0\nENDF", "1:6 nc110-3", {"signal expected"}},
      {"W4K0=MUX(I0A0),(I0A1)", "1:10 nc110-3", {"word expected"}},
      {"W4K0=MUX(W1K0),(W1K1)", "1:17 nc110-3", {"signal expected"}},
  });
}

// covers: NC110-226
TEST(Nc110Errors, Msg) {
  ExpectAll({
      {"MSG 5\nU4A0=I0A0", "1:6 nc110-4", {"MSG", "text"}},
      {"MSG 5 \"\"", "1:9 nc110-4", {"MSG", "text"}},
      {"MSG \"text\"", "1:5 nc110-5", {"MSG", "number"}},
      {"MSG text", "1:5 nc110-5", {"MSG", "number"}},
      {"MSG", "1:4 nc110-5", {"MSG", "number"}},
      {"MSG 0 text", "1:5 nc110-6", {"MSG", "number"}},
      {"MSG 256 text", "1:5 nc110-6", {"MSG", "number"}},
      {"MSG 5 \"1234567890123456789012345678901234567890123\"", "1:8 nc110-7", {"MSG", "too long"}},
      {"MSG 5 one\nMSG 5 two", "2:5 nc110-8", {"MSG", "twice"}},
      {"MSG 5 \"one", "1:7 nc110-23", {"quote"}},
  });
}

// covers: NC110-127 NC110-128 NC110-129 NC110-130
TEST(Nc110Errors, Mux) {
  ExpectAll({
      {"W4K0=5+MUX(W1K0),(I0A0)", "1:8 nc110-9", {"MUX"}},
      {"W4K0=(MUX(W1K0),(I0A0))", "1:7 nc110-9", {"MUX"}},
      {"U4A0=I0A0*MUX(W1K0),(I0A0)", "1:11 nc110-9", {"MUX"}},
      {"U4A0=MUX(W1K0),(I0A0)", "1:1 nc110-9", {"MUX"}},
      {"W4K0=MUX W1K0,(I0A0)", "1:10 nc110-11", {"MUX", "'('"}},
      {"W4K0=MUX(W1K0),I0A0)", "1:16 nc110-11", {"MUX", "'('"}},
      {"W4K0=MUX(W1K0,(I0A0)", "1:16 nc110-3", {"word expected"}},
      {"W4K0=MUX(W1K0;)", "1:14 nc110-12", {"MUX", "')'"}},
      {"W4K0=MUX(W1K0),(I0A0\nU4A0=I0A0", "2:1 nc110-12", {"MUX", "')'"}},
      {"W4K0=MUX(W1K0)(I0A0)", "1:15 nc110-2", {"',' expected"}},
      {"W4K0=MUX(W1K0)\nU4A0=I0A0", "2:1 nc110-2", {"',' expected"}},
      {"W4K0=MUX(W1K0,W1K1),(I0A0)", "1:6 nc110-13", {"MUX", "number of"}},
      {"W4K0=MUX(1,2,3,4,5,6,7,8,9),(I0A0,I0A1,I0A2,I0A3,I0A4,I0A5,I0A6,I0A7,I0A8)",
       "1:26 nc110-13",
       {"MUX", "number of"}},
      {"W4K0=MUX(W1K0),(I0A0)+5", "1:22 nc110-14", {"MUX", "after"}},
      {"W4K0=MUX(W1K0),(I0A0)/I0A1", "1:22 nc110-14", {"MUX", "after"}},
  });
}

// covers: NC110-070 NC110-071
TEST(Nc110Errors, TooMuch) {
  const auto nested = [](size_t levels) {
    return "U4A0=" + std::string(levels, '(') + "I0A0" + std::string(levels, ')') + "\nU4A1=I0A1";
  };
  const auto long_sum = [](size_t operands) {
    std::string text = "U4A0=I0A0";
    for (size_t i = 1; i < operands; ++i) {
      text += "+I0A0";
    }
    return text + "\nU4A1=I0A1";
  };
  EXPECT_EQ(ItemsOf(nested(32)).size(), 2u);
  ExpectWrong({nested(33), "1:38 nc110-16", {"parenthes"}});
  ExpectWrong({nested(10000), "1:38 nc110-16", {"parenthes"}});
  EXPECT_EQ(ItemsOf(long_sum(1024)).size(), 2u);
  ExpectWrong({long_sum(1025), "1:5126 nc110-15", {"too complex"}});
  ExpectWrong({"W4K0=" + std::string(10000, '[') + "1", "1:7 nc110-2", {"syntax"}});
  EXPECT_EQ(ItemsOf("U4A0=" + std::string(10001, '/') + "I0A0"), std::vector<std::string>{"assign U4A0 (not I0A0)"});
}

// covers: NC110-086 NC110-094 NC110-095 NC110-245
TEST(Nc110Errors, Comparators) {
  ExpectAll({
      {"U4A0=[W1K0>=3]", "1:12 nc110-19", {"comparison"}},
      {"U4A0=[W1K0<=3]", "1:12 nc110-19", {"comparison"}},
      {"U4A0=[W1K0<>3]", "1:12 nc110-19", {"comparison"}},
      {"U4A0=[W1K0==3]", "1:12 nc110-19", {"comparison"}},
      {"U4A0=[=3]", "1:7 nc110-19", {"comparison"}},
      {"U4A0=[W1K0]", "1:11 nc110-19", {"comparison"}},
      {"U4A0=[W1K0 3]", "1:12 nc110-19", {"comparison"}},
      {"U4A0=[W1K0+1>W2K0]", "1:11 nc110-20", {"']'"}},
      {"U4A0=[W1K0>W2K0-1]", "1:16 nc110-20", {"']'"}},
      {"U4A0=[W1K0>W2K0 U4A1=I0A0", "1:17 nc110-20", {"']'"}},
      {"U4A0=[W1K0>W2K0\nU4A1=I0A0", "2:1 nc110-20", {"']'"}},
      {"U4A0=[W1K0+W2K0=3]\nU4A1=I0A0", "1:11 nc110-20", {"']'"}},
      {"W4K0=[W1K0+1", "1:13 nc110-20", {"']'"}},
      {"W4K0=[W1K0*2]", "1:11 nc110-20", {"']'"}},
      {"W4K0=[W1K0+1\nU4A1=I0A0", "2:1 nc110-20", {"']'"}},
  });
}

// covers: NC110-105
TEST(Nc110Errors, AsciiComparators) {
  ExpectAll({
      {"U4A0=\"\"", "1:6 nc110-21", {"ASCII", "empty"}},
      {"U4A0=\"123456789012345678901234567890123\"", "1:6 nc110-22", {"ASCII", "too long"}},
      {"U4A0=\"ABC\nU4A1=I0A0", "1:6 nc110-23", {"ASCII", "quote"}},
      {"U4A0=\"ПУСК\"", "1:7 nc110-10", {"character"}},
      {"U4A0=(\"ABC\nU4A1=I0A0", "1:7 nc110-23", {"ASCII", "quote"}},
  });
}

// covers: NC110-118 NC110-119
TEST(Nc110Errors, Functions) {
  const std::vector<std::string> names = {"DEC", "ENC", "BIN", "BCD", "LOW", "HIG", "XCH"};
  for (size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    const std::string misuse = " nc110-" + std::to_string(24 + i);
    const std::string open = " nc110-" + std::to_string(31 + i);
    ExpectWrong({"U4A0=I0A0*" + name + "(W1K0)*I0A1\nU4A1=I0A0", "1:11" + misuse, {name}});
    ExpectWrong({"W4K0=" + name + " W1K0\nU4A1=I0A0", "1:10" + misuse, {name}});
    ExpectWrong({"W4K0=" + name + "(W1K0\nU4A1=I0A0", "2:1" + open, {name, "')'"}});
    ExpectWrong({"W4K0=" + name + "(W1K0]", "1:14" + open, {name, "')'"}});
  }
  ExpectAll({
      {"U4A0=ABS(W1K0)", "1:6 nc110-18", {"ABS"}},
      {"W4K0=ABS W1K0", "1:10 nc110-18", {"ABS"}},
      {"W4K0=[ABS(W1K0]", "1:15 nc110-18", {"ABS"}},
      {"W4K0=SGN[W1K0]", "1:6 nc110-17", {"SGN"}},
      {"U4A0=SGN W1K0", "1:10 nc110-17", {"SGN"}},
      {"U4A0=SGN[W1K0)", "1:14 nc110-17", {"SGN"}},
      {"U4A0=SGN(W1K0", "1:14 nc110-17", {"SGN"}},
      {"U4A0=[SGN[W1K0]=1]", "1:7 nc110-17", {"SGN"}},
      {"ENC(W1K0)=5", "1:1 nc110-25", {"ENC"}},
  });
}

// covers: NC110-014
TEST(Nc110Errors, UnknownCharacters) {
  ExpectAll({
      {"U4A0=I0A0%I0A1", "1:10 nc110-10", {"character", "'%'", "U+0025"}},
      {"U4A0=I0A0 %%% I0A1", "1:11 nc110-10", {"character"}},
      {"#\nU4A0=I0A0", "1:1 nc110-10", {"character"}},
      {"U4A0=Ж0A0", "1:6 nc110-10", {"character", "U+0416"}},
      {"U4A0=\x01\x02\x03", "1:6 nc110-10", {"character", "U+0001"}},
      {"U4A0=!ПУСК", "1:7 nc110-10", {"character"}},
  });
}

// covers: NC110-015
TEST(Nc110Errors, CyrillicLookAlikes) {
  ExpectAll({
      {"U4A0=I1\u0410\u0417", "1:8 nc110-NC103", {"Cyrillic", "U+0410", "'A'"}},
      {"U4A0=I1A\u0417", "1:9 nc110-NC103", {"Cyrillic", "U+0417", "'3'"}},
      {"\u0422"
       "5I(30)=I0A0",
       "1:1 nc110-NC103",
       {"Cyrillic", "'T'"}},
      {"DOF: I0\u0430"
       "0\nENDF",
       "1:8 nc110-NC103",
       {"Cyrillic", "U+0430"}},
  });
  Parsed parsed;
  ParseInto(parsed, {"U4A0=I1\u0410\u0417"});
  ASSERT_EQ(parsed.diagnostics.all().size(), 2u);  // and W303
  const diag::Diagnostic& diagnostic = parsed.diagnostics.all()[1];
  ASSERT_EQ(diagnostic.fixits.size(), 2u);
  EXPECT_EQ(diagnostic.fixits[0].replacement, "A");
  EXPECT_EQ(diagnostic.fixits[1].replacement, "3");

  ParseOptions options;
  options.accept_homoglyphs = true;
  Parsed accepted;
  ParseInto(accepted,
            {"$\nU4\u0410"
             "0=I1\u0410"
             "3"},
            options);
  EXPECT_THAT(accepted.Errors(), testing::IsEmpty());
  EXPECT_THAT(accepted.Warnings(), ElementsAre("2:3 nc110-NC103"));
  EXPECT_THAT(accepted.Items(), ElementsAre("cycle-mark", "assign U4A0 I1A3"));
  ExpectWrong({"U4A0=I1A\u0417", "1:9 nc110-NC103", {"Cyrillic", "'3'"}}, options);
}

// covers: NC110-016
TEST(Nc110Errors, StrictCase) {
  ParseOptions options;
  options.strict_case = true;
  ExpectWrong({"u4a0=I0A0", "1:1 nc110-1", {"operand", "unknown identifier"}}, options);
  ExpectWrong({"dof: I0A0\nENDF", "1:1 nc110-1", {"operand"}}, options);
  ExpectWrong({"W4K0=2dh", "1:6 nc110-1", {"operand"}}, options);
  EXPECT_EQ(ItemsOf("DOF abc: I0A0 ENDF abc", options).size(), 2u);
}

// covers: NC110-001
TEST(Nc110Errors, ElevenFiles) {
  Parsed parsed;
  ParseInto(parsed, std::vector<std::string>(11, "U4A0=I0A0\n"));
  EXPECT_THAT(parsed.Errors(), ElementsAre("1:1 nc110-51"));
  EXPECT_THAT(parsed.TextOfFirstError(), testing::HasSubstr("source"));
  Parsed ten;
  ParseInto(ten, std::vector<std::string>(10, "U4A0=I0A0\n"));
  EXPECT_THAT(ten.Errors(), testing::IsEmpty());
  EXPECT_EQ(ten.program.items.size(), 10u);
}

// covers: NC110-229 NC110-230 NC110-255
TEST(Nc110Errors, EveryStatementReportsItsOwn) {
  Parsed parsed;
  ParseInto(parsed, {"U4A0=W1K0 W1K0=I0A0\nU4A1=[W1K0=\nU4A2=I0A0\nI0A0=1\nU4A3=I0A0**I0A1*W1K0\nU4A4=I0A0"});
  EXPECT_THAT(parsed.Errors(),
              ElementsAre("1:6 nc110-3", "1:16 nc110-3", "3:1 nc110-3", "4:1 nc110-3", "5:11 nc110-2"));
  EXPECT_EQ(parsed.program.items.size(), 7u);
}

TEST(Nc110Errors, FaultyItemsStayWhole) {
  Parsed parsed;
  ParseInto(parsed, {"U4A0=I0A0*W1K0+I0A1\n)\nW4K0=MUX(1),(I0A0,I0A1)\nT5I()=I0A0"});
  EXPECT_THAT(parsed.Items(), ElementsAre("assign U4A0 (or (and I0A0 error) I0A1) (faulty)", "error",
                                          "assign W4K0 (MUX) (faulty)", "assign T5I [error] I0A0 (faulty)"));
}

}  // namespace
}  // namespace plcxx::nc110
