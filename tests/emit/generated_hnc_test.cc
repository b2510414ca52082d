// The generated C++ of an HNC program: its files and functions, targets without an operating system, the clock's wrap.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::emit {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view kMill = R"(#include "plc.h"
#include "lamps.h"
#include <math.h>
#pragma plcxx loop_bound(3)
struct axis { unsigned state : 3; int speed; long way; } axes[3];
int fast_calls, slow_calls;
float filtered;
void on_m(int ch) { if (mod_M_code(ch) != 4) mod_M_code(ch) = -1; }
void on_s(int ch) { mod_S_code(ch) = -1; }
void init()
{
    plc1_time = 16;
    plc2_time = 32;
    set_mst_func(0, 'M', on_m);
    if (P[0]) set_mst_func(0, 'S', on_s);
}
void plc1()
{
    int i;
    fast_calls++;
    for (i = 0; i < 3; i++) {
        axes[i].speed = (X[i] & 0x0F) * 10 / (X[10] + 1);
        axes[i].way += *axis_pout(i);
        axes[i].state++;
        set_axis_step(i, axes[i].speed);
    }
    filtered = filtered * 0.75 + sqrt(X[4]);
    lamps();
}
void plc2() { slow_calls++; R[X[7]] = Y[X[8] & 0x7F]; }
)";

class GeneratedHnc : public testing::Test {
 protected:
  void SetUp() override {
    work_.Write("lamps.h", "void lamps() { Y[0] = X[0] > 9 ? 1 : 0; }\n");
    work_.Write("mill.cld", kMill);
    const driver::Ran ran = work_.Run("emit mill.cld -o out --quiet");
    ASSERT_EQ(ran.code, 0) << ran;
  }
  /// The code of NAME.cld, in a folder of its name.
  std::string Emitted(const std::string& name) {
    const driver::Ran ran = work_.Run("emit " + name + ".cld -o " + name + " --quiet");
    EXPECT_EQ(ran.code, 0) << ran;
    return work_.Read(name + "/" + name + ".cpp");
  }
  int Shell(const std::string& command) { return std::system(("cd '" + work_.Path("") + "' && " + command).c_str()); }

  const std::string strict_ =
      " -O2 -Wall -Wextra -Wconversion -Wshadow -Werror -ffreestanding -fno-exceptions -fno-rtti "
      "-I " PLCXX_ROOT "/runtime_support ";
  driver::Workplace work_;
};

// covers: HNC-352
TEST_F(GeneratedHnc, SourceNamesTheFilesAlthoughAHeaderHasTheFirstStatement) {
  EXPECT_THAT(work_.Read("out/mill.hpp"),
              AllOf(HasSubstr("namespace mill"), HasSubstr("void cycle(State& m, uint32_t now_ms, Host& host)")));
}

// covers: HNC-331
TEST_F(GeneratedHnc, AFunctionHasAllLinesAboveItAndInItsHead) {
  work_.Write("noted.cld",
              "#include \"plc.h\"\n"
              "// steps of the tool change\n"
              "// one step a scan\n"
              "//\n"
              "void step(int ch)   // channel\n"
              "{ R[1] = ch; }\n"
              "/* coolant\n"
              " * pump 2 */\n"
              "int pump(a /* level */, b)\n"
              "int a; // wanted\n"
              "int b;\n"
              "{ return a > b; }\n"
              "void init() { plc1_time = plc2_time = 16; }\n"
              "void plc1() { step(1); R[2] = pump(R[3], R[4]); }\n"
              "void plc2() {}\n");
  const std::string code = Emitted("noted");
  EXPECT_THAT(code, HasSubstr("\n\n// steps of the tool change\n// one step a scan\n// channel\nstatic void step("));
  EXPECT_THAT(code, HasSubstr("\n\n// coolant\n// pump 2\n// level\n// wanted\nstatic uint16_t pump("));
}

