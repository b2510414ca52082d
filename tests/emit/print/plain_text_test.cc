// What a reader would not write himself is not printed: stores of what is there, ifs around nothing, negated
// comparisons.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/ir/op.h"
#include "transpiler/ir/reader.h"

namespace plcxx::emit::print {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::string_view kPlaces = R"(
space m 12 volatile little
space r 8 routine little
place a bit m[0].0
place b bit m[0].1
place c bit m[0].2
place w i8 m[1]
place u i16 m[2]
place f f32 m[4]
place d i32 m[8]
place s bit r[0].0
place rounds i32 r[4]
statement s1 subject ONE
statement s2 subject TWO
host ask (width : i8) -> bit
)";

std::string Plain(std::string_view body, Flavour flavour = Flavour::kRelease) {
  const ir::Program program = ir::ReadOrDie(std::string(kPlaces) + "routine fast fast {\n" + std::string(body) + "}\n");
  return PrintCpp(legalize::Legalize(program, {.name = "p", .flavour = flavour}), source::SourceManager()).back().text;
}

TEST(PlainText, WhatIsThereIsNotStoredAgain) {
  const std::string source = Plain("stmt s1\n%0 = load a\nstore a %0\nstmt s2\n%0 = load b\nstore a %0\n");
  EXPECT_THAT(source, HasSubstr("  // ONE\n\n  // TWO\n  m[a] = m[b];\n"));
}

TEST(PlainText, WhatWasThereBeforeIsStoredAgain) {
  EXPECT_THAT(Plain("%0 = load a\n%1 = load b\nstore a %1\nstore a %0\n"), HasSubstr("  m[a] = t1;\n"));
}

TEST(PlainText, AnIfAroundNothingIsItsComments) {
  const std::string source = Plain("%0 = load a\nif %0 {\nstmt s1\nstmt s2\n}\n");
  EXPECT_THAT(source, HasSubstr("  // ONE\n"));
  EXPECT_THAT(source, HasSubstr("  // TWO\n"));
  EXPECT_THAT(source, Not(HasSubstr("if (")));
}

TEST(PlainText, ItsConditionMayHaveAnEffect) {
  EXPECT_THAT(Plain("%0 = load w\n%1 = host ask (%0)\nif %1 {\nstmt s1\n}\n"),
              HasSubstr("  ask(host, m[w]);\n  // ONE\n"));
}

TEST(PlainText, NegatedComparisonsOfIntegersHaveTheOtherOperator) {
  const auto negated = [](std::string_view comparison) {
    return Plain("%0 = load w\n%1 = const i8 7\n%2 = " + std::string(comparison) +
                 " %0 %1\n%3 = not.bit %2\nstore a %3\n");
  };
  EXPECT_THAT(negated("eq.i8"), HasSubstr("m[a] = m[w] != 7;\n"));
  EXPECT_THAT(negated("ne.i8"), HasSubstr("m[a] = m[w] == 7;\n"));
  EXPECT_THAT(negated("ult.i8"), HasSubstr("m[a] = m[w] >= 7;\n"));
  EXPECT_THAT(negated("ugt.i8"), HasSubstr("m[a] = m[w] <= 7;\n"));
  EXPECT_THAT(negated("slt.i8"), HasSubstr("m[a] = S8(m[w]) >= 7;\n"));
  EXPECT_THAT(negated("sge.i8"), HasSubstr("m[a] = S8(m[w]) < 7;\n"));
}

TEST(PlainText, OfFloatsTheyStayNegated) {
  EXPECT_THAT(Plain("%0 = load f\n%1 = const f32 1\n%2 = lt.f32 %0 %1\n%3 = not.bit %2\nstore a %3\n"),
              HasSubstr("m[a] = !(m[f] < "));
}

