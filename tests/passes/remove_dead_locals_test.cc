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
