#include "transpiler/passes/structure.h"

#include <gtest/gtest.h>

#include "tests/passes/passes_testing.h"

namespace plcxx::passes {
namespace {

std::string Structured(std::string_view body) {
  ir::Program program = ReadFast(body);
  EXPECT_TRUE(ir::Verify(program, ir::Stage::kLowered).empty());
  Structure(program);
  return Body(program);
}

TEST(Structure, AJumpOverStatementsBecomesAnIf) {
  EXPECT_EQ(Structured(R"(stmt s1
%0 = load a
jump L1 if %0
stmt s2
%0 = load b
store c %0
label L1
stmt s3
)"),
            R"(stmt s1
%0 = load a
%1 = not.bit %0
if %1 stays {
  stmt s2
  %0 = load b
  store c %0
}
stmt s3
)");
}

TEST(Structure, ANegatedConditionLosesItsNegation) {
  EXPECT_EQ(Structured("%0 = load a\n%1 = not.bit %0\njump L1 if %1\nstore b %0\nlabel L1\n"),
            "%0 = load a\n%1 = not.bit %0\nif %0 stays {\n  store b %0\n}\n");
}

TEST(Structure, AMarkerBeforeTheLabelStaysWithWhatFollows) {
  EXPECT_EQ(
      Structured("stmt s1\n%0 = load a\njump L1 if %0\nstmt s2\n%0 = load b\nstore c %0\nstmt s3\nlabel L1\n%0 = "
                 "load b\nstore c %0\n"),
      "stmt s1\n%0 = load a\n%1 = not.bit %0\nif %1 stays {\n  stmt s2\n  %0 = load b\n  store c %0\n}\nstmt s3\n%0 = "
      "load b\nstore c %0\n");
}

TEST(Structure, TwoJumpsToOneLabelMakeABlock) {
  EXPECT_EQ(Structured(R"(stmt s1
%0 = load a
jump L1 if %0
stmt s2
%0 = load b
jump L1 if %0
stmt s3
%0 = load a
store c %0
label L1
)"),
            R"(stmt s1
%0 = load a
block @1 {
  exit @1 if %0
  stmt s2
  %0 = load b
  exit @1 if %0
  stmt s3
  %0 = load a
  store c %0
}
)");
}

TEST(Structure, NestedJumpsNest) {
  EXPECT_EQ(Structured(R"(%0 = load a
%1 = load b
jump L1 if %0
store a %1
jump L2 if %1
store b %1
label L2
store c %1
label L1
)"),
            R"(%0 = load a
%1 = load b
%2 = not.bit %0
if %2 stays {
  store a %1
  %3 = not.bit %1
  if %3 stays {
    store b %1
  }
  store c %1
}
)");
}

TEST(Structure, OfCrossingJumpsTheLaterLabelBeginsEarlier) {
  EXPECT_EQ(Structured(R"(%0 = load a
%1 = load b
jump L1 if %0
store a %1
jump L2 if %1
store b %1
label L1
store c %1
label L2
store a %0
)"),
            R"(%0 = load a
%1 = load b
block @1 {
  %2 = not.bit %0
  if %2 stays {
    store a %1
    exit @1 if %1
    store b %1
  }
  store c %1
}
store a %0
)");
}

TEST(Structure, ThreeCrossingJumps) {
  EXPECT_EQ(Structured(R"(%0 = load a
jump L1 if %0
store a %0
jump L2 if %0
store b %0
label L1
jump L3 if %0
store c %0
label L2
store a %0
label L3
)"),
            R"(%0 = load a
block @1 {
  block @2 {
    %1 = not.bit %0
    if %1 stays {
      store a %0
      exit @2 if %0
      store b %0
    }
    exit @1 if %0
    store c %0
  }
  store a %0
}
)");
}

TEST(Structure, UnconditionalJumpsKeepTheStatementsBehindThem) {
  EXPECT_EQ(Structured("stmt s1\njump L1\nstmt s2\n%0 = load a\nstore b %0\nlabel L1\n"),
            "stmt s1\nblock @1 {\n  exit @1\n  stmt s2\n  %0 = load a\n  store b %0\n}\n");
}

TEST(Structure, JumpsOverNothingAndLabelsWithoutJumpsDisappear) {
  EXPECT_EQ(Structured("%0 = load a\njump L1 if %0\nlabel L1\njump L2\nlabel L3\nlabel L2\nstore b %0\n"),
            "%0 = load a\nstore b %0\n");
}

TEST(Structure, WhatFollowsTwoArmsThatLeaveStaysBehindThem) {
  // No path leads to it; in an arm it would be executed.
  EXPECT_EQ(Structured("%0 = load a\nif %0 {\n  store b %0\n  jump L1\n} else {\n  store c %0\n  jump L1\n}\nstore a "
                       "%0\nlabel L1\nstore b %0\n"),
            "%0 = load a\nblock @1 {\n  if %0 {\n    store b %0\n    exit @1\n  } else {\n    store c %0\n    exit "
            "@1\n  }\n  store a "
            "%0\n}\nstore b %0\n");
}

TEST(Structure, NestedRegionsAreStructuredToo) {
  EXPECT_EQ(
      Structured(
          "%0 = load a\nif %0 stays {\n jump L1 if %0\n store b %0\n label L1\n} else {\n jump L1\n label L1\n}\n"),
      "%0 = load a\nif %0 stays {\n  %1 = not.bit %0\n  if %1 stays {\n    store b %0\n  }\n} else {\n}\n");
}

TEST(Structure, BlocksOfEqualEndsNest) {
  EXPECT_EQ(Structured(R"(%0 = load a
jump L1 if %0
store a %0
jump L2 if %0
store b %0
label L1
label L2
store c %0
)"),
            R"(%0 = load a
%1 = not.bit %0
if %1 stays {
  block @1 {
    store a %0
    exit @1 if %0
    store b %0
  }
}
store c %0
)");
}

}  // namespace
}  // namespace plcxx::passes
