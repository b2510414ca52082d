// Which rungs the instructions become, written as text: "[a] [/b] ( x )".
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/report/program_fixture.h"
#include "transpiler/report/ladder.h"

namespace plcxx::report {
namespace {

std::string TextOf(const Element& element) {
  const auto joined = [&element](const char* between) {
    std::string text;
    for (const Element& part : element.parts) text += (text.empty() ? "" : between) + TextOf(part);
    return text;
  };
  std::string lines;
  for (const std::string& line : element.lines) lines += (lines.empty() ? "" : "; ") + line;
  switch (element.shape) {
    case Shape::kWire:
      return "--";
    case Shape::kNever:
      return "[0]";
    case Shape::kContact:
      return "[" + element.name + "]";
    case Shape::kNotContact:
      return "[/" + element.name + "]";
    case Shape::kCompare:
      return "[" + element.name + " " + element.title + " " + lines + "]";
    case Shape::kInvert:
      return "NOT";
    case Shape::kBox:
      return "{" + element.name + " " + element.title + " " + lines + "}";
    case Shape::kSeries:
      return joined(" ");
    case Shape::kParallel:
      return "<" + joined(" | ") + ">";
    case Shape::kCoil:
      return "(" + element.name + ")";
    case Shape::kSet:
      return "(S " + element.name + ")";
    case Shape::kReset:
      return "(R " + element.name + ")";
    case Shape::kTarget:
      return ">" + element.title;
  }
  return "?";
}

std::string TextOf(const std::vector<LadderItem>& items) {
  std::string text;
  for (const LadderItem& item : items) {
    if (item.kind == ItemKind::kStatement) continue;
    text += std::string(item.depth, '.');
    if (item.kind == ItemKind::kHead) text += "HEAD " + item.label;
    if (item.kind == ItemKind::kSection) text += "SECTION " + item.label;
    if (item.kind == ItemKind::kEnd) text += "END" + (item.label.empty() ? "" : " " + item.label);
    if (!item.rung.outputs.empty()) {
      if (item.kind != ItemKind::kRung) text += ": ";
      text += TextOf(item.rung.network);
      for (const Element& output : item.rung.outputs) text += " " + TextOf(output);
    }
    text += '\n';
  }
  return text;
}

std::string Ladder(const std::string& body, const std::string& more = "") {
  ProgramFixture fixture(std::string(kMemory) + more + "routine slow slow {\nbody {\n" + body + "}\n}\n", {});
  const CrossReference uses = MakeCrossReference(fixture.input());
  return TextOf(MakeLadders(fixture.input(), uses).front().items);
}

constexpr const char* kLoads = "%a = load a\n%b = load b\n%c = load c\n%d = load d\n";

TEST(LadderBuild, AndIsSeriesOrIsParallel) {
  EXPECT_EQ(Ladder(std::string(kLoads) + "%1 = and.bit %a %b\n%2 = or.bit %1 %c\n%3 = and.bit %2 %d\nstore x %3\n"),
            "<[a] [b] | [c]> [d] (x)\n");
}

TEST(LadderBuild, NotOfAnExpressionOpensItsContacts) {
  EXPECT_EQ(Ladder(std::string(kLoads) + "%1 = and.bit %a %b\n%2 = not.bit %1\nstore x %2\n"), "<[/a] | [/b]> (x)\n");
  EXPECT_EQ(Ladder("%1 = load w\n%2 = const i8 3\n%3 = ult.i8 %1 %2\n%4 = not.bit %3\nstore x %4\n"), "[w ≥ 3] (x)\n");
}

TEST(LadderBuild, ExclusiveOrOfContacts) {
  EXPECT_EQ(Ladder("%a = load a\n%b = load b\n%1 = xor.bit %a %b\nstore x %1\n"), "<[a] [/b] | [/a] [b]> (x)\n");
}

TEST(LadderBuild, OneValueForSeveralCoilsIsOneRung) {
  EXPECT_EQ(Ladder(std::string(kLoads) + "%1 = and.bit %a %b\nstore x %1\nstore y %1\n"), "[a] [b] (#4) (x) (y)\n");
}

TEST(LadderBuild, WordsAreBoxes) {
  EXPECT_EQ(Ladder("%1 = load w\n%2 = load v\n%3 = add.i8 %1 %2\nstore w %3\n"), "-- {w := w + v}\n");
}

TEST(LadderBuild, PlainBranchesEnableCoilsAndBoxes) {
  EXPECT_EQ(Ladder("%a = load a\nif %a {\n%1 = const bit 1\nstore x %1\n%0 = const bit 0\nstore y %0\n"
                   "%2 = const i8 7\nstore w %2\n}\n"),
            "[a] (S x) (R y) {w := 7}\n");
}

TEST(LadderBuild, OtherBranchesAreFrames) {
  EXPECT_EQ(Ladder("%a = load a\n%b = load b\nif %a {\n%1 = load c\nstore x %1\n} else {\nif %b {\n%2 = load d\nstore "
                   "y %2\n} else {\n%3 = load c\nstore z %3\n}\n}\n"),
            "HEAD IF: [a] >THEN\n.[c] (x)\nSECTION ELSE IF: [b] >THEN\n.[d] (y)\nSECTION ELSE\n.[c] (z)\nEND\n");
}

TEST(LadderBuild, TimersStandInTheirRung) {
  const std::string timer = "state T1 on_delay_timer\n";
  EXPECT_EQ(Ladder("%a = load a\n%1 = const i32 300\n%2 = const i32 0\nstep.on_delay T1 %a %1 %2\n", timer),
            "[a] {T1 OnDelay 300; 0}\n");
}

/// A block whose output is only a part of a network has to begin at the rail: in front, or as a rung of its own.
TEST(LadderBuild, BlocksWithOutputsBeginAtTheRail) {
  const std::string states = "state E1 edge_memory\nstate E2 edge_memory\n";
  EXPECT_EQ(Ladder("%a = load a\n%b = load b\n%1 = step.rising E1 %b\n%2 = and.bit %a %1\nstore x %2\n", states),
            "[b] {E1 Rising } [a] (x)\n");
  EXPECT_EQ(Ladder("%a = load a\n%b = load b\n%0 = step.rising E1 %a\n%1 = step.rising E2 %b\n%2 = and.bit %0 "
                   "%1\nstore x %2\n",
                   states),
            "[b] {E2 Rising } (#1)\n[a] {E1 Rising } [#1] (x)\n");
  EXPECT_EQ(Ladder("%a = load a\n%0 = step.rising E1 %a\n%1 = not.bit %0\nstore x %1\n", states),
            "[a] {E1 Rising } NOT (x)\n");
}

TEST(LadderBuild, LoopsSayHowTheyEnd) {
  EXPECT_EQ(
      Ladder("loop @1 guard 5 {\ncondition {\n%1 = load a\n}\nbody {\n%2 = load b\nstore x %2\nexit @1 if %2\n}\n}\n"),
      "HEAD LOOP 1, stopped after 5 rounds\n.[a] >WHILE\n.[b] (x) >→ END OF LOOP 1\nEND END OF LOOP 1\n");
}

TEST(LadderBuild, LocalsHaveTheNamesOfTheGeneratedCode) {
  ProgramFixture fixture(
      std::string(kMemory) + "routine slow slow {\nbody {\n%1 = load a\nstore x %1\nstore a %1\n}\n}\n", {});
  fixture.input().local_names = {"t7"};
  const CrossReference uses = MakeCrossReference(fixture.input());
  EXPECT_EQ(TextOf(MakeLadders(fixture.input(), uses).front().items), "[a] (t7) (x) (a)\n");
}

}  // namespace
}  // namespace plcxx::report
