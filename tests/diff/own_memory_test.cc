// plcxx diff: what is taken for the program's own, or for the exchange's, and is not. Each pair differs in a run that
// somebody who knew the manuals wrote down.
#include <gtest/gtest.h>

#include <string>

#include "tests/diff/compared_texts.h"

namespace plcxx::review::diff {
namespace {

/// What cannot be decided is not waited for.
const DiffOptions kSoon{.time_ms = 3000};

/// Not among what is equal, which is not listed.
void ExpectListed(const Diff& diff, const std::string& name) {
  EXPECT_NE(ItemNamed(diff, name), nullptr) << name << " is not among: " << NamesIn(diff);
}

TEST(OwnMemory, DirectOutputsAndInputsKeepTheirOrder) {
  const std::string program = ":MOD PM 0\n:A I 20.1\n:S F 251.0\n:END PM 0\n:MOD PM 9\n@:END PM 9\n";
  const std::string write = ":L IB 20\n:T PB 3\n", read = ":L PB 15\n:T OB 1\n";
  ExpectListed(ComparedTexts(kProstep, With(program, write + read), With(program, read + write), kSoon),
               "order of calls");
  EXPECT_TRUE(ComparedTexts(kProstep, With(program, write + read), With(program, write + read)).items.empty());
}

TEST(OwnMemory, WhatAnIndexMayReachIsNotWrittenForThat) {
  const std::string program = R"(        DATA
IN0: DFM KUS
OUT0: DFM CHOD
TAB: DS 4
M:  DFM M0,M1
        DATA_END
        MODULE_MAIN
        MOV BX,2
        LOD BYTE.IN0
        STO BYTE.TAB[BX]
        LDR KUS
        @
        WR CHOD
        MODULE_MAIN_END
        STOP
)";
  ExpectListed(ComparedTexts(kTechnol, With(program, "LA -M1"), With(program, "")), "CHOD");
}

TEST(OwnMemory, WhatTheNewVersionAloneReadsAnybodyMaySet) {
  const std::string program = R"(        DATA
IN0: DFM KUS
OUT0: DFM CHOD
@
        MODULE_MAIN_END
        STOP
)";
  const std::string
      without = "        DATA_END\n        MODULE_MAIN\n        LDR KUS\n        WR CHOD",
      with = "V:  DFM V0,V1\n        DATA_END\n        MODULE_MAIN\n        LDR KUS\n        LA -V1\n        WR CHOD";
  ExpectListed(ComparedTexts(kTechnol, With(program, without), With(program, with), kSoon), "CHOD");
}

TEST(OwnMemory, AFlagThatIsTakenBackInOtherWords) {
  const std::string program = "$\nU50K3 = /(/U50K3 + I0A3)\nU4A0 = @\n";
  ExpectListed(ComparedTexts(kNc110, With(program, "I0A1 + U50K3"), With(program, "I0A1")), "U4A0");
}

TEST(OwnMemory, WhatIsKeptAtAnotherMoment) {
  const std::string program = "U10K0 = @\nU1T0 = I0A1\n$\nU10K0 = 0\nU4A0 = U1T0\n";
  const testing_support::TemporaryDirectory directory;
  const auto side = [&](const std::string& name, const std::string& input) {
    compilation::CompilationRequest request;
    request.sources = {directory.Write(name + ".plc", With(program, input))};
    request.options = {{"old", "on"}};
    return MakeDiffSide(name, request);
  };
  DiffSide old_side = side("old", "I0A0"), new_side = side("new", "I0A2");
  ExpectListed(CompareSides(old_side, new_side, kSoon), "U1T0");
}

