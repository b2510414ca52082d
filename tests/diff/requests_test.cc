// plcxx diff: what happens only when the control has done what the program asked it for.
//
// A request stays until the control clears it, in a scenario until a step does: without such steps the program waits
// for ever, and nothing behind the wait could be told apart.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/diff/compared_texts.h"

namespace plcxx::review::diff {
namespace {

using testing::HasSubstr;

/// The run from power-on that shows how Q differs.
std::string RunThatShowsQ(const Diff& diff) {
  const DiffItem* const item = ItemNamed(diff, "Q");
  if (item == nullptr || !item->counterexample) return "none";
  EXPECT_EQ(item->verdict, ItemVerdict::kDifferent) << item->reason;
  EXPECT_EQ(item->counterexample->replay, Replay::kSimulator);
  EXPECT_FALSE(item->counterexample->from_state);
  return item->counterexample->steps;
}

TEST(Requests, WhatComesWhenOneIsDone) {
  const std::string program = R"(        DATA
IN0: DFM A
OUT0: DFM Q
BITY: DFM CEKA
        DATA_END
        MODULE_MAIN
        LDR CEKA
        LA -REQ_CLOSE_ALL
        @
        WR Q
        LDR A
        FL1 1,REQ_CLOSE_ALL
        LDR REQ_CLOSE_ALL
        WR CEKA
        MODULE_MAIN_END
        STOP
)";
  const Diff diff = ComparedTexts(kTechnol, With(program, ""), With(program, "LA -A"));
  EXPECT_EQ(RunThatShowsQ(diff), "A=1, slow 1, REQ_CLOSE_ALL=0, slow 1");
}

/// What the control answers depends on what it was asked, not on faults that the program has reported.
TEST(Requests, AFaultOfOneVersionChangesNoAnswer) {
  const std::string program = R"(        DATA
IN0: DFM A
OUT0: DFM Q
N: DS 2
X: DS 2
        DATA_END
        MODULE_MAIN
        LDR A
        FL1 1,REQ_CLOSE_ALL
        LDR REQ_CLOSE_ALL
        WR Q
        LOD N
        @
        STO X
        MODULE_MAIN_END
        STOP
)";
  const Diff diff = ComparedTexts(kTechnol, With(program, ""), With(program, "BIN"));
  EXPECT_EQ(NamesIn(diff), "calls of fault X ");
  for (const DiffItem& item : diff.items) EXPECT_EQ(item.verdict, ItemVerdict::kDifferent) << item.name;
}

/// They are loaded at power-on by programs that use them; the control writes nothing else then.
TEST(Requests, MachineConstantsOfOneVersionAlone) {
  const std::string program = R"(        DATA
IN0: DFM A
OUT0: DFM Q
N: DS 2
        DATA_END
        MODULE_INIT
        LOD @
        STO N
        MODULE_INIT_END
        MODULE_MAIN
        LDR A
        WR Q
        MODULE_MAIN_END
        STOP
)";
  const Diff diff = ComparedTexts(kTechnol, With(program, "CNST.5"), With(program, "DWRD.BUKON20"));
  EXPECT_EQ(NamesIn(diff), "calls of machine_constants N ");
  for (const DiffItem& item : diff.items) EXPECT_EQ(item.verdict, ItemVerdict::kDifferent) << item.name;
}

/// More periods than the solver looks at.
TEST(Requests, WhatComesWhenManyWereDone) {
  const std::string program = R"(        DATA
IN0: DFM A
OUT0: DFM Q
BITY: DFM CEKA
N: DS 1
        DATA_END
        MODULE_MAIN
        LDR CEKA
        LA -REQ_CLOSE_ALL
        JL0 DAL
        LOD N
        AD CNST.1
        STO N
DAL:    LOD N
        GT CNST.@
        WR Q
        LDR A
        FL1 1,REQ_CLOSE_ALL
        LDR REQ_CLOSE_ALL
        WR CEKA
        MODULE_MAIN_END
        STOP
)";
  const Diff diff = ComparedTexts(kTechnol, With(program, "8"), With(program, "9"));
  EXPECT_THAT(RunThatShowsQ(diff), HasSubstr("REQ_CLOSE_ALL=0"));
}

/// What the program clears itself is no request.
TEST(Requests, AFlagIsNotClearedByTheControl) {
  const std::string program = R"(        DATA
IN0: DFM A,B
OUT0: DFM Q
BITY: DFM CEKA,STAV
        DATA_END
        MODULE_MAIN
        LDR CEKA
        LA -STAV
        @
        WR Q
        LDR A
        FL1 1,STAV
        LDR STAV
        WR CEKA
        MODULE_MAIN_END
        STOP
)";
  const Diff diff = ComparedTexts(kTechnol, With(program, ""), With(program, "LA -A"));
  EXPECT_EQ(NamesIn(diff), "");
}

}  // namespace
}  // namespace plcxx::review::diff
