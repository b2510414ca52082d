// The generated C++ of a HOST 50 program: what the integrator finds in the header, and what the object needs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::emit {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kLathe = R"(TITLE
BUILDER "Iron Works"
MACHINE "lathe"
END_TITLE
SYMBOLS
%B1 title "a name of the generated code"
%B2 m_codes
%W5 parts "parts made"
END_SYMBOLS
ALARMS
%Q401 WARNING "no pressure"
END_ALARMS
MCODES
41 "gear 1"
8 "coolant on"
END_MCODES
SLOWDIV 4
OPTION CNUD=HOLD
FAST
NETWORK
LD %I3
OUT %Q4
END_FAST
SLOW
NETWORK
LD title
OUT m_codes
OUT %Q401
CALL SR7
END_SLOW
SUB SR7
NETWORK
LD %I1
OPRT parts = parts + 1
END_SUB
)";

class GeneratedHost50 : public testing::Test {
 protected:
  void SetUp() override {
    work_.Write("lathe.il", kLathe);
    const driver::Ran ran = work_.Run("emit lathe.il -o out");
    ASSERT_EQ(ran.code, 0) << ran;
    header_ = work_.Read("out/lathe.hpp");
  }
  int Shell(const std::string& command) { return std::system(("cd '" + work_.Path("") + "' && " + command).c_str()); }

  const std::string release_ =
      "g++ -std=c++17 -O2 -Wall -Wextra -Wconversion -Wshadow -Werror -ffreestanding -fno-exceptions -fno-rtti "
      "-I " PLCXX_ROOT "/runtime_support ";
  driver::Workplace work_;
  std::string header_;
};

// covers: HOST50-041
TEST_F(GeneratedHost50, PartsAreFunctionsOfTheirOwnThatNeedNothingOfTheSystem) {
  EXPECT_THAT(header_, HasSubstr("void init(State& m, Host& host) noexcept;\n"));
  EXPECT_THAT(header_, HasSubstr("void fast(State& m, Host& host) noexcept;\n"));
  EXPECT_THAT(header_, HasSubstr("void slow(State& m, Host& host) noexcept;\n"));
  EXPECT_EQ(Shell(release_ + "-c out/lathe.cpp -o lathe.o && ! nm -u -C lathe.o | grep -Ev "
                             "'lathe::|memset|memcpy|memmove|memcmp|_GLOBAL_OFFSET_TABLE_|__stack_chk_fail'"),
            0);
}

// Numbers of 8 bytes begin at multiples of 4 there, unless they say otherwise.
TEST_F(GeneratedHost50, StateIsLaidOutAlikeOn32BitX86) {
  work_.Write("timer.il", "SLOW\nNETWORK\nLD %I0\nTONS %TM1, 5\nOUT %Q0\nEND_SLOW\n");
  const driver::Ran ran = work_.Run("emit timer.il -o out --quiet");
  ASSERT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(work_.Read("out/timer.cpp"), HasSubstr("offsetof(State, unit_timer) == "));
  EXPECT_EQ(Shell(release_ + "-m32 -msse2 -mfpmath=sse -fsyntax-only out/timer.cpp"), 0);
}

// covers: HOST50-219
TEST_F(GeneratedHost50, TheRetentiveMemoryIsOneBlockThatTheHostLoadsAndKeeps) {
  EXPECT_THAT(header_, HasSubstr("void retentive_load(Host& host, Retentive& retentive) noexcept;\n"));
  work_.Write("main.cpp", R"(#include "out/lathe.hpp"
namespace lathe {
struct Host { bool stored; Retentive copy; };
void read_inputs(Host&, State&) noexcept {}
void write_outputs(Host&, const State&) noexcept {}
void alarm(Host&, uint32_t, bool) noexcept {}
void retentive_load(Host& host, Retentive& retentive) noexcept { if (host.stored) retentive = host.copy; }
}
using namespace lathe;
static State m;
int main() {
  Host host{};
  init(m, host);
  m[parts] = 41;
  host.copy = m.retentive;  // what the host keeps when power fails
  init(m, host);
  if (m[parts] != 0) return 1;  // nothing is stored
  host.stored = true;
  init(m, host);
  if (m[parts] != 41) return 2;
  host.copy.layout ^= 1;  // of another program
  init(m, host);
  return m[parts] == 0 ? 0 : 3;
}
)");
  EXPECT_EQ(Shell(release_ + "main.cpp out/lathe.cpp -o lathe && ./lathe"), 0);
}

// covers: HOST50-230 HOST50-232 HOST50-234 HOST50-235
TEST_F(GeneratedHost50, TablesOfTheSourceAreConstants) {
  EXPECT_THAT(header_, HasSubstr("inline constexpr title_row title[] = {\n"
                                 "    {\"BUILDER\", \"Iron Works\"},\n    {\"MACHINE\", \"lathe\"},\n};\n"));
  EXPECT_THAT(header_, HasSubstr("inline constexpr m_codes_row m_codes[] = {\n"
                                 "    {8, \"coolant on\"},\n    {41, \"gear 1\"},\n};\n"));
  EXPECT_THAT(header_, HasSubstr("    {1, 2, \"no pressure\"},\n"));
  EXPECT_THAT(header_, HasSubstr("    {\"SLOWDIV\", \"4\"},\n"));
  EXPECT_THAT(header_, HasSubstr("    {\"CNUD\", \"HOLD\"},\n"));
  EXPECT_THAT(header_, HasSubstr("    {\"TP\", \"MANUAL\"},\n"));
}

// covers: HOST50-231
TEST_F(GeneratedHost50, ASymbolGivesWayToANameOfTheGeneratedCode) {
  EXPECT_THAT(header_, HasSubstr("title_B1{0, 1};  // B1: a name of the generated code\n"));
  EXPECT_THAT(header_, HasSubstr("parts"));
}

}  // namespace
}  // namespace plcxx::emit
