// Regions: branches, loops, blocks, calls, and statements that are switched off.
#include <gmock/gmock.h>

#include "tests/sim/test_program.h"

namespace plcxx::sim {
namespace {

using testing::ElementsAre;

/// N counts what is executed; A and B are inputs.
constexpr std::string_view kCounting = R"(
  space M 16 volatile little host_visible
  place A bit M[0].0
  place B bit M[0].1
  place N i8 M[1]
  place SELECTOR i8 M[2]
  place BUDGET i32 M[4]
  place PARAMETER i32 M[8]
  place RESULT i32 M[12]
  host fault (kind : i8, index : i32)
  routine add_one subroutine {
    %n = load N
    %one = const i8 1
    %sum = add.i8 %n %one
    store N %sum
  }
  routine add_ten subroutine {
    %n = load N
    %ten = const i8 10
    %sum = add.i8 %n %ten
    store N %sum
  }
  schedule period period
)";

Machine Counting(std::string_view body) {
  return Machine(std::string(kCounting) + "routine period schedule {\n" + std::string(body) + "}\n");
}

TEST(ControlFlow, If) {
  Machine machine = Counting("%a = load A\nif %a {\ncall add_one ()\n} else {\ncall add_ten ()\n}\n");
  machine.Run();
  EXPECT_EQ(machine.Get("N"), 10u);
  machine.Set("A", 1);
  machine.Run();
  EXPECT_EQ(machine.Get("N"), 11u);
}

TEST(ControlFlow, SwitchRunsOnWhereACaseFallsThrough) {
  Machine machine = Counting(R"(
    %s = load SELECTOR
    switch %s {
      case 1 2 {
        call add_one ()
      }
      default falls_through {
        call add_one ()
      }
      case 3 {
        call add_ten ()
      }
    }
  )");
  for (const auto& [selector, count] : std::vector<std::pair<int, unsigned>>{{1, 1}, {2, 1}, {3, 10}, {0, 11}}) {
    machine.Set("N", 0);
    machine.Set("SELECTOR", static_cast<uint64_t>(selector));
    machine.Run();
    EXPECT_EQ(machine.Get("N"), count) << selector;
  }
}

TEST(ControlFlow, SwitchWithoutAMatchDoesNothing) {
  Machine machine = Counting("%s = load SELECTOR\nswitch %s {\ncase 1 {\ncall add_one ()\n}\n}\n");
  machine.Run();
  EXPECT_EQ(machine.Get("N"), 0u);
}

TEST(ControlFlow, ProvenLoop) {
  Machine machine = Counting(R"(
    loop @1 proven 200 {
      condition {
        %n = load N
        %limit = const i8 7
        %more = ult.i8 %n %limit
      }
      body {
        call add_one ()
      }
    }
  )");
  machine.Run();
  EXPECT_EQ(machine.Get("N"), 7u);
}

TEST(ControlFlow, GuardEndsALoopAndTellsTheHost) {
  Machine machine = Counting(R"(
    loop @1 guard 5 {
      body {
        call add_one ()
      }
      exhausted {
        %kind = const i8 1
        %index = const i32 77
        host fault (%kind, %index)
      }
    }
    call add_ten ()
  )");
  machine.Run();
  EXPECT_EQ(machine.Get("N"), 15u);
  EXPECT_THAT(machine.simulator.TakeEvents(), ElementsAre(HostEvent{ir::HostFunctionId(0), {1, 77}}));
  EXPECT_TRUE(machine.simulator.TakeEvents().empty());
}

TEST(ControlFlow, LoopsShareABudget) {
  const auto loop = [](const std::string& number) {
    return "loop @" + number + " budget 0 BUDGET {\nbody {\ncall add_one ()\nrepeat @" + number +
           " refused {\ncall add_ten ()\n}\n}\n}\n";
  };
  Machine machine = Counting("%four = const i32 4\nstore BUDGET %four\n" + loop("1") + loop("2"));
  machine.Run();
  EXPECT_EQ(machine.Get("N"), 26u);  // five rounds and one, each loop refused once
  EXPECT_EQ(machine.Get("BUDGET"), 0u);
}

TEST(ControlFlow, ExitLeavesTheBlockThatItNames) {
  Machine machine = Counting(R"(
    block @1 {
      block @2 {
        %a = load A
        exit @1 if %a
        %b = load B
        exit @2 if %b
        call add_one ()
      }
      call add_ten ()
    }
  )");
  const auto run = [&](uint64_t a, uint64_t b) {
    machine.Set("N", 0);
    machine.Set("A", a);
    machine.Set("B", b);
    machine.Run();
    return machine.Get("N");
  };
  EXPECT_EQ(run(0, 0), 11u);
  EXPECT_EQ(run(0, 1), 10u);
  EXPECT_EQ(run(1, 0), 0u);
}

TEST(ControlFlow, ExitFromAnIfLeavesTheLoop) {
  Machine machine = Counting(R"(
    loop @1 guard 100 {
      body {
        call add_one ()
        %n = load N
        %three = const i8 3
        %enough = eq.i8 %n %three
        if %enough {
          exit @1
        }
      }
    }
  )");
  machine.Run();
  EXPECT_EQ(machine.Get("N"), 3u);
}

TEST(ControlFlow, CallsPassArgumentsAndGiveAResult) {
  Machine machine = Counting(R"(
    %three = const i32 3
    %r = call triple (%three)
    store BUDGET %r
  }
  routine triple subroutine (n : i32 = PARAMETER) -> i32 RESULT {
    %n = load PARAMETER
    %t = mul.i32 %n %n
    store RESULT %t
  )");
  machine.Run();
  EXPECT_EQ(machine.Get("BUDGET"), 9u);
}

TEST(ControlFlow, PrologueAndEpilogueAreExecutedAround) {
  Machine machine(std::string(kCounting) + R"(
    routine slow slow (slice : i8 = SELECTOR) sliced {
      prologue {
        call add_one ()
      }
      body {
        %n = load N
        %ten = const i8 10
        %sum = add.i8 %n %n
        store N %sum
      }
      epilogue {
        call add_ten ()
      }
    }
    routine period schedule {
      %zero = const i8 0
      call slow (%zero)
    }
  )");
  machine.Run();
  EXPECT_EQ(machine.Get("N"), 12u);
}

TEST(ControlFlow, SwitchedOffStatementIsSkippedUpToTheNext) {
  Machine machine = Counting(R"(
    stmt s1
    %a = load A
    if %a {
      call add_one ()
    } else {
      call add_ten ()
    }
    stmt s2
    call add_one ()
  )");
  machine.simulator.EnableStatement(ir::StatementId(0), false);
  machine.Run();
  EXPECT_EQ(machine.Get("N"), 1u);  // neither arm: the branch is how the statement computes, not a block of the source
  machine.simulator.EnableStatement(ir::StatementId(0), true);
  machine.simulator.EnableStatement(ir::StatementId(1), false);
  machine.Run();
  EXPECT_EQ(machine.Get("N"), 11u);
}

TEST(ControlFlow, SwitchedOffHeadIsAFalseCondition) {
  Machine machine(R"(
    statement s1 opens
    statement s2
    statement s3 opens
    statement s4
    statement s5 closes
    statement s6 closes
  )" + std::string(kCounting) +
                  R"(
    routine period schedule {
      stmt s1
      %a = load A
      if %a {
        stmt s2
        call add_one ()
        stmt s5
      } else {
        stmt s3
        %b = load B
        if %b {
          stmt s4
          call add_ten ()
          stmt s6
        }
      }
    }
  )");
  const auto run = [&](uint64_t a, uint64_t b) {
    machine.Set("N", 0);
    machine.Set("A", a);
    machine.Set("B", b);
    machine.Run();
    return machine.Get("N");
  };
  const auto enable = [&](uint32_t statement, bool enabled) {
    machine.simulator.EnableStatement(ir::StatementId(statement), enabled);
  };
  enable(0, false);
  EXPECT_EQ(run(1, 0), 0u);
  EXPECT_EQ(run(1, 1), 10u);  // the other arm, whose own head is still on
  enable(2, false);
  EXPECT_EQ(run(1, 1), 0u);
  enable(0, true);
  EXPECT_EQ(run(1, 1), 1u);
  EXPECT_EQ(run(0, 1), 0u);
  enable(4, false);  // the end of a block
  EXPECT_EQ(run(1, 1), 1u);
}

