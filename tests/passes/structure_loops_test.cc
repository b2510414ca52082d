#include <gtest/gtest.h>

#include "tests/passes/passes_testing.h"
#include "transpiler/passes/nest_blocks.h"
#include "transpiler/passes/structure.h"

namespace plcxx::passes {
namespace {

std::string StructuredLoops(std::string_view body) {
  ir::Program program = ReadFast(body);
  for (const std::string& finding : ir::Verify(program, ir::Stage::kLowered)) ADD_FAILURE() << finding;
  Structure(program);
  return Body(program);
}

TEST(StructureLoops, AJumpBackMakesALoop) {
  EXPECT_EQ(StructuredLoops(R"(stmt s1
%0 = load b
store a %0
label L1
stmt s2
%0 = load a
store b %0
jump L1 if %0 budget rounds refused {
  store c %0
}
stmt s3
)"),
            R"(stmt s1
%0 = load b
store a %0
loop @1 budget 0 rounds {
  body {
    stmt s2
    %0 = load a
    store b %0
    repeat @1 if %0 refused {
      store c %0
    }
  }
}
stmt s3
)");
}

TEST(StructureLoops, WhatFollowsTheJumpInItsStatementIsInTheLoop) {
  EXPECT_EQ(StructuredLoops(R"(label L1
stmt s1
%0 = load a
jump L1 if %0 budget rounds
store b %0
stmt s2
)"),
            R"(loop @1 budget 0 rounds {
  body {
    stmt s1
    %0 = load a
    repeat @1 if %0
    store b %0
  }
}
stmt s2
)");
}

TEST(StructureLoops, LoopsNest) {
  EXPECT_EQ(StructuredLoops(R"(label L1
stmt s1
%0 = load a
store b %0
label L2
stmt s2
%0 = load b
jump L2 if %0 budget rounds
stmt s3
%0 = load c
jump L1 if %0 budget rounds
)"),
            R"(loop @1 budget 0 rounds {
  body {
    stmt s1
    %0 = load a
    store b %0
    loop @2 budget 0 rounds {
      body {
        stmt s2
        %0 = load b
        repeat @2 if %0
      }
    }
    stmt s3
    %0 = load c
    repeat @1 if %0
  }
}
)");
}

TEST(StructureLoops, OfCrossingLoopsTheSecondHeadIsReachedByWayOfTheFirst) {
  EXPECT_EQ(StructuredLoops(R"(label L1
stmt s1
%0 = load a
store b %0
label L2
stmt s2
%0 = load b
jump L1 if %0 budget rounds
stmt s3
%0 = load c
jump L2 if %0 budget rounds
)"),
            R"(%0 = const i32 0
store resume %0
loop @1 budget 0 rounds {
  body {
    %1 = const i32 1
    %2 = load resume
    %3 = eq.i32 %2 %1
    %4 = not.bit %3
    if %4 stays {
      stmt s1
      %0 = load a
      store b %0
    }
    stmt s2
    %0 = load b
    if %0 jumps {
      %1 = const i32 0
      store resume %1
      repeat @1
    }
    stmt s3
    %0 = load c
    if %0 jumps {
      %1 = const i32 1
      store resume %1
      repeat @1
    }
  }
}
)");
}

TEST(StructureLoops, ALoopEnteredInItsMiddleBeginsWhereTheWayInBegins) {
  EXPECT_EQ(StructuredLoops(R"(stmt s1
%0 = load a
jump L2 if %0
label L1
stmt s2
%0 = load b
store c %0
label L2
stmt s3
%0 = load c
jump L1 if %0 budget rounds
)"),
            R"(stmt s1
%0 = load a
%1 = const i32 0
store resume %1
loop @1 budget 0 rounds {
  body {
    %2 = const i32 1
    %3 = load resume
    %4 = eq.i32 %3 %2
    block @2 {
      %5 = not.bit %4
      if %5 stays {
        exit @2 if %0
      }
      stmt s2
      %0 = load b
      store c %0
    }
    stmt s3
    %0 = load c
    if %0 jumps {
      %1 = const i32 1
      store resume %1
      repeat @1
    }
  }
}
)");
}

std::string Nested(std::string_view body) {
  ir::Program program = ReadFast(body);
  Structure(program);
  NestBlocks(program);
  return Body(program);
}

TEST(NestBlocks, ExitsBecomeNestedIfs) {
  EXPECT_EQ(Nested(R"(stmt s1
%0 = load a
jump L1 if %0
stmt s2
%0 = load b
jump L1 if %0
stmt s3
%0 = load a
store c %0
label L1
stmt s4
)"),
            R"(stmt s1
%0 = load a
%1 = not.bit %0
if %1 stays {
  stmt s2
  %0 = load b
  %1 = not.bit %0
  if %1 stays {
    stmt s3
    %0 = load a
    store c %0
  }
}
stmt s4
)");
}

