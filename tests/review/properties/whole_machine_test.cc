// plcxx prove: what a machine does that a model of it may leave out: what the control says when power comes, requests
// that it takes back when it likes, memory between the elements that an index reaches, the fast part in every slice.
// None of these properties holds; each was "proved" once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/review/properties/prove_text.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(WholeMachine, ConstantsThatTheProgramReadsAtPowerOn) {
  const Workplace work;
  const Ran ran = Prove(work, "m.plc", R"(        DATA
IN0: DFM A
OUT0: DFM Q
M: DFM F
        DATA_END
        MODULE_INIT
        LOD DWRD.BUKON20
        NE CNST.0
        WR F
        MODULE_INIT_END
        MODULE_MAIN
        LDR F
        WR Q
        MODULE_MAIN_END
        STOP
)",
                        "never Q\n");
  EXPECT_EQ(ran.code, 1) << ran;
  ExpectShown(work);
  EXPECT_THAT(work.Read("found/property-1.yaml"), HasSubstr("- power_cycle: {}"));
}

TEST(WholeMachine, InputsThatAreOnWhenPowerComes) {
  const Workplace work;
  const Ran ran = Prove(work, "m.il",
                        "SLOW\nNETWORK \"a\"\nLDP %I0\nSET %B600\nNETWORK \"b\"\nLDI %I0\nRST %B600\nNETWORK \"c\"\n"
                        "LD %B600\nOUT %Q0\nEND_SLOW\n",
                        "%I0 for 20 ms implies %Q0\n");
  EXPECT_EQ(ran.code, 1) << ran;
  ExpectShown(work);
}

TEST(WholeMachine, ARequestIsTakenBackBetweenTwoParts) {
  const Workplace work;
  const Ran ran = Prove(work, "m.plc", R"(        DATA
IN0: DFM A
OUT0: DFM Q,BAD
M: DFM F,G
        DATA_END
        MODULE_MAIN
        LDR A
        FL1 1,REQ_CLOSE_ALL
        LOD CNST.0
        STO BYTE.M
        MODULE_MAIN_END
        MODULE_FAST
        LDR G
        LA -REQ_CLOSE_ALL
        FL1 1,BAD
        LDR REQ_CLOSE_ALL
        WR G
        MODULE_FAST_END
        STOP
)",
                        "never BAD\n");
  EXPECT_NE(ran.code, 0) << ran;
  EXPECT_THAT(ran.out, Not(HasSubstr("1 proved")));
}

TEST(WholeMachine, AnIndexDoesNotReachWhatIsBetweenItsElements) {
  const Workplace work;
  const Ran ran = Prove(work, "m.cld", R"(#include "plc.h"
struct { int a; int b; } T[10];
int K;
void init() { plc1_time = 8; plc2_time = 16; }
void plc1() {}
void plc2() {
  if (K >= 0 && K < 10) T[K].a = X[1];
  Y[0] = T[3].b;
}
)",
                        "never Y[0] = 1\n");
  EXPECT_EQ(ran.code, 1) << ran;
  ExpectShown(work);
}

TEST(WholeMachine, AnIndexThatReachesAllSaysNothing) {
  const Workplace work;
  const Ran ran = Prove(work, "m.cld", R"(#include "plc.h"
void init() { plc1_time = 8; plc2_time = 16; }
void plc1() {}
void plc2() { Y[0] = *G[10]; }
)",
                        "never Y[0] = 1\n");
  EXPECT_EQ(ran.code, 1) << ran;
  ExpectShown(work);
}

TEST(WholeMachine, TheFastPartRunsInEachSlice) {
  const Workplace work;
  const std::string fast = "T50I(10) = I0A0\nU4A0 = T50U\n", of_inputs = "U4A0 = I0A0\n";
  const std::string slow = "$\nU4A1 = I0A1*I0A2\nU4A2 = I0A1*I0A3\nU4A3 = I0A1*I0A4\nU4A4 = I0A1*I0A5\n";
  const Ran timed = Prove(work, "m.plc", fast + slow, "never U4A0 and not (I0A0 for 160 ms)\n", "--set slices=4");
  EXPECT_NE(timed.code, 0) << timed;
  EXPECT_THAT(timed.out, Not(HasSubstr("1 proved")));
  const Ran toggled =
      Prove(work, "m.plc", "U4A0 = /U4A0\n" + slow, "U4A0 is 0 implies U4A0 within 2 slow\n", "--set slices=2");
  EXPECT_NE(toggled.code, 0) << toggled;
  EXPECT_THAT(toggled.out, HasSubstr("1 violated"));
  const Ran plain = Prove(work, "m.plc", of_inputs + slow, "U4A0 implies I0A0\n", "--set slices=2");
  EXPECT_EQ(plain.code, 0) << plain;
}

