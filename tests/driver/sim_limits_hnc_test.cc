// A program that takes for ever within one period.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;

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
  EXPECT_THAT(work.Run("check exp.cld").errors, HasSubstr("[plcxx-25]"));
}

}  // namespace
}  // namespace plcxx::driver
