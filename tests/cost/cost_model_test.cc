#include "transpiler/cost/cost_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "transpiler/ir/items.h"
#include "transpiler/ir/reader.h"

namespace plcxx::cost {
namespace {

constexpr uint64_t kLoad = 20, kStore = 20, kLogic = 10, kBranch = 30, kCall = 120;  // prices.def, in ns

ir::Program ReadRoutines(std::string_view routines) {
  return ir::ReadOrDie(R"(
space m 16 volatile little
place a bit m[0].0
place b bit m[0].1
place w i8 m[1]
place row i8 m[0] stride 1 low 0 high 8 indexed
)" + std::string(routines));
}

Estimate Fast(std::string_view body) {
  const ir::Program program = ReadRoutines("routine fast fast {\n" + std::string(body) + "}\n");
  return EstimateRoutine(program, ir::RoutineId(0));
}
uint64_t Time(std::string_view body) { return Fast(body).total.time_ns; }

TEST(CostModel, StraightCodeIsASum) {
  EXPECT_EQ(Time(""), 0u);
  EXPECT_EQ(Time("%0 = load a\n%1 = not.bit %0\nstore b %1\n"), kLoad + kLogic + kStore);
  EXPECT_EQ(Fast("%0 = load a\n%1 = not.bit %0\nstore b %1\n").total.code_bytes, 4u + 2 + 4);
}

TEST(CostModel, OfAnIfTheDearerArmCounts) {
  EXPECT_EQ(Time("%0 = load a\nif %0 {\n store a %0\n} else {\n store a %0\n store b %0\n}\n"),
            kLoad + kBranch + 2 * kStore);
  EXPECT_EQ(Time("%0 = load a\nif %0 {\n store a %0\n}\n"), kLoad + kBranch + kStore);
  EXPECT_EQ(Fast("%0 = load a\nif %0 {\n store a %0\n} else {\n store b %0\n}\n").total.code_bytes, 4u + 4 + 4 + 4);
}

TEST(CostModel, CasesThatRunOnAddUp) {
  EXPECT_EQ(Time(R"(%0 = load w
%1 = load a
switch %0 {
  case 1 falls_through {
    store a %1
  }
  case 2 {
    store a %1
  }
  default {
    store a %1
  }
}
)"),
            2 * kLoad + kBranch + 2 * kStore);
}

TEST(CostModel, LoopsCostTheirBound) {
  EXPECT_EQ(Time("loop @1 proven 10 {\n condition {\n %0 = load a\n }\n body {\n %1 = load a\n }\n}\n"),
            kBranch + 10 * (kLoad + kLoad + kBranch) + kLoad);
  const uint64_t huge = Time(
      "loop @1 guard 18446744073709551615 {\n body {\n loop @2 guard 18446744073709551615 {\n body {\n %0 = load a\n "
      "}\n }\n }\n}\n");
  EXPECT_EQ(huge, uint64_t{1} << 56);  // saturates
}

TEST(CostModel, CallsCostWhatTheyCall) {
  const ir::Program program = ReadRoutines(
      "routine fast fast {\n stmt s1\n call sub ()\n call sub ()\n}\n"
      "routine sub subroutine {\n stmt s2\n %0 = load a\n store b %0\n}\n");
  const Estimate estimate = EstimateRoutine(program, ir::RoutineId(0));
  EXPECT_EQ(estimate.total.time_ns, 2 * (kCall + kLoad + kStore));
  EXPECT_EQ(estimate.statements.size(), 1u);  // the callee's are listed with the callee
}

TEST(CostModel, WhatManyCallIsPricedForAllOfThem) {
  const ir::Program program = ReadRoutines(
      "routine fast fast {\n call middle ()\n call sub ()\n}\n"
      "routine middle subroutine {\n call sub ()\n %0 = load a\n}\n"
      "routine sub subroutine {\n %0 = load a\n store b %0\n}\n");
  RoutineTimes known;
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const Estimate alone = EstimateRoutine(program, ir::RoutineId(i));
    const Estimate among_others = EstimateRoutine(program, ir::RoutineId(i), known);
    EXPECT_EQ(among_others.total.time_ns, alone.total.time_ns) << i;
    EXPECT_EQ(among_others.total.code_bytes, alone.total.code_bytes) << i;
  }
  EXPECT_EQ(known[1], kCall + 2 * kLoad + kStore);
  EXPECT_EQ(known[2], kLoad + kStore);
}

TEST(CostModel, BoundsOfAnIndexCost) {
  EXPECT_GT(Time("%0 = const i32 1\n%1 = load row[%0]\n"), Time("%0 = const i32 1\n%1 = load w\n"));
}

TEST(CostModel, ItemsAndStatements) {
  const ir::Program program = ReadRoutines(R"(
statement s3 closes
routine slow slow {
  body {
    stmt s1
    %0 = load a
    if %0 {
      stmt s2
      %0 = load a
      store b %0
    }
    stmt s3
    stmt s4
    %0 = load a
    if %0 {
      store b %0
    }
  }
  epilogue {
    %0 = load a
    store b %0
  }
}
)");
  const Estimate estimate = EstimateRoutine(program, ir::RoutineId(0));
  const uint64_t s1 = kLoad + kBranch, s2 = kLoad + kStore, s4 = kLoad + kBranch + kStore;
  EXPECT_THAT(estimate.item_weights, testing::ElementsAre(s1 + s2, s4));
  EXPECT_EQ(estimate.item_weights.size(), ir::Items(program, program.routines[ir::RoutineId(0)].body).size());
  EXPECT_EQ(estimate.total.time_ns, s1 + s2 + s4 + kLoad + kStore);
  EXPECT_EQ(estimate.time_us(), 1u);
  ASSERT_EQ(estimate.statements.size(), 4u);
  EXPECT_EQ(estimate.statements[0].own.time_ns, s1);
  EXPECT_EQ(estimate.statements[0].nested.time_ns, s2);
  EXPECT_EQ(estimate.statements[1].own.time_ns, s2);
  EXPECT_EQ(estimate.statements[2].own.time_ns, 0u);
  EXPECT_EQ(estimate.statements[3].own.time_ns, s4);  // its If holds no statement
  EXPECT_EQ(estimate.statements[3].nested.time_ns, 0u);
}

TEST(SlicesFor, TheRuleOfTheSpecification) {
  EXPECT_EQ(SlicesFor(3856, 2), 2);  // the manual's example
  EXPECT_EQ(SlicesFor(0, 2), 1);
  EXPECT_EQ(SlicesFor(2000, 2), 1);
  EXPECT_EQ(SlicesFor(2001, 2), 2);
  EXPECT_EQ(SlicesFor(1000000, 2), 64);
  EXPECT_EQ(SlicesFor(UINT64_MAX, 1), 64);
  EXPECT_EQ(SlicesFor(1, 0), 64);
}

}  // namespace
}  // namespace plcxx::cost