// Above the first function, and what is about a declaration is not the file's.
TEST_F(GeneratedHnc, TheHeadOfAFileIsAboveItsFirstFunction) {
  work_.Write("pump.h", "// pump of the coolant\n\nint level;\n// lowest\nint low() { return level < 3; }\n");
  work_.Write("door.h", "// open or not\nint open;\nvoid door() { Y[1] = open; }\n");
  work_.Write("saw.cld",
              "/*\n * saw.cld, version 3\n */\n#include \"plc.h\"\n#include \"pump.h\"\n#include \"door.h\"\n"
              "void init() { plc1_time = plc2_time = 16; }\nvoid plc1() { Y[0] = low(); door(); }\nvoid plc2() {}\n");
  const std::string code = Emitted("saw");
  EXPECT_THAT(code, HasSubstr("\n\n// pump of the coolant\n\n// lowest\nstatic uint16_t low("));
  EXPECT_THAT(code, HasSubstr("\n\n// saw.cld, version 3\n\n// init()\nstatic void plc_init("));
  EXPECT_THAT(code, HasSubstr("\n\n// door()\nstatic void door("));
}

TEST_F(GeneratedHnc, SlotsAreConstantsWhereEveryRegistrationIsUnconditional) {
  EXPECT_THAT(work_.Read("out/mill.hpp"), AllOf(HasSubstr("handler_S0"), Not(HasSubstr("handler_M0"))));
  EXPECT_THAT(work_.Read("out/mill.cpp"), HasSubstr("on_m(m, 0"));
}

// covers: HNC-352
TEST_F(GeneratedHnc, CompilesForTargetsWithoutAnOperatingSystem) {
  const std::string heap = " | grep -E 'malloc|free|_Znw|_Zdl|__cxa'";
  struct Target {
    std::string compiler, options, nm;
  };
  for (const Target& target :
       {Target{"g++", "-std=c++17", "nm"}, Target{"clang++-19", "-std=c++17", "nm"},
        Target{"g++", "-std=c++17 -m32 -msse2 -mfpmath=sse", "nm"},
        Target{"clang++-19", "-std=c++17 -m32 -msse2", "nm"},
        Target{"arm-none-eabi-g++", "-std=c++17 -mcpu=cortex-m4 -mthumb", "arm-none-eabi-nm"},
        Target{"riscv64-unknown-elf-g++", "-std=c++17 -march=rv32imac -mabi=ilp32", "riscv64-unknown-elf-nm"}}) {
    if (Shell(target.compiler + " --version >/dev/null 2>&1") != 0) continue;
    const std::string compile = target.compiler + " " + target.options + strict_;
    EXPECT_EQ(Shell(compile + "-c out/mill.cpp -o mill.o"), 0) << target.compiler;
    EXPECT_NE(Shell(target.nm + " -u mill.o" + heap), 0) << target.compiler;
    const std::string sample = PLCXX_ROOT "/samples/hnc/mill_xk7132/generated/mill.cpp";
    EXPECT_EQ(Shell(compile + "-c " + sample + " -o sample.o"), 0) << target.compiler;
    EXPECT_NE(Shell(target.nm + " -u sample.o" + heap), 0) << target.compiler;
  }
}

// covers: HNC-115
TEST_F(GeneratedHnc, PeriodsGoOnWhenTheClockWraps) {
  work_.Write("main.cpp", R"(#include "out/mill.hpp"
namespace mill {
struct Host {};
#include "host.inc"
}
using namespace mill;
static State m;
int main() {
  Host host{};
  uint32_t now = 0xFFFFFFE0u;  // 32 ms before the wrap
  init(m, host);
  for (uint32_t i = 0; i < 65; ++i) cycle(m, now++, host);
  return m[fast_calls] == 5 && m[slow_calls] == 3 ? 0 : 1;
}
)");
  // Functions of the host that do nothing, from their declarations.
  const std::string header = work_.Read("out/mill.hpp");
  std::string host;
  for (size_t at = header.find("(Host& host"); at != std::string::npos; at = header.find("(Host& host", at + 1)) {
    const size_t line = header.rfind('\n', at) + 1;
    const std::string declaration = header.substr(line, header.find(';', at) - line);
    host += declaration + " {" + (declaration.starts_with("void") ? "" : " return 0; ") + "}\n";
  }
  work_.Write("host.inc", host);
  EXPECT_EQ(Shell("g++ -std=c++17 -w -I " PLCXX_ROOT "/runtime_support main.cpp out/mill.cpp -o mill && ./mill"), 0)
      << host;
}

}  // namespace
}  // namespace plcxx::emit