TEST(PlainText, LongLinesAreBrokenBetweenComparisons) {
  std::string body = "%0 = load u\n";
  std::string sum;
  for (uint32_t i = 1; i <= 9; ++i) {
    const std::string number = std::to_string(10 * i);
    body += "%" + number + " = load u\n%" + std::to_string(10 * i + 1) + " = const i16 " + number + "\n%" +
            std::to_string(10 * i + 2) + " = eq.i16 %" + number + " %" + std::to_string(10 * i + 1) + "\n";
    const std::string value = "%" + std::to_string(10 * i + 2);
    if (i > 1) body += "%" + std::to_string(10 * i + 3) + " = or.bit " + sum + " " + value + "\n";
    sum = i > 1 ? "%" + std::to_string(10 * i + 3) : value;
  }
  const std::string source = Plain(body + "store a " + sum + "\n");
  EXPECT_THAT(source, HasSubstr("\n      | (m[u] == "));
  EXPECT_THAT(source, Not(HasSubstr("\n      == ")));
}

TEST(PlainText, NegativeNumbersOf32BitsReadAsSuch) {
  const auto source = [](std::string_view operation) {
    return Plain("%0 = load d\n%1 = const i32 4294966796\n%2 = " + std::string(operation) + " %0 %1\nstore d %2\n");
  };
  EXPECT_THAT(source("add.i32"), HasSubstr("m[d] = Sub32(m[d], 500);\n"));
  EXPECT_THAT(source("add.i32"), HasSubstr("using plcxx::Sub32;\n"));
  EXPECT_THAT(source("add.i32"), Not(HasSubstr("using plcxx::Minus32;\n")));
  EXPECT_THAT(source("mul.i32"), HasSubstr("m[d] = Mul32(m[d], Minus32(500));\n"));
  EXPECT_THAT(source("mul.i32"), HasSubstr("using plcxx::Minus32;\n"));
  // One that is subtracted from is named as ever, on either side.
  const std::string both =
      Plain("%0 = const i32 4294967293\n%1 = const i32 4294967295\n%2 = add.i32 %0 %1\nstore d %2\n");
  EXPECT_THAT(both, HasSubstr("m[d] = Sub32(Minus32(3), 1);\n"));
  EXPECT_THAT(both, HasSubstr("using plcxx::Minus32;\n"));
  EXPECT_THAT(Plain("%0 = const i32 4294967293\n%2 = add.i32 %0 %0\nstore d %2\n"),
              HasSubstr("using plcxx::Minus32;\n"));
  // What declares it is included.
  const ir::Program program =
      ir::ReadOrDie(std::string(kPlaces) + "routine fast fast {\n%0 = const i32 4294967295\nstore d %0\n}\n");
  EXPECT_THAT(PrintCpp(legalize::Legalize(program, {.name = "p"}), source::SourceManager()).front().text,
              HasSubstr("#include <plcxx/" + std::string(ir::Info(ir::OpKind::kMinus32).header) + ">\n"));
  EXPECT_THAT(Plain("%0 = const i32 4294901760\nstore d %0\n"), HasSubstr("m[d] = 4294901760u;\n"));
}

TEST(PlainText, WhatIsComparedWithItsSignReadsAsSuch) {
  const auto source = [](std::string_view type, std::string_view place, std::string_view number) {
    return Plain("%0 = load " + std::string(place) + "\n%1 = const " + std::string(type) + " " + std::string(number) +
                 "\n%2 = slt." + std::string(type) + " %0 %1\nstore a %2\n");
  };
  EXPECT_THAT(source("i8", "w", "255"), HasSubstr("m[a] = S8(m[w]) < -1;\n"));
  EXPECT_THAT(source("i8", "w", "127"), HasSubstr("m[a] = S8(m[w]) < 127;\n"));
  EXPECT_THAT(source("i8", "w", "129"), HasSubstr("m[a] = S8(m[w]) < -127;\n"));
  EXPECT_THAT(source("i16", "u", "65535"), HasSubstr("m[a] = S16(m[u]) < -1;\n"));
  EXPECT_THAT(source("i16", "u", "32767"), HasSubstr("m[a] = S16(m[u]) < 32767;\n"));
  EXPECT_THAT(source("i32", "d", "4294967295"), HasSubstr("m[a] = S32(m[d]) < -1;\n"));
  EXPECT_THAT(source("i32", "d", "32767"), HasSubstr("m[a] = S32(m[d]) < 32767;\n"));
  EXPECT_THAT(source("i32", "d", "4294934529"), HasSubstr("m[a] = S32(m[d]) < -32767;\n"));
  // What no int of 16 bits holds stays the number that it is.
  EXPECT_THAT(source("i32", "d", "32768"), HasSubstr("m[a] = S32(m[d]) < S32(32768u);\n"));
  EXPECT_THAT(source("i32", "d", "4294934527"), HasSubstr("m[a] = S32(m[d]) < S32(4294934527u);\n"));
}