TEST(NestBlocks, AJumpOverTheOtherArmBecomesAnElse) {
  EXPECT_EQ(Nested(R"(stmt s1
%0 = load a
jump L1 if %0
stmt s2
%0 = load b
store c %0
jump L2
label L1
stmt s3
%0 = load c
store b %0
label L2
stmt s4
)"),
            R"(stmt s1
%0 = load a
%1 = not.bit %0
if %1 stays {
  stmt s2
  %0 = load b
  store c %0
} else {
  stmt s3
  %0 = load c
  store b %0
}
stmt s4
)");
}

TEST(NestBlocks, ExitsThatAnInnerBlockTakesOverNestAsWell) {
  const std::string text =
      Nested("%0 = load a\njump L1 if %0\nstore a %0\njump L2 if %0\nstore b %0\nlabel L1\nlabel L2\nstore c %0\n");
  EXPECT_EQ(text.find("exit"), std::string::npos) << text;
  EXPECT_EQ(text.find("block"), std::string::npos) << text;
}

TEST(NestBlocks, AnArmThatLeavesMakesTheRestTheOther) {
  const auto nested = [](std::string_view arms) {
    return Nested("%0 = load a\nif %0" + std::string(arms) + "\nstmt s2\n%0 = load b\nstore c %0\nlabel L1\nstmt s3\n");
  };
  EXPECT_EQ(nested(" {\n  store b %0\n  jump L1\n}"),
            "%0 = load a\nif %0 jumps {\n  store b %0\n} else {\n  stmt s2\n  %0 = load b\n  store c %0\n}\nstmt s3\n");
  EXPECT_EQ(nested(" {\n  store b %0\n} else {\n  jump L1\n}"),
            "%0 = load a\nif %0 stays {\n  store b %0\n  stmt s2\n  %0 = load b\n  store c %0\n} else {\n}\nstmt s3\n");
  // How it became an if before is not forgotten.
  EXPECT_EQ(nested(" stays {\n  store b %0\n  jump L1\n}"),
            "%0 = load a\nif %0 stays {\n  store b %0\n} else {\n  stmt s2\n  %0 = load b\n  store c %0\n}\nstmt s3\n");
}

TEST(NestBlocks, AnIfAtTheEndOfItsBlockLosesItsExits) {
  const auto nested = [](std::string_view arms) {
    return Nested("%0 = load a\nif %0" + std::string(arms) + "\nlabel L1\nstore a %0\n");
  };
  EXPECT_EQ(nested(" {\n  store b %0\n  jump L1\n} else {\n  store c %0\n  jump L1\n}"),
            "%0 = load a\nif %0 {\n  store b %0\n} else {\n  store c %0\n}\nstore a %0\n");
  EXPECT_EQ(nested(" {\n  store b %0\n  jump L1\n}"), "%0 = load a\nif %0 {\n  store b %0\n}\nstore a %0\n");
}

TEST(NestBlocks, AnArmThatLeavesAtItsEndNestsWhatLeavesBefore) {
  const std::string leaving = " {\n%1 = load b\nif %1 {\n%2 = load c\njump L1 if %2\nstore c %2\n}\njump L1\n}";
  const std::string rest = "\nstmt s2\n%0 = load b\nstore c %0\nlabel L1\nstmt s3\n";
  const std::string inner =
      "  %1 = load b\n  if %1 {\n    %2 = load c\n    %3 = not.bit %2\n    if %3 stays {\n      store c %2\n    }\n  "
      "}\n";
  const std::string other = "  stmt s2\n  %0 = load b\n  store c %0\n";
  EXPECT_EQ(Nested("%0 = load a\nif %0" + leaving + rest),
            "%0 = load a\nif %0 jumps {\n" + inner + "} else {\n" + other + "}\nstmt s3\n");
  EXPECT_EQ(Nested("%0 = load a\nif %0 {\nstore a %0\n} else" + leaving + rest),
            "%0 = load a\nif %0 stays {\n  store a %0\n" + other + "} else {\n" + inner + "}\nstmt s3\n");
}

TEST(NestBlocks, WhatIsNeverReachedStaysVisible) {
  EXPECT_EQ(Nested("stmt s1\njump L1\nstmt s2\n%0 = load a\nstore b %0\nlabel L1\n"),
            "stmt s1\n%0 = const bit 0\nif %0 stays {\n  stmt s2\n  %0 = load a\n  store b %0\n}\n");
}

TEST(NestBlocks, ABlockThatWouldNeedItsStatementsTwiceStays) {
  const std::string text = Nested(R"(stmt s1
%0 = load a
jump L1 if %0
%1 = load b
jump L1 if %1
stmt s2
%0 = load c
store b %0
jump L2
label L1
stmt s3
%0 = load c
store a %0
label L2
)");
  EXPECT_NE(text.find("exit @"), std::string::npos) << text;
}

}  // namespace
}  // namespace plcxx::passes
