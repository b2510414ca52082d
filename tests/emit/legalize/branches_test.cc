// How branches are written is in the record before anything is printed, and `plcxx print ir-emittable` shows it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/ir/reader.h"

namespace plcxx::emit::legalize {
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
place i i16 r[0]
place rounds i32 r[4]
statement s1 subject ONE
statement s2 subject TWO
)";

std::string Record(std::string_view body, Flavour flavour = Flavour::kRelease) {
  const ir::Program program = ir::ReadOrDie(std::string(kPlaces) + "routine fast fast {\n" + std::string(body) + "}\n");
  return print::PrintEmittable(Legalize(program, {.name = "p", .flavour = flavour}));
}

TEST(Branches, AnElseArmIsABlockOrGoesOnWithAChain) {
  const std::string_view store = "%9 = load c\nstore b %9\n";
  const auto record = [&](std::string_view arm) {
    return Record("stmt s1\n%0 = load a\nif %0 {\n%1 = load b\nstore c %1\n} else {\n" + std::string(arm) + "}\n");
  };
  EXPECT_THAT(record(store), HasSubstr("line: if, else\n"));
  EXPECT_THAT(record("%2 = load b\nif %2 {\n" + std::string(store) + "}\n"), HasSubstr("line: if, else if\n"));
  EXPECT_THAT(record("stmt s2\n%2 = load b\nif %2 {\n" + std::string(store) + "}\n"),
              HasSubstr("line: if, else if behind comments\n"));
  EXPECT_THAT(record("%2 = const bit 1\nif %2 {\n" + std::string(store) + "}\n"),
              HasSubstr("line: if, else of a chain\n"));
  // Something else in the arm: no chain.
  EXPECT_THAT(record("%2 = load b\nif %2 {\n" + std::string(store) + "}\n%3 = load a\nstore c %3\n"),
              HasSubstr("line: if, else\n"));
}

TEST(Branches, TheRecordIsIndentedAsTheFunction) {
  EXPECT_THAT(
      Record(
          "%0 = const i16 1\nstore i %0\n%1 = load a\nif %1 {\n%2 = load b\nstore c %2\n}\n%3 = load i\nstore i %3\n"),
      HasSubstr("\n  variable i"));
}

// What the source left by a jump is left by a word of C++, where nothing else follows; the other arm is not nested.
TEST(Branches, WhatAJumpOfTheSourceLeftIsLeftEarly) {
  const std::string_view jumps = "%0 = load a\nif %0 jumps {\nstmt s1\n} else {\nstmt s2\n%1 = load b\nstore c %1\n}\n";
  const std::string behind = "line: if, its arm ends by return, the other arm behind it\n";
  EXPECT_THAT(Record(jumps), HasSubstr(behind));
  // Both arms of a branch that the source wrote itself are nested.
  EXPECT_THAT(Record("%0 = load a\nif %0 {\nstmt s1\n} else {\nstmt s2\n%1 = load b\nstore c %1\n}\n"),
              HasSubstr("line: if, else\n"));
  // Something follows: a return would skip it.
  EXPECT_THAT(Record(std::string(jumps) + "%3 = load c\nstore a %3\n"), HasSubstr("line: if, else\n"));
  EXPECT_THAT(Record(jumps, Flavour::kDebug), HasSubstr("line: if, else"));
  EXPECT_THAT(Record("loop @1 proven 5 {\ncondition {\n%8 = load a\n}\nbody {\n" + std::string(jumps) + "}\n}\n"),
              HasSubstr("line: if, its arm ends by continue, the other arm behind it\n"));
  EXPECT_THAT(Record("%8 = load w\nswitch %8 {\ncase 1 {\n" + std::string(jumps) + "}\n}\n%9 = load a\nstore b %9\n"),
              HasSubstr("line: if, its arm ends by break, the other arm behind it\n"));
}

TEST(Branches, AnArmThatLeavesByItselfHasNoSecondWord) {
  EXPECT_THAT(Record("loop @1 proven 5 {\ncondition {\n%8 = load a\n}\nbody {\n%0 = load b\nif %0 jumps {\nexit @1\n} "
                     "else {\n%1 = load b\nstore c %1\n}\n}\n}\n%9 = load c\nstore a %9\n"),
              HasSubstr("line: if, the other arm behind it\n"));
}

// `if (a) { ... } else if (b) { return; } ...` would skip nothing after the first arm.
TEST(Branches, InAChainNoArmIsLeftEarly) {
  const std::string record = Record(
      "%0 = load a\nif %0 {\n%1 = load b\nstore c %1\n} else {\n%2 = load b\nif %2 jumps {\nstmt s1\n} else {\nstmt "
      "s2\n%3 = load c\nstore a %3\n}\n}\n");
  EXPECT_THAT(record, HasSubstr("line: if, else\n"));
  EXPECT_THAT(record, HasSubstr("line: if, its arm ends by return, the other arm behind it\n"));
}

TEST(Branches, AnArmOfASwitchEndsWithBreakUnlessItLeaves) {
  const std::string record = Record(
      "block @1 {\n%0 = load w\nswitch %0 {\ncase 1 {\nexit @1\n}\ncase 2 falls_through {\n%1 = load a\nstore b %1\n}\n"
      "default {\n%2 = load a\nstore c %2\n}\n}\n%3 = load b\nstore a %3\n}\n");
  EXPECT_THAT(record, HasSubstr("arms end with nothing fallthrough break"));
}

TEST(Branches, ALoopHasItsConditionInItsHeadWhereThatIsOneExpression) {
  const auto record = [&](std::string_view condition) {
    return Record("loop @1 proven 5 {\ncondition {\n" + std::string(condition) +
                  "}\nbody {\n%8 = load c\nstore a %8\n}\n}\n");
  };
  EXPECT_THAT(record("%0 = load a\n"), HasSubstr("condition in the head"));
}

TEST(Branches, OnlyTheDebugFlavourGuardsStatements) {
  const std::string_view body =
      "stmt s1\n%0 = load a\nstore b %0\nstmt s2\n%1 = load b\nif %1 {\n%2 = load c\nstore a %2\n}\n";
  EXPECT_THAT(Record(body), Not(HasSubstr("guard")));
  const std::string record = Record(body, Flavour::kDebug);
  EXPECT_THAT(record, HasSubstr("guard of ONE: 1 to 3\n"));
  EXPECT_THAT(record, HasSubstr("guard of TWO: 4 to 6\n"));
}

// Where a jump has put other statements into the arms, the statement is not switched off as a whole: an if of its own
// in the other arm asks for it, which a chain could not say.
TEST(Branches, InTheDebugFlavourAnIfThatAsksIsNoPartOfAChain) {
  const std::string_view body =
      "stmt s1\n%0 = load a\nif %0 jumps {\n%1 = load b\nstore c %1\n} else {\n%2 = load b\nif %2 {\n%3 = load "
      "a\nstore b %3\n}\n}\n";
  const std::string record = Record(body, Flavour::kDebug);
  EXPECT_THAT(record, HasSubstr("line: if, else, switched"));
  EXPECT_THAT(record, Not(HasSubstr("else if")));
}

}  // namespace
}  // namespace plcxx::emit::legalize