TEST(PlainText, ANumberThatNoIntHoldsHasNoSign) {
  const auto stored = [](const std::string& type, const std::string& place, const std::string& number) {
    return Plain("%0 = const " + type + " " + number + "\nstore " + place + " %0\n");
  };
  EXPECT_THAT(stored("i16", "u", "32767"), HasSubstr("m[u] = 32767;\n"));
  EXPECT_THAT(stored("i16", "u", "32768"), HasSubstr("m[u] = 32768u;\n"));
  EXPECT_THAT(stored("i32", "d", "32767"), HasSubstr("m[d] = 32767;\n"));
  EXPECT_THAT(stored("i32", "d", "65536"), HasSubstr("m[d] = 65536u;\n"));
}

TEST(PlainText, AComparisonWithTheEndOfAnyTypeIsCalledByName) {
  const auto compared = [](const std::string& operation, const std::string& place, const std::string& number) {
    const std::string type = operation.substr(operation.find('.') + 1);
    return Plain("%0 = load " + place + "\n%1 = const " + type + " " + number + "\n%2 = " + operation +
                 " %0 %1\nstore a %2\n");
  };
  EXPECT_THAT(compared("ugt.i8", "w", "254"), HasSubstr("m[a] = m[w] > 254;\n"));
  EXPECT_THAT(compared("ugt.i16", "u", "65535"), HasSubstr("m[a] = Greater16(m[u], 65535u);\n"));
  EXPECT_THAT(compared("ugt.i16", "u", "65534"), HasSubstr("m[a] = m[u] > 65534u;\n"));
  EXPECT_THAT(compared("ugt.i32", "d", "0xFFFFFFFF"), HasSubstr("m[a] = Greater32(m[d], 0xFFFFFFFF);\n"));
  EXPECT_THAT(compared("ugt.i32", "d", "0xFFFFFFFE"), HasSubstr("m[a] = m[d] > 0xFFFFFFFE;\n"));
  EXPECT_THAT(compared("ult.i16", "u", "0"), HasSubstr("m[a] = Less16(m[u], 0);\n"));
  EXPECT_THAT(compared("ult.i16", "u", "1"), HasSubstr("m[a] = m[u] < 1;\n"));
}

TEST(PlainText, ANumberInFrontOfAnOperatorNeedsNoBrackets) {
  EXPECT_THAT(Plain("%0 = const i8 5\n%1 = load w\n%2 = and.i8 %0 %1\nstore w %2\n"), HasSubstr("m[w] = 5 & m[w];\n"));
}

TEST(PlainText, MasksHaveAsManyDigitsAsTheirNumberNeeds) {
  const auto source = [](std::string_view number) {
    return Plain("%0 = load d\n%1 = const i32 " + std::string(number) + "\n%2 = and.i32 %0 %1\nstore d %2\n");
  };
  EXPECT_THAT(source("0x20"), HasSubstr("m[d] & 0x20;\n"));
  EXPECT_THAT(source("0x100"), HasSubstr("m[d] & 0x0100;\n"));
  EXPECT_THAT(source("0x10000"), HasSubstr("m[d] & 0x00010000;\n"));
  EXPECT_THAT(source("0xFF"), HasSubstr("m[d] & 0xFF;\n"));
  EXPECT_THAT(source("0xFFFF"), HasSubstr("m[d] & 0xFFFF;\n"));
  EXPECT_THAT(source("0xFFFFFFFF"), HasSubstr("m[d] & 0xFFFFFFFF;\n"));
  const ir::Program wide = ir::ReadOrDie(
      "space m 8 volatile little\nplace q i64 m[0]\nroutine fast fast {\n%0 = const i64 0x100000000\nstore q %0\n}\n");
  EXPECT_THAT(PrintCpp(legalize::Legalize(wide, {.name = "p"}), source::SourceManager()).back().text,
              HasSubstr("m[q] = 0x0000000100000000;\n"));
}

