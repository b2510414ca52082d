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

}  // namespace
}  // namespace plcxx::review::diff
