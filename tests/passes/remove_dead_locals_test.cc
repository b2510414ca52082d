#include "transpiler/passes/remove_dead_locals.h"

#include <gtest/gtest.h>

#include "tests/passes/passes_testing.h"

namespace plcxx::passes {
namespace {

std::string After(std::string_view routines) {
  ir::Program program = ReadRoutines(routines);
  RemoveDeadLocals(program);
  return Routines(program);
}
std::string AfterFast(std::string_view body) {
  ir::Program program = ReadFast(body);
  RemoveDeadLocals(program);
  return Body(program);
}

TEST(RemoveDeadLocals, AStoreThatNothingReadsGoes) {
  EXPECT_EQ(AfterFast("%0 = const i32 1\nstore rounds %0\n"), "%0 = const i32 1\n");
  EXPECT_EQ(AfterFast("%0 = const i32 1\nstore rounds %0\n%1 = load rounds\n"),
            "%0 = const i32 1\nstore rounds %0\n%1 = load rounds\n");
}

TEST(RemoveDeadLocals, AnOverwrittenStoreGoes) {
  EXPECT_EQ(AfterFast("%0 = const i32 1\nstore rounds %0\nstore rounds %0\n%1 = load rounds\n"),
            "%0 = const i32 1\nstore rounds %0\n%1 = load rounds\n");
}

TEST(RemoveDeadLocals, StoresToMemoryStay) {
  EXPECT_EQ(AfterFast("%0 = load a\nstore b %0\nstore b %0\n"), "%0 = load a\nstore b %0\nstore b %0\n");
}

TEST(RemoveDeadLocals, OneArmIsEnoughToKeepAStore) {
  const std::string body = R"(%0 = const i32 1
store rounds %0
%1 = load a
if %1 {
  store rounds %0
}
%2 = load rounds
)";
  EXPECT_EQ(AfterFast(body), body);
}

TEST(RemoveDeadLocals, BothArmsOverwrite) {
  EXPECT_EQ(AfterFast(R"(%0 = const i32 1
store rounds %0
%1 = load a
if %1 {
  store rounds %0
} else {
  store rounds %0
}
%2 = load rounds
)"),
            R"(%0 = const i32 1
%1 = load a
if %1 {
  store rounds %0
} else {
  store rounds %0
}
%2 = load rounds
)");
}

TEST(RemoveDeadLocals, AnExitLeadsBehindItsBlock) {
  const std::string body = R"(%0 = const i32 1
%1 = load a
block @1 {
  store rounds %0
  exit @1 if %1
  store rounds %0
}
%2 = load rounds
)";
  EXPECT_EQ(AfterFast(body), body);
}

TEST(RemoveDeadLocals, EachBitIsALocalAndWhatOverlapsStays) {
  const auto after = [](std::string_view body) {
    ir::Program program = ReadRoutines(
        "space more 8 routine little\nplace f0 bit more[0].0\nplace f1 bit more[0].1\nplace g0 bit more[0].0\n"
        "place byte i8 more[1]\nplace low bit more[1].0\nplace next bit more[2].0\nplace wide i32 more[4]\n"
        "place half i16 more[6]\nroutine fast fast {\n" +
        std::string(body) + "}\n");
    RemoveDeadLocals(program);
    return Body(program);
  };
  const std::string one = "%0 = const bit 1\n%1 = const i8 1\n%2 = const i32 1\n%3 = const i16 1\n";
  EXPECT_EQ(after(one + "store f0 %0\nstore f1 %0\n%4 = load f0\n"), one + "store f0 %0\n%4 = load f0\n");
  EXPECT_EQ(after(one + "store f1 %0\nstore f0 %0\n%4 = load f1\n"), one + "store f1 %0\n%4 = load f1\n");
  // Two names of one bit are one local.
  EXPECT_EQ(after(one + "store f0 %0\nstore g0 %0\n%4 = load f0\n"), one + "store g0 %0\n%4 = load f0\n");
  EXPECT_EQ(after(one + "store next %0\n"), one);
  for (const std::string store : {"store byte %1\n", "store low %0\n", "store wide %2\n", "store half %3\n"}) {
    EXPECT_EQ(after(one + store), one + store);
  }
}

