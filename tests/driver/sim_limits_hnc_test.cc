// A program that takes for ever within one period.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

/// 2^30 calls in a period: each function calls the one before it twice.
std::string Doubling() {
  std::string text = "#include \"plc.h\"\nint f0(void) { return 1; }\n";
  for (int i = 1; i < 30; ++i) {
    const std::string before = "f" + std::to_string(i - 1) + "()";
    text += "int f" + std::to_string(i) + "(void) { return " + before + " + " + before + "; }\n";
  }
  return text +
         "void init(void) { plc1_time = 8; plc2_time = 16; }\nvoid plc1(void) { Y[0] = (unsigned char)f29(); }\nvoid "
         "plc2(void) {}\n";
}

TEST(SimLimits, TheTimeLimitHoldsWithinAPeriod) {
  const Workplace work;
  work.Write("exp.cld", Doubling());
  const auto begin = std::chrono::steady_clock::now();
  const Ran ran = work.Run("sim exp.cld --time-limit 1");
  EXPECT_EQ(ran.code, 1) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("stopped after 1 s of real time"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(SimLimits, AnEstimateAboveThePeriodIsAWarning) {
  const Workplace work;
  work.Write("exp.cld", Doubling());
  EXPECT_THAT(work.Run("check exp.cld").errors, ContainsRegex("of a period of 8000 us.*\\[plcxx-25\\]"));
}

/// A loop of some milliseconds in the fast part, which sets its time by itself.
std::string ChecksOfLoop(const std::string& time) {
  const Workplace work;
  work.Write("loop.cld",
             "#include \"plc.h\"\nunsigned n, p;\nvoid init(void) { plc1_time = 16; plc2_time = 32; }\n"
             "void plc1(void)\n{\n\tunsigned i;\n\n\tfor (i = 0; i < 5000; i++)\n\t\tn += i;\n\tY[0] = n;\n\t"
             "plc1_time = " +
                 time + ";\n}\nvoid plc2(void) { if (X[0]) p = 3; }\n");
  return work.Run("check loop.cld").errors;
}

TEST(SimLimits, AnEstimateIsComparedWithTheTimeThatTheProgramSets) {
  EXPECT_THAT(ChecksOfLoop("16"), Not(HasSubstr("[plcxx-25]")));
  EXPECT_THAT(ChecksOfLoop("p"), Not(HasSubstr("[plcxx-25]")));
}

}  // namespace
}  // namespace plcxx::driver
