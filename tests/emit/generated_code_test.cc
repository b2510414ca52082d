// The generated C++ outside the tool: warnings of every compiler that is there, two machines in one process,
// sanitizers.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::emit {
namespace {

constexpr std::string_view kProgram = R"(; every kind of storage and statement
C7I(W20K0)=I0A2
P3=I0A3
$
U4A8=[W3K0=33H]+U4A8*/I0A7*/T5U
T5I(3)=U4A8
T6I(W0T0)=U4A8*U3T1
W27K0=MUX(W27K1,W27K2,5),(I0A1,T5U,/I0A3)
DOF TOOL: I0A1
U4A1=U27K3+"START"
ENDF TOOL
DOE: I0A2
W28K0=[W28K0+1]
ENDE
DOE:
U4A2=P3*/C7R
ENDE
C5I(3)=I0A0
U4A3=C5R&/I0A1
W29K0=BCD(W28K0)+/W27K0*0FH&XCH(ENC(W27K1))
U4A4=SGN[W28K0-3]+[W28K0>255]+[W28K0<0]
)";

constexpr std::string_view kHost = R"(
struct Host { uint32_t now; };
uint32_t now_ms(Host& host) noexcept { return host.now; }
void read_inputs(Host&, State&) noexcept {}
void write_outputs(Host&, const State&) noexcept {}
void retentive_store(Host&, const Retentive&) noexcept {}
void fault(Host&, fault_kind, uint32_t) noexcept {}
)";

bool Has(const std::string& compiler) { return std::system((compiler + " --version >/dev/null 2>&1").c_str()) == 0; }

class GeneratedCode : public testing::Test {
 protected:
  void SetUp() override {
    work_.Write("machine.plc", kProgram);
    ASSERT_EQ(work_.Run("emit machine.plc -o out --name machine").code, 0);
    ASSERT_EQ(work_.Run("emit machine.plc -o debug --name machine --debug").code, 0);
  }
  int Shell(const std::string& command) { return std::system(("cd '" + work_.Path("") + "' && " + command).c_str()); }

  const std::string include_ = " -I " PLCXX_ROOT "/runtime_support ";
  driver::Workplace work_;
};

TEST_F(GeneratedCode, IsFreeOfWarnings) {
  const std::string strict =
      " -O2 -Wall -Wextra -Wconversion -Wshadow -Werror -ffreestanding -fno-exceptions -fno-rtti" + include_ +
      "-c out/machine.cpp -o /dev/null";
  for (const std::string compiler : {"g++ -std=c++17", "g++ -std=c++20", "clang++-19 -std=c++17",
                                     "clang++-19 -std=c++20", "arm-none-eabi-g++ -std=c++17 -mcpu=cortex-m4 -mthumb",
                                     "riscv64-unknown-elf-g++ -std=c++17 -march=rv32imac -mabi=ilp32"}) {
    const std::string name = compiler.substr(0, compiler.find(' '));
    if (!Has(name)) {
      std::printf("without %s, which is not installed\n", name.c_str());
      continue;
    }
    EXPECT_EQ(Shell(compiler + strict), 0) << compiler;
  }
}

TEST_F(GeneratedCode, AWarningWouldBeSeen) {
  work_.Write("bad.cpp", "int f(int unused) { return 0; }\n");
  EXPECT_NE(Shell("g++ -Wall -Wextra -Werror -c bad.cpp -o /dev/null 2>/dev/null"), 0);
}

TEST_F(GeneratedCode, TheDebugFlavourCompiles) {
  EXPECT_EQ(Shell("g++ -std=c++17 -O1 -Wall -Wno-parentheses -Werror" + include_ + "-c debug/machine.cpp -o /dev/null"),
            0);
}

// covers: NC110-219 NC110-220
TEST_F(GeneratedCode, TwoMachinesInOneProcessShareNothing) {
  work_.Write("main.cpp", "#include \"out/machine.hpp\"\nnamespace machine {" + std::string(kHost) + R"(}
using namespace machine;
static State first, second;
int main() {
  Host host{0};
  init(first, host);
  init(second, host);
  for (int scan = 0; scan < 60; ++scan, host.now += 10) {
    first[W3K0] = 0x33;
    first[I0A0] = scan % 2 == 0;
    second[I0A2] = true;
    period(first, host);
    period(second, host);
  }
  // The first one latched U4A8 and timed it; the second one counted W28K0 up, and saw nothing of the first.
  if (!first[U4A8] || second[U4A8]) return 1;
  if (!first[T5U] || second[T5U]) return 2;
  if (first[W28K0] != 0 || second[W28K0] != 60) return 3;
  return 0;
}
)");
  EXPECT_EQ(Shell("g++ -std=c++17 -O1 -fsanitize=undefined -fno-sanitize-recover=all" + include_ +
                  "main.cpp out/machine.cpp -o two && ./two"),
            0);
}

TEST_F(GeneratedCode, CallsNothingOfTheSystem) {
  // covers: NC110-220
  EXPECT_EQ(Shell("g++ -std=c++17 -O2 -ffreestanding -fno-exceptions -fno-rtti" + include_ +
                  "-c out/machine.cpp -o machine.o && "
                  "! nm -u -C machine.o | grep -Ev "
                  "'machine::|memset|memcpy|memmove|memcmp|_GLOBAL_OFFSET_TABLE_|__stack_chk_fail'"),
            0);
}

}  // namespace
}  // namespace plcxx::emit
