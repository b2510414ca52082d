// What a function's proof says of its result, its callers are proved with.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/verify/run_verify.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// The program's passes know that the percentage and the divisor are positive, and widen both without a sign; Clang's
/// compilation of the sources widens them with it. Neither product nor quotient has to be decided bit by bit.
TEST(Results, AFactorThatIsGivenIsPositive) {
  const std::string said = Verify("mill.cld",
                                  "#include \"plc.h\"\n"
                                  "int speed, top_speed;\n"
                                  "int percent() { return 50 + 10 * (X[1] & 7); }\n"
                                  "void drive()\n"
                                  "{\n"
                                  "    long dac = 0;\n"
                                  "    if (top_speed > 0)\n"
                                  "        dac = (long) speed * percent() / 100 * 4095 / top_speed;\n"
                                  "    if (dac > 4095)\n"
                                  "        dac = 4095;\n"
                                  "    Y[4] = (unsigned) dac & 0xFF;\n"
                                  "    Y[5] = (unsigned) dac >> 8;\n"
                                  "}\n"
                                  "void init() { plc1_time = 8; plc2_time = 16; }\n"
                                  "void plc1(void) { speed = X[2]; top_speed = X[3]; drive(); }\n"
                                  "void plc2(void) {}\n",
                                  "--front-end only");
  EXPECT_THAT(said, StartsWith("0 "));
  EXPECT_THAT(said, HasSubstr("drive, front end: proved"));
}

}  // namespace
}  // namespace plcxx::driver
