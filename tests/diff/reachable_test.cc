// plcxx diff: versions that are equal in every state that can be reached, and not from an arbitrary one, in each
// dialect.
//
// A counter stops at its end; whether the end is asked for as "= 10" or as "> 9" makes no difference then.
#include <gtest/gtest.h>

#include <string>

#include "tests/diff/compared_texts.h"

namespace plcxx::review::diff {
namespace {

void ExpectEqualByInvariants(const Language& language, const std::string& program, const std::string& one,
                             const std::string& other) {
  const Diff diff = ComparedTexts(language, With(program, one), With(program, other));
  EXPECT_EQ(NamesIn(diff), "");
  EXPECT_GE(diff.invariants, 1U);
}

TEST(Reachable, TechnolSlowPart) {
  ExpectEqualByInvariants({"technol", ".plc"}, R"(        DATA
IN0: DFM KUS,NUL
OUT0: DFM PLNO
N: DS 1
        DATA_END
        MODULE_MAIN
        LOD N
        EQ CNST.10
        JL1 DAL
        LDR KUS
        JL0 DAL
        LOD N
        AD CNST.1
        STO N
DAL:    LDR NUL
        JL0 KONEC
        LOD CNST.0
        STO N
KONEC:  LOD N
        @
        WR PLNO
        MODULE_MAIN_END
        STOP
)",
                          "EQ CNST.10", "GT CNST.9");
}

TEST(Reachable, TechnolFastPartAloneReadsWhatTheSlowOneCounts) {
  ExpectEqualByInvariants({"technol", ".plc"}, R"(        DATA
IN0: DFM KUS,NUL
OUT0: DFM PLNO
N: DS 1
        DATA_END
        MODULE_MAIN
        LOD N
        EQ CNST.10
        JL1 DAL
        LDR KUS
        JL0 DAL
        LOD N
        AD CNST.1
        STO N
DAL:    LDR NUL
        JL0 KONEC
        LOD CNST.0
        STO N
KONEC:
LOD N
        @
        WR PLNO
        MODULE_MAIN_END
        STOP
)",
                          "EQ CNST.10", "GT CNST.9");
}

TEST(Reachable, TechnolFastPart) {
  ExpectEqualByInvariants({"technol", ".plc"}, R"(        DATA
IN0: DFM KUS,NUL
OUT0: DFM PLNO
N: DS 1
        DATA_END
        MODULE_FAST
        LOD N
        EQ CNST.10
        JL1 DAL
        LDR KUS
        JL0 DAL
        LOD N
        AD CNST.1
        STO N
DAL:    LDR NUL
        JL0 KONEC
        LOD CNST.0
        STO N
KONEC:  LOD N
        @
        WR PLNO
        MODULE_FAST_END
        MODULE_MAIN
        MODULE_MAIN_END
        STOP
)",
                          "EQ CNST.10", "GT CNST.9");
}

TEST(Reachable, Host50SlowPart) {
  ExpectEqualByInvariants({"host50", ".il"}, R"(SLOW
NETWORK
LD %I0
LT %W200, 10
OPRT %W200 = %W200 + 1
RUNG
LD %I1
OPRT %W200 = 0
RUNG
LD 1
@
OUT %Q0
END_SLOW
)",
                          "EQ %W200, 10", "GT %W200, 9");
}

TEST(Reachable, Host50FastPart) {
  ExpectEqualByInvariants({"host50", ".il"}, R"(FAST
NETWORK
LD %I0
LT %W200, 10
OPRT %W200 = %W200 + 1
RUNG
LD %I1
OPRT %W200 = 0
RUNG
LD 1
@
OUT %Q0
END_FAST
SLOW
NETWORK
LD %I2
OUT %Q1
END_SLOW
)",
                          "EQ %W200, 10", "GT %W200, 9");
}