TEST(RemoveDeadLocals, AnArmOfASwitchLeadsToTheNextOrBehindIt) {
  const auto with = [](std::string_view first, std::string_view second, std::string_view last) {
    return "%0 = const i32 1\n%1 = load w\nstore rounds %0\nswitch %1 {\n  case 1" + std::string(first) +
           "  }\n  case 2 {\n" + std::string(second) + "  }\n" + std::string(last) + "}\n%2 = load rounds\n";
  };
  const std::string_view store = "    store rounds %0\n";
  // Each arm overwrites it, and there is one for every value.
  const std::string other = "  default {\n    store rounds %0\n  }\n";
  const std::string all = with(" {\n    store rounds %0\n", store, other);
  std::string without = all;
  without.erase(without.find("store rounds"), 16);
  EXPECT_EQ(AfterFast(all), without);
  // One arm does not, or there is none for some values.
  for (const std::string& body :
       {with(" {\n", store, other), with(" {\n    store rounds %0\n", "", other),
        with(" {\n    store rounds %0\n", store, ""), with(" {\n    store rounds %0\n", store, "  default {\n  }\n")}) {
    EXPECT_EQ(AfterFast(body), body);
  }
  // The first arm runs on into the second, which overwrites what it stores.
  const std::string falls = with(" falls_through {\n    store rounds %0\n", store, other);
  EXPECT_EQ(AfterFast(falls), with(" falls_through {\n", store, other)
                                  .erase(without.find("store rounds") == 0 ? 0 : falls.find("store rounds"), 16));
  const std::string reads = with(" falls_through {\n    store rounds %0\n", "", other);
  EXPECT_EQ(AfterFast(reads), reads);
}

TEST(RemoveDeadLocals, InALoopWhatNoWayReadsGoes) {
  // The condition reads it in front of the first iteration, and behind each.
  const std::string condition = R"(%0 = const i32 1
store rounds %0
loop @1 guard 3 {
  condition {
    %1 = load rounds
    %2 = eq.i32 %1 %0
  }
  body {
    store rounds %0
  }
}
)";
  EXPECT_EQ(AfterFast(condition), condition);
  // A guard's region reads it when the guard ends the loop.
  const std::string exhausted = R"(%0 = const i32 1
loop @1 guard 3 {
  body {
    store rounds %0
  }
  exhausted {
    %1 = load rounds
    %2 = eq.i32 %1 %0
    store a %2
  }
}
)";
  EXPECT_EQ(AfterFast(exhausted), exhausted);
  // Overwritten at the beginning of each iteration, and read by nothing behind the loop.
  EXPECT_EQ(AfterFast(R"(%0 = const i32 1
loop @1 guard 3 {
  body {
    store rounds %0
    %1 = load rounds
    %2 = eq.i32 %1 %0
    store a %2
    store rounds %0
  }
}
)"),
            R"(%0 = const i32 1
loop @1 guard 3 {
  body {
    store rounds %0
    %1 = load rounds
    %2 = eq.i32 %1 %0
    store a %2
  }
}
)");
  // A repeat that the budget refuses leads behind the loop, as a way out does.
  const std::string refused = R"(%0 = const i32 1
%1 = load a
loop @1 budget 0 slice {
  body {
    store rounds %0
    exit @1 if %1
    store rounds %0
    repeat @1
  }
}
%2 = load rounds
)";
  EXPECT_EQ(AfterFast(refused), refused);
}

TEST(RemoveDeadLocals, APartOfTheScheduleHasItsOwnLocals) {
  EXPECT_EQ(After(R"(routine slow slow {
  %0 = load a
  store b %0
}
routine cycle schedule {
  %0 = const i32 1
  store rounds %0
  call slow ()
  %1 = load rounds
}
)"),
            R"(routine slow slow {
  %0 = load a
  store b %0
}
routine cycle schedule {
  %0 = const i32 1
  store rounds %0
  call slow ()
  %1 = load rounds
}
)");
}