/// Nothing is claimed of a module that no schedule executes; who changes it reads that.
TEST(OwnMemory, AModuleThatTheHostAloneCallsIsNamed) {
  const std::string program = R"(        DATA
IN0: DFM KUS
OUT0: DFM CHOD,DVA
        DATA_END
        MODULE_MAIN
        LDR KUS
        WR DVA
        MODULE_MAIN_END
        MODULE_PANEL
        LDR KUS
        @
        WR CHOD
        MODULE_PANEL_END
        STOP
)";
  const Diff changed = ComparedTexts(kTechnol, With(program, "NOP"), With(program, "LA -DVA"), kSoon);
  EXPECT_TRUE(std::ranges::any_of(changed.not_looked_at, [](const std::string& what) {
    return what.find("module_panel") != std::string::npos;
  })) << ::testing::PrintToString(changed.not_looked_at);
  EXPECT_TRUE(ComparedTexts(kTechnol, With(program, "NOP"), With(program, ""), kSoon).not_looked_at.empty());
}

TEST(OwnMemory, WhatIsBetweenTheElementsOfAnIndex) {
  const std::string program = R"(#include "plc.h"
struct { int a; int b; } T[10];
int K;
void init() { plc1_time = 8; plc2_time = 16; }
void plc1() {}
void plc2() {
  if (K >= 0 && K < 10) T[K].a = X[1];
  Y[0] = @;
}
)";
  ExpectListed(ComparedTexts(kHnc, With(program, "T[3].b"), With(program, "0"), kSoon), "Y[0]");
  ExpectListed(ComparedTexts(kHnc, With(program, "*G[10]"), With(program, "0"), kSoon), "Y[0]");
}

/// Of a number in EAX one that no search guesses.
constexpr const char* kHash = R"(        MOV EBX,09E3779B1h
        MUL EBX
        MOV EBX,EAX
        SHR EBX,15
        XOR EAX,EBX
        MOV EBX,EAX
        MUL EBX
        ADD EAX,EBX
        MOV EBX,085EBCA77h
        MUL EBX
        MOV EBX,EAX
        SHR EBX,13
        XOR EAX,EBX
        MOV EBX,EAX
        MUL EBX
        ADD EAX,EBX
        MOV DWORD PTR X,EAX
        LOD DWRD.X
        EQ CNST.0BE2E6BF6h
)";

TEST(OwnMemory, WhatIsKeptMayBeAnythingBeforeTheFirstPowerOn) {
  const std::string program = R"(        DATA
IN0: DFM A
OUT0: DFM Q
M: DFM F
X: DS 4
        DATA_END
        MODULE_INIT
        MOV EAX,DWRD.LABEL_MEM
)" + std::string(kHash) + R"(        @
        WR F
        LOD CNST.12345678h
        STO DWRD.LABEL_MEM
        STO DWRD.X
        MODULE_INIT_END
        MODULE_MAIN
        LOD DWRD.LABEL_MEM
        NE CNST.3
        LA F
        LA A
        WR Q
        MODULE_MAIN_END
        STOP
)";
  ExpectListed(ComparedTexts(kTechnol, With(program, "NOP"), With(program, "LA -F\n        LA F"), kSoon), "Q");
}

TEST(OwnMemory, ARequestMayBeTakenBackBetweenTwoParts) {
  const std::string program = R"(        DATA
IN0: DFM A
OUT0: DFM Q
M: DFM F,G
X: DS 4
        DATA_END
        MODULE_MAIN
        MOV EAX,DWRD.IN4
)" + std::string(kHash) + R"(        LA G
        LA -REQ_CLOSE_ALL
        @
        WR Q
        LDR A
        FL1 1,REQ_CLOSE_ALL
        LOD CNST.0
        STO BYTE.M
        LOD CNST.00000000h
        STO DWRD.X
        MODULE_MAIN_END
        MODULE_FAST
        LDR REQ_CLOSE_ALL
        WR G
        MODULE_FAST_END
        STOP
)";
  ExpectListed(ComparedTexts(kTechnol, With(program, "NOP"), With(program, "LA -G"), kSoon), "Q");
}

}  // namespace
}  // namespace plcxx::review::diff