TEST(Reachable, ProstepSlowPart) {
  ExpectEqualByInvariants({"prostep", ".plc"}, R"(:MOD PM 9
:L FW 100
:>=
: K 10
:JC DALEJ
:AN I 0.0
:JC DALEJ
:JU FM 13
:T FW 100
DALEJ :AN I 0.1
:JC KONI
:L
: K 0
:T FW 100
KONI :L FW 100
@
:= O 0.0
:END PM 9
:MOD PM 0
:A I 20.1
:S F 251.0
:END PM 0
)",
                          ":!=\n: K 10", ":>\n: K 9");
}

TEST(Reachable, ProstepFastPart) {
  ExpectEqualByInvariants({"prostep", ".plc"}, R"(:MOD PM 1
:L FW 100
:>=
: K 10
:JC DALEJ
:AN I 0.0
:JC DALEJ
:JU FM 13
:T FW 100
DALEJ :AN I 0.1
:JC KONI
:L
: K 0
:T FW 100
KONI :L FW 100
@
:= O 0.0
:END PM 1
:MOD PM 0
:A I 20.1
:S F 250.0
:END PM 0
)",
                          ":!=\n: K 10", ":>\n: K 9");
}

TEST(Reachable, HncSlowPart) {
  ExpectEqualByInvariants({"hnc", ".cld"}, R"(#include "plc.h"
static int n;
void init() { plc1_time = 16; plc2_time = 32; }
void plc1() { }
void plc2() {
  if ((X[0] & 1) && n < 10) n++;
  if (X[0] & 2) n = 0;
  Y[0] = n @;
}
)",
                          "== 10", "> 9");
}

TEST(Reachable, HncFastPart) {
  ExpectEqualByInvariants({"hnc", ".cld"}, R"(#include "plc.h"
static int n;
void init() { plc1_time = 16; plc2_time = 32; }
void plc2() { }
void plc1() {
  if ((X[0] & 1) && n < 10) n++;
  if (X[0] & 2) n = 0;
  Y[0] = n @;
}
)",
                          "== 10", "> 9");
}

TEST(Reachable, Nc110SlowPart) {
  ExpectEqualByInvariants({"nc110", ".plc"}, R"($
U4A8=@
DOF: I0A3*/U20K0
W30K0=[W30K0+1]
ENDF
DOF: [W30K0>23]
W30K0=0
ENDF
U20K0=I0A3
)",
                          "[W30K0=23]", "[W30K0>22]");
}

TEST(Reachable, Nc110FastPart) {
  ExpectEqualByInvariants({"nc110", ".plc"}, R"(U4A8=@
DOF: I0A3*/U20K0
W30K0=[W30K0+1]
ENDF
DOF: [W30K0>23]
W30K0=0
ENDF
U20K0=I0A3
$
U4A9=I0A4
)",
                          "[W30K0=23]", "[W30K0>22]");
}

/// The same without the stop: it is the stop that makes them equal, and no sloppiness of the proof.
TEST(Reachable, ACounterThatGoesOnIsSeenToDiffer) {
  const std::string endless = R"(        DATA
IN0: DFM KUS
OUT0: DFM PLNO
N: DS 1
        DATA_END
        MODULE_FAST
        LDR KUS
        JL0 DAL
        LOD N
        AD CNST.1
        STO N
DAL:
        MODULE_FAST_END
        MODULE_MAIN
        LOD N
        @
        WR PLNO
        MODULE_MAIN_END
        STOP
)";
  const Diff diff = ComparedTexts({"technol", ".plc"}, With(endless, "EQ CNST.10"), With(endless, "GT CNST.9"));
  const DiffItem* const item = ItemNamed(diff, "PLNO");
  ASSERT_NE(item, nullptr);
  EXPECT_EQ(item->verdict, ItemVerdict::kDifferent);
  ASSERT_TRUE(item->counterexample.has_value());
  EXPECT_EQ(item->counterexample->replay, Replay::kSimulator);
  EXPECT_FALSE(item->counterexample->from_state);
}

}  // namespace
}  // namespace plcxx::review::diff