TEST(PlainText, WhatTheControlAssignsFirstIsInTheDeclaration) {
  const std::string own = Plain("%0 = const bit 1\nstore s %0\nstmt s1\n%1 = load s\nstore a %1\n");
  EXPECT_THAT(own, HasSubstr("  bool s = true;\n\n  // ONE\n  m[a] = s;\n"));
  // A statement's assignment is below its comment.
  EXPECT_THAT(Plain("stmt s1\n%0 = const bit 1\nstore s %0\n%1 = load s\nstore a %1\n"),
              HasSubstr("  bool s = false;\n\n  // ONE\n  s = true;\n"));
  // Behind something else it stays where it is.
  EXPECT_THAT(Plain("%0 = load b\nstore c %0\n%1 = const bit 1\nstore s %1\n%2 = load s\nstore a %2\n"),
              HasSubstr("  m[c] = m[b];\n  s = true;\n"));
}

/// The text of a subroutine that gives `s`.
std::string Giving(std::string_view body, Flavour flavour = Flavour::kRelease) {
  const ir::Program program =
      ir::ReadOrDie(std::string(kPlaces) + "routine sub subroutine -> bit s {\n" + std::string(body) +
                    "}\nroutine fast fast {\n%90 = call sub ()\nstore b %90\n}\n");
  const std::string source =
      PrintCpp(legalize::Legalize(program, {.name = "p", .flavour = flavour}), source::SourceManager()).back().text;
  const size_t begin = source.find(") noexcept {\n") + 13;
  return source.substr(begin, source.find("\n}\n", begin) + 1 - begin);
}

TEST(PlainText, AResultIsReturnedWhereItIsKnown) {
  EXPECT_EQ(Giving("stmt s1\n%0 = load a\nstore s %0\n"), "  // ONE\n  return m[a];\n");
  // Also early, and in each arm that nothing follows.
  EXPECT_EQ(Giving("block @1 {\nstmt s1\n%0 = load a\nif %0 {\nstore s %0\nexit @1\n}\nstmt s2\n%1 = load b\n"
                   "store s %1\n}\n"),
            "  // ONE\n  const bool t101 = m[a];\n  if (t101) {\n    return t101;\n  }\n\n  // TWO\n  return m[b];\n");
  EXPECT_EQ(Giving("%0 = load a\nif %0 {\n%1 = load b\nstore s %1\n} else {\n%2 = load c\nstore s %2\n}\n"),
            "  if (m[a]) {\n    return m[b];\n  } else {\n    return m[c];\n  }\n");
}

TEST(PlainText, AResultThatIsNotAlwaysGivenIsAVariable) {
  EXPECT_EQ(Giving("%0 = load a\nif %0 {\n%1 = load b\nstore s %1\n}\n"),
            "  bool s = false;\n\n  if (m[a]) {\n    return m[b];\n  }\n  return s;\n");
  // What reads it on the way, too: the last one is returned.
  EXPECT_EQ(Giving("%0 = load a\nstore s %0\nstmt s1\n%1 = load s\n%2 = load b\n%3 = and.bit %1 %2\nstore c %3\nstmt "
                   "s2\n%4 = load c\n"
                   "store s %4\n"),
            "  bool s = false;\n\n  s = m[a];\n\n  // ONE\n  m[c] = s & m[b];\n\n  // TWO\n  return m[c];\n");
  // What follows the assignment comes before the return.
  EXPECT_EQ(Giving("%0 = load a\nstore s %0\n%1 = load b\nstore c %1\n"),
            "  bool s = false;\n\n  s = m[a];\n  m[c] = m[b];\n  return s;\n");
}

TEST(PlainText, InTheDebugFlavourAResultIsAVariable) {
  EXPECT_THAT(Giving("stmt s1\n%0 = load a\nstore s %0\n", Flavour::kDebug),
              HasSubstr("  if (m.on(0)) {\n    s = m[a];\n  }\n  return s;\n"));
}

}  // namespace
}  // namespace plcxx::emit::print