/// What the program writes and never reads may be another before the last slice, too.
TEST(WholeMachine, OthersWriteBetweenSlices) {
  const std::string statement[] = {"U10N5=1", "U0A5=1", "U9K17=1"}, named[] = {"U10N5", "I0A5", "U9K17"};
  for (size_t i = 0; i < 3; ++i) {
    const Workplace work;
    const Ran ran =
        Prove(work, "m.plc", "$\n" + statement[i] + "\nU4A0=1\n", "always " + named[i] + "\n", "--set slices=2");
    EXPECT_EQ(ran.code, 1) << ran;
    ExpectShown(work);
  }
}

/// What holds with the slow part in one piece says nothing of slices, and what does not hold there neither.
TEST(WholeMachine, AFastPartThatRunsInEachSliceIsFollowed) {
  const Workplace work;
  const Ran violated =
      Prove(work, "m.plc", "U4A2=/U4A2&I0A1\n$\nU4A0=I0A1\nU4A1=I0A2\n", "never U4A2 and I0A3\n", "--set slices=2");
  EXPECT_EQ(violated.code, 1) << violated;
  ExpectShown(work);
  const Ran proved =
      Prove(work, "m.plc", "U4A2=/U4A2\n$\nU4A0=I0A1\nU4A1=I0A2\n", "always not U4A2\n", "--set slices=2");
  EXPECT_EQ(proved.code, 0) << proved;
}

TEST(WholeMachine, WhatIsStuckInOnePieceIsNotInSlices) {
  const Workplace work;
  const Ran changing = Prove(work, "m.plc", "$\nU50K0=I0A0\nU4A1=I0A1\nU4A2=I0A1\nU4A0=U50K0*/I0A0\n",
                             "U4A0 is never stuck within 1 slow\n", "--set slices=2");
  EXPECT_EQ(changing.code, 0) << changing;
  const Ran fast = Prove(work, "m.plc", "U5A0=I0A0*U50K0\n$\nU50K0=I0A1\nU4A0=I0A2\n",
                         "U5A0 is never stuck within 1 slow\n", "--set slices=2");
  EXPECT_EQ(fast.code, 0) << fast;
}

/// They wait for the first slice; an input may change behind it.
TEST(WholeMachine, TextsOfTheOperatorInSlices) {
  const Workplace work;
  const std::string source = "$\nU50K0=I0A0*\"GO\"\nU4A1=I0A1\nU4A2=I0A1\nU4A0=U50K0+I0A0\n";
  const Ran wrong = Prove(work, "m.plc", source, "never U50K0 and I0A0 is 0\n", "--set slices=2");
  EXPECT_EQ(wrong.code, 1) << wrong;
  EXPECT_THAT(wrong.out, Not(HasSubstr("1 proved")));
  const Ran proved = Prove(work, "m.plc", source, "U50K0 implies U4A0\n", "--set slices=2");
  EXPECT_EQ(proved.code, 0) << proved;
}

/// The control brings memory back by the byte; the last one has bits that no program can name.
TEST(WholeMachine, KeptBitsAreWhatTheyWere) {
  const Workplace work;
  const std::string source = "SLOW\nNETWORK\nLD %B500\nOUT %Q0\nLD %I0\nSET %B500\nLD %I1\nRST %B500\nEND_SLOW\n";
  const Ran ran = Prove(work, "m.il", source, "Q0 implies I0\n", "--dialect host50 --any-retentive");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.out, HasSubstr("B500=1, power cycle"));
  ExpectShown(work);
  // What the property alone names comes back, too.
  const Ran named = Prove(work, "m.plc", "$\nU4A0=I0A0\nDOF: I0A1\nU0T2=1\nENDF\n", "always U0T2 is 0 or I0A1\n",
                          "--set old=on --any-retentive");
  EXPECT_EQ(named.code, 1) << named;
  ExpectShown(work);
}

}  // namespace
}  // namespace plcxx::driver