TEST(RemoveDeadLocals, WhatAPartOfTheScheduleWritesIsNotItsCallersLocal) {
  const std::string routines = R"(routine slow slow {
  %0 = const i32 2
  store rounds %0
  %1 = load rounds
}
routine cycle schedule {
  %0 = const i32 1
  store rounds %0
  call slow ()
  %1 = load rounds
}
)";
  EXPECT_EQ(After(routines), routines);
}

TEST(RemoveDeadLocals, ALoopReadsWhatItsLastRoundLeft) {
  const std::string body = R"(%0 = const i32 5
store rounds %0
loop @1 budget 0 rounds {
  body {
    %1 = load a
    repeat @1 if %1
  }
}
)";
  EXPECT_EQ(AfterFast(body), body);
  const std::string carried = R"(%0 = const i32 5
store rounds %0
loop @1 guard 10 {
  body {
    %1 = load rounds
    store rounds %1
  }
}
)";
  EXPECT_EQ(AfterFast(carried), carried);
}

TEST(RemoveDeadLocals, WhatTheStepOfALoopReadsStays) {
  const std::string body = R"(%0 = const i32 5
loop @1 proven 3 {
  condition {
    %1 = load a
  }
  body {
    store rounds %0
  }
  step {
    %2 = load rounds
    %3 = eq.i32 %2 %0
    store b %3
  }
}
)";
  EXPECT_EQ(AfterFast(body), body);
}

TEST(RemoveDeadLocals, ASubroutineSharesItsCallersLocals) {
  const std::string routines = R"(routine callee subroutine {
  %0 = load rounds
  %1 = eq.i32 %0 %0
  store a %1
  store rounds %0
}
routine fast fast {
  %0 = const i32 1
  store rounds %0
  call callee ()
  %1 = load rounds
}
)";
  EXPECT_EQ(After(routines), routines);
}

TEST(RemoveDeadLocals, WhatNoCallerReadsIsDeadAtTheEndOfASubroutine) {
  EXPECT_EQ(After(R"(routine callee subroutine {
  %0 = load a
  store b %0
  %1 = const i32 3
  store rounds %1
}
routine fast fast {
  %0 = const i32 1
  store rounds %0
  call callee ()
  %1 = const i32 2
  store rounds %1
  %2 = load rounds
}
)"),
            R"(routine callee subroutine {
  %0 = load a
  store b %0
  %1 = const i32 3
}
routine fast fast {
  %0 = const i32 1
  call callee ()
  %1 = const i32 2
  store rounds %1
  %2 = load rounds
}
)");
}

TEST(RemoveDeadLocals, ALocalPassesThroughASubroutineThatLeavesItAlone) {
  const std::string routines = R"(routine callee subroutine {
  %0 = load a
  store b %0
}
routine fast fast {
  %0 = const i32 1
  store rounds %0
  call callee ()
  %1 = load rounds
}
)";
  EXPECT_EQ(After(routines), routines);
}

TEST(RemoveDeadLocals, WhatOneRoutineAloneReadsFirstIsKeptFromCallToCall) {
  const std::string routines = R"(routine callee subroutine {
  %0 = load rounds
  %1 = eq.i32 %0 %0
  store a %1
  store rounds %0
}
routine fast fast {
  call callee ()
  call callee ()
}
)";
  EXPECT_EQ(After(routines), routines);
}

TEST(RemoveDeadLocals, WhatOneRoutineAloneWritesFirstEndsWithIt) {
  EXPECT_EQ(After(R"(routine callee subroutine {
  %0 = const i32 1
  store rounds %0
  %1 = load rounds
  %2 = eq.i32 %1 %1
  store a %2
  store rounds %1
}
routine fast fast {
  call callee ()
  call callee ()
}
)"),
            R"(routine callee subroutine {
  %0 = const i32 1
  store rounds %0
  %1 = load rounds
  %2 = eq.i32 %1 %1
  store a %2
}
routine fast fast {
  call callee ()
  call callee ()
}
)");
}

TEST(RemoveDeadLocals, ParametersStay) {
  const std::string routines = R"(routine slow slow (slice : i32 = slice) {
  %0 = const i32 1
  store slice %0
}
)";
  EXPECT_EQ(After(routines), routines);
}

}  // namespace
}  // namespace plcxx::passes