TEST(ControlFlow, WhatIsSwitchedOffInAnArmEndsWithTheArm) {
  Machine machine("statement s1 opens\nstatement s2\nstatement s3 closes\n" + std::string(kCounting) + R"(
    routine period schedule {
      stmt s1
      %a = load A
      if %a {
        stmt s3
        call add_one ()
        stmt s2
        call add_ten ()
      }
      call add_one ()
    }
  )");
  machine.Set("A", 1);
  machine.simulator.EnableStatement(ir::StatementId(1), false);
  machine.simulator.EnableStatement(ir::StatementId(2), false);  // what closes a block cannot be switched off
  machine.Run();
  EXPECT_EQ(machine.Get("N"), 2u);
}

TEST(ControlFlow, SwitchedOffHeadOfALoopMeansNoRound) {
  Machine machine("statement s1 opens\n" + std::string(kCounting) + R"(
    routine period schedule {
      stmt s1
      loop @1 guard 3 {
        body {
          call add_one ()
        }
      }
      stmt s2
      call add_ten ()
    }
  )");
  machine.simulator.EnableStatement(ir::StatementId(0), false);
  machine.Run();
  EXPECT_EQ(machine.Get("N"), 10u);
}

TEST(ControlFlow, SwitchedOffHeadSaysNothingAboutTheCalledRoutine) {
  Machine machine("statement s1 opens\n" + std::string(kCounting) + R"(
    routine nested subroutine {
      %a = load A
      if %a {
        call add_one ()
      }
    }
    routine period schedule {
      stmt s1
      call nested ()
    }
  )");
  machine.Set("A", 1);
  machine.simulator.EnableStatement(ir::StatementId(0), false);
  machine.Run();
  EXPECT_EQ(machine.Get("N"), 1u);
}

}  // namespace
}  // namespace plcxx::sim
