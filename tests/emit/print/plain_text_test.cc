// What a reader would not write himself is not printed: stores of what is there, ifs around nothing, negated
// comparisons.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
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

}  // namespace
}  // namespace plcxx::emit::print
