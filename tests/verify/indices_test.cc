// Elements by an index that is not known, in functions that are called in a loop: proved.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/verify/run_verify.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;

/// `body`: of the function `task`, which plc1 calls.
std::string Verified(const std::string& body) {
  return Verify("axes.cld",
                "#include \"plc.h\"\nunsigned char moved[3];\n" + body +
                    "void init() { plc1_time = 8; plc2_time = 16; }\nvoid plc1(void) { task(); }\nvoid plc2(void) {}\n",
                "--routine fast --front-end off");
}

constexpr const char* kProved = "axes: what was asked for is proved equal to the program";

/// A word of an axis is read, changed and written; the compiler writes the one byte of it that changes.
TEST(Indices, AWordOfAnAxisIsChanged) {
  EXPECT_THAT(Verified("void mark(int a, int on) {\n"
                       "  if (on) *axis_ctrl(a) |= 0x40; else *axis_ctrl(a) &= 0xFFBF;\n"
                       "}\n"
                       "void task() { mark(X[1] & 15, X[2] & 1); }\n"),
              HasSubstr(kProved));
}

/// The loop is unrolled, its three calls end as one, and the compiler knows which numbers the first function returns.
TEST(Indices, TheFirstAxisThatIsNotReadyIsStopped) {
  EXPECT_THAT(Verified("void task() {\n"
                       "  int a;\n"
                       "  for (a = 0; a < 3; a++) {\n"
                       "    if (!get_axis_den(a)) {\n"
                       "      set_axis_stop(a);\n"
                       "      return;\n"
                       "    }\n"
                       "  }\n"
                       "  *ch_ctrl(0) = *ch_ctrl(0) & ~7 | 2;\n"
                       "}\n"),
              HasSubstr(kProved));
}

/// What is read of an axis goes through a multiplication and a division; where the compiler computes it, more is known
/// of the axis than where the program does.
TEST(Indices, ANumberOfAnAxisIsComputed) {
  EXPECT_THAT(Verified("void move(int a) {\n"
                       "  int speed = *axis_stat(a) & 2 ? P_i[0] : P_i[1];\n"
                       "  if (X[3] & 1) {\n"
                       "    set_axis_jog(a, (int) ((long) speed * *ch_feedover(0) / 100));\n"
                       "    moved[a] = 1;\n"
                       "  } else if (moved[a]) {\n"
                       "    set_axis_home(a, 0);\n"
                       "    moved[a] = 0;\n"
                       "  }\n"
                       "}\n"
                       "void task() { int a = X[1] & 3; if (a < 3) move(a); }\n"),
              HasSubstr(kProved));
}

}  // namespace
}  // namespace plcxx::driver
