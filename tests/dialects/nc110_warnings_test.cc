#include "tests/dialects/nc110_lowered.h"

namespace plcxx::nc110 {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> WarningsOfSlow(const std::string& statements, const OptionMap& options = {}) {
  LoweredProgram lowered;
  LowerInto(lowered, {"$\n" + statements}, options);
  return lowered.Reported();
}

// covers: NC110-059 NC110-241
TEST(Nc110Warnings, ConnectorsOfPackageA) {
  EXPECT_THAT(WarningsOfSlow("U0A1=I4A1\nW19A3=W1K0"), ElementsAre("2 nc110-W310", "3 nc110-W310"));
  EXPECT_THAT(WarningsOfSlow("U4A1=I7A1\nU7A1=I0A1\nU4A2=I7A9\nW31A0=W1K0"),
              ElementsAre("2 nc110-W311", "5 nc110-W311"));
}

// covers: NC110-060 NC110-062 NC110-061
TEST(Nc110Warnings, SignalsOfTheControl) {
  EXPECT_THAT(WarningsOfSlow("U3K1=I0A1\nU9K17=I0A1\nU9K18=I0A1\nU9K19=I0A1\nW9K2=W1K0\nU157K0=I0A1"),
              ElementsAre("2 nc110-W313", "5 nc110-W313", "6 nc110-W313", "7 nc110-W313"));
  EXPECT_THAT(WarningsOfSlow("U30K1=I0A1"), IsEmpty());
  EXPECT_THAT(WarningsOfSlow("U30K1=I0A1\nU35K17=I0A1\nU60K1=I0A1", {{"processes", "2"}}), ElementsAre("2 nc110-W313"));
  EXPECT_THAT(WarningsOfSlow("U40N1=I0A1\nU40N2=I0A1\nU10N4=I0A1\nU41N0=I40N1"),
              ElementsAre("2 nc110-W312", "5 nc110-W312"));
}

// covers: NC110-241
TEST(Nc110Warnings, HighBytesOfPairs) {
  EXPECT_THAT(WarningsOfSlow("T5I(W12K0)=I0A1\nW12K1=0\nU4A0=I0A1"), IsEmpty());
  EXPECT_THAT(WarningsOfSlow("T5I(W12K3)=I0A1\nW13K0=W1K0\nU4A0=[W13K0>3]\nC5I(W13K0)=I0A1\nU13K7=I0A1"),
              ElementsAre("3 nc110-W314", "4 nc110-W314", "5 nc110-W314", "6 nc110-W314"));
}

// covers: NC110-232
TEST(Nc110Warnings, FreeMemoryThatNothingWrites) {
  EXPECT_THAT(WarningsOfSlow("U4A0=I50K3\nU4A1=I50K3\nU4A2=[W3T0=1]\nU4A3=I3K1*I0A1*I157K0*I40N0"),
              ElementsAre("2 nc110-W358", "4 nc110-W358"));
  EXPECT_THAT(WarningsOfSlow("U4A0=I50K3\nW50K0=5"), IsEmpty());
  EXPECT_THAT(WarningsOfSlow("U4A0=[W50K0=5]\nU50K3=I0A1"), IsEmpty());
  EXPECT_THAT(WarningsOfSlow("U4A0=I50K3+I3T0", {{"extern", "W50K0"}, {"t-init", "13=00"}}), IsEmpty());
  // The high byte of a pair stays 0.
  EXPECT_THAT(WarningsOfSlow("T5I(W50K0)=I0A1\nW50K0=5"), IsEmpty());
}

// covers: NC110-232
TEST(Nc110Warnings, SelfHoldWithoutReset) {
  EXPECT_THAT(WarningsOfSlow("U4A0=I0A1+U4A0"), ElementsAre("2 nc110-W359"));
  EXPECT_THAT(WarningsOfSlow("U4A0=I0A1*I0A2+I0A3+(I4A0+I0A4)"), ElementsAre("2 nc110-W359"));
  EXPECT_THAT(WarningsOfSlow("U4A0=I0A1+U4A0*/I0A2"), IsEmpty());
  EXPECT_THAT(WarningsOfSlow("U4A0=I0A1+U4A0\nDOF: I0A2 W4A0=0 ENDF"), IsEmpty());
}

TEST(Nc110Warnings, BcdAgainstDecimal) {
  EXPECT_THAT(WarningsOfSlow("U4A0=[W3K0=33]\nU4A1=[33H=W3K0]\nU4A2=[W3K0=9]\nU4A3=[10<W2K2]\nU4A4=[W12K1=20]"),
              ElementsAre("2 nc110-W365", "5 nc110-W365"));
}

}  // namespace
}  // namespace plcxx::nc110
