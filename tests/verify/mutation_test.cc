// What is broken must not be proved: generated code, the runtime's functions and the compiler's flags, each changed in
// one place. The program unchanged is proved, so that what fails fails by the change; and so it is with flags that do
// not change what it does. What was caught where is the table of docs/verify.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tests/verify/changed_code.h"

namespace plcxx::prove {
namespace {

constexpr const char* kProgram = R"(U4A0=I0A0*/I0A1+U4A0*I0A2
P0=I0A3
U4A1=P0*/U4A0
$
U4A2=[W3K0=33H]*/U4A1
T5I(10)=I0A4*/I0A5
U4A3=T5U+[W3K0<12H]
C1I(5)=I0A6
U4A4=[C1W=3]
DOF ONE: U4A4
W100K0=[W3K0+W4K0]
ENDF ONE
DOF TWO: I0A7
W100K1=[W100K0-5]
ENDF TWO
W100K2=BIN(W5K0)
U4A5=[W100K2>W100K1]
)";

/// Loops of which only the state knows how often they go round, one in the other.
constexpr const char* kLoops = R"(U4A0=I0A0
$
W100K0=0
W100K1=0
DOW ONE: [W100K0<W3K0]
W100K0=[W100K0+1]
W100K1=[W100K1+W4K0]
DOF TWO: I0A7
U4A3=/U4A3
ENDF TWO
W100K2=0
DOW THREE: [W100K2<W5K0]
W100K2=[W100K2+2]
W100K3=[W100K3+W100K0]
ENDW THREE
ENDW ONE
U4A1=[W100K1>20H]
)";

/// One loop each, with the budget of rounds that these languages have.
constexpr const char* kLoopOfTechnol = R"(        DATA
N: DS 2
S: DS 2
        DATA_END
        MODULE_MAIN
        LOD CNST.0
        STO S
ZPET: LOD S
        AD N
        STO S
        LOD N
        SU CNST.1
        STO N
        NE CNST.0
        JL1 ZPET
        MODULE_MAIN_END
        STOP
)";

constexpr const char* kLoopOfHost50 = R"(SLOW
NETWORK L0000
LD 1
MOV 0, %W0
MOV 0, %W1
NETWORK L0001
LD 1
ADDW %W0, 1, %W0
ADDW %W1, %W3, %W1
COMP %W0 < %W4
LBL J1
NETWORK L0002
LD 1
ADDW %W2, 1, %W2
END_SLOW
)";

/// Modules that are called from two places, by a pass and by a loop of which the compiler makes two branches.
constexpr const char* kCallsOfProStep = R"(:MOD PM 0
:L
: K 7
:T FB 251
:END PM 0
:MOD PM 9
:A I 0.0
:ON F 8.6
:= F 8.6
:END PM 9
:MOD PM 10
:A F 8.6
:S F 8.7
:JC PM 20
:END PM 10
:MOD PM 11
:A I 0.1
:R F 8.7
:JC PM 20
:END PM 11
:MOD PM 20
:JU FM 0
: DW 28
: K 1
: DW 28
:END PM 20
)";

/// A call of the host in a module, and one behind the call of the module.
constexpr const char* kOrderOfProStep = R"(:MOD PM 0
:JU PM 17
:JU FM 41
: K 41
: K 1
: OB 106
:END PM 0
:MOD PM 17
:JU FM 51
: IB 106
: K 41
: K 1
:END PM 17
)";

constexpr Mutation kMutations[] = {
    // The emitter.
    {"and_to_or", "turret.cpp", "m[U4A0] & m[I0A2]", "m[U4A0] | m[I0A2]"},
    {"dropped_not", "turret.cpp", "m[P0] & !m[U4A0]", "m[P0] & m[U4A0]"},
    {"wrong_constant", "turret.cpp", "m[W3K0] == 0x33", "m[W3K0] == 0x34"},
    {"less_or_equal", "turret.cpp", "m[W3K0] < 0x12", "m[W3K0] <= 0x12"},
    {"swapped_difference", "turret.cpp", "Sub8(m[W100K0], 5)", "Sub8(5, m[W100K0])"},
    {"missing_store", "turret.cpp", "  m[U4A2] = (", "  const bool lost = ("},
    {"wrong_place", "turret.cpp", "m[W100K2] = FromBcd8", "m[W100K1] = FromBcd8"},
    {"wrong_preset", "turret.cpp", "!m[I0A5], 1000, m[now]", "!m[I0A5], 1001, m[now]"},
    {"wrong_modulus", "turret.cpp", "CountSlow(m[C1], m[I0A6], 5", "CountSlow(m[C1], m[I0A6], 6"},
    {"branch_inverted", "turret.cpp", "if (m[I0A7])", "if (!m[I0A7])"},
    {"statement_moved", "turret.cpp", "  m[slow_cycle] = Add32(m[slow_cycle], 1);\n", "  m[slow_done] = 0;\n"},
    {"exchange_forgotten", "turret.cpp", "  write_outputs(host, m);\n", ""},
    {"parts_swapped", "turret.cpp", "  fast(m, host);\n  slow(m, 0, host);", "  slow(m, 0, host);\n  fast(m, host);"},
    {"not_cleared", "turret.cpp", "  Clear(m.ring_counter);\n", ""},
    {"retentive_not_cleared", "turret.cpp", "  m.retentive = Retentive{};\n", ""},
    {"layout_not_marked", "turret.cpp", "m.retentive.layout = kRetentiveLayout;", ""},
    // The runtime.
    {"timer_off_by_one", "plcxx/timers.h", "timer.elapsed_ms >= preset_ms", "timer.elapsed_ms > preset_ms"},
    {"timer_forgets_time", "plcxx/timers.h", "  timer.last_ms = now_ms;\n", ""},
    {"addition_wraps", "plcxx/arith.h", "return sum < a ? 0xFFFFFFFFU : sum;", "return sum;"},
    {"wrong_digit", "plcxx/bcd.h", "(value >> 4) * 10 + (value & 0x0F)", "(value >> 4) * 10 + (value & 0x07)"},
    {"pulse_too_long", "plcxx/one_shots.h", "slice != 0 ? 2U : 1U", "slice != 0 ? 1U : 2U"},
    {"carry_stays", "plcxx/counters.h",
     "uint32_t slow_cycle) noexcept {\n  counter.carry = false;\n  if (!TakeCountInput",
     "uint32_t slow_cycle) noexcept {\n  if (!TakeCountInput"},
};

constexpr Mutation kMutationsOfLoops[] = {
    {"loop_step", "turret.cpp", "m[W100K2] = Add8(m[W100K2], 2)", "m[W100K2] = Add8(m[W100K2], 1)"},
    {"loop_bound", "turret.cpp", "m[W100K0] < m[W3K0]", "m[W100K0] <= m[W3K0]"},
    {"inner_bound", "turret.cpp", "m[W100K2] < m[W5K0]", "m[W100K2] < m[W4K0]"},
    {"guard_count", "turret.cpp", "round == 255", "round == 254"},
    {"inner_guard_count", "turret.cpp", "round2 == 255", "round2 == 256"},
    {"fault_forgotten", "turret.cpp", "fault(host, fault_kind::LOOP_LIMIT, 258497691u);", ""},
    {"sum_forgotten", "turret.cpp", "m[W100K1] = Add8(m[W100K1], m[W4K0]);", ""},
    {"sum_of_another", "turret.cpp", "Add8(m[W100K3], m[W100K0])", "Add8(m[W100K3], m[W100K2])"},
    {"start_forgotten", "turret.cpp", "    m[W100K2] = 0;\n", ""},
    {"toggle_forgotten", "turret.cpp", "m[U4A3] = !m[U4A3]", "m[U4A3] = m[U4A3]"},
    {"leaves_early", "turret.cpp", "m[W100K0] = Add8(m[W100K0], 1);",
     "m[W100K0] = Add8(m[W100K0], 1); if (m[W100K1] == 77) break;"},
    {"wrong_late", "turret.cpp", "m[W100K0] = Add8(m[W100K0], 1);",
     "m[W100K0] = Add8(m[W100K0], m[W100K0] == 200 ? 2 : 1);"},
    {"exit_value", "turret.cpp", "m[W100K1] > 0x20", "m[W100K0] > 0x20"},
};

constexpr Mutation kMutationsOfTechnol[] = {
    {"technol_sum", "turret.cpp", "Add16(m[S], m[N])", "Add16(m[S], m[S])"},
    {"technol_step", "turret.cpp", "Sub16(m[N], 1)", "Sub16(m[N], 2)"},
    {"technol_bound", "turret.cpp", "!= 0) {\n      if (rounds_left", "!= 1) {\n      if (rounds_left"},
    {"technol_start", "turret.cpp", "  m[S] = 0;\n", ""},
    {"technol_budget", "turret.cpp", "rounds_left = 65536u", "rounds_left = 65534u"},
};

constexpr Mutation kMutationsOfHost50[] = {
    {"host50_sum", "turret.cpp", "Add32(m[W1], m[W3])", "Add32(m[W1], m[W0])"},
    {"host50_step", "turret.cpp", "m[W0] = Add32(m[W0], 1)", "m[W0] = Add32(m[W0], 2)"},
    {"host50_bound", "turret.cpp", "S32(m[W0]) < S32(m[W4])", "S32(m[W0]) <= S32(m[W4])"},
    {"host50_start", "turret.cpp", "  m[W1] = 0;\n", ""},
    {"host50_budget", "turret.cpp", "jumps_left = 10000", "jumps_left = 10001"},
    // The same result, but of a sum that C++ leaves undefined where it overflows: a compiler may use that.
    {"host50_signed_sum", "plcxx/arith.h", "Add32(uint32_t a, uint32_t b) noexcept { return a + b; }",
     "Add32(uint32_t a, uint32_t b) noexcept { return static_cast<uint32_t>(int32_t(a) + int32_t(b)); }"},
    {"host50_return", "turret.cpp", "      return;\n    }\n    break;", "    }\n    break;"},
};

/// Of the order of calls, and of what they are called with.
constexpr Mutation kMutationsOfProStep[] = {
    {"prostep_next", "turret.cpp", "Add8(t1, 1) & 7", "Add8(t1, 2) & 7"},
    {"prostep_tries", "turret.cpp", "while (tries < 8)", "while (tries < 7)"},
    {"prostep_goes_on", "turret.cpp", "    if (active) break;\n", ""},
    {"prostep_slice", "turret.cpp", "    slow(m, t1, host);", "    slow(m, active ? t1 : 0, host);"},
    {"prostep_not_called", "turret.cpp", "    slow(m, t1, host);", "    if (active) slow(m, t1, host);"},
    {"prostep_swapped", "turret.cpp", "  slow(m, 0, host);\n  slow(m, 1, host);",
     "  slow(m, 1, host);\n  slow(m, 0, host);"},
    {"prostep_twice", "turret.cpp", "  slow(m, 2, host);", "  slow(m, 2, host);\n  slow(m, 2, host);"},
    {"prostep_other_module", "turret.cpp", "        PM11(m, host);", "        PM10(m, host);"},
};

constexpr Mutation kMutationsOfOrder[] = {
    {"prostep_read_first", "turret.cpp",
     "  PM17(m, host);\n\n  // :JU FM 41\n  // : K 41\n  // : K 1\n  // : OB 106\n"
     "  if (nc_read(host, 1, 41, 1, nc_value)) {",
     "  const bool read = nc_read(host, 1, 41, 1, nc_value);\n  PM17(m, host);\n  if (read) {"},
};

struct Flags {
  std::string_view text;  // separated by blanks
  Outcome expected;
};

constexpr Flags kFlags[] = {
    // These do not change what generated code does.
    {"-funsigned-char", Outcome::kProved},
    {"-fwrapv", Outcome::kProved},
    {"-fno-strict-aliasing", Outcome::kProved},
    {"-fshort-enums", Outcome::kProved},
    {"-DNDEBUG", Outcome::kProved},
    {"-ffast-math", Outcome::kProved},  // without floating point; with it, compiled_code_test.cc
    // These bend the runtime's names and types.
    {"-DAddSaturate32=Add32", Outcome::kCaught},
    {"-D_PLCXX=1 -Delapsed_ms=last_ms", Outcome::kCaught},
    {"-include stdint.h -Duint32_t=uint16_t", Outcome::kCaught},
    {"-fpack-struct=1", Outcome::kCaught},
};

std::vector<std::string> Words(std::string_view text) {
  std::vector<std::string> words;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find(' ', at), text.size());
    words.emplace_back(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

class MutationTest : public ::testing::Test {
 protected:
  void SetUp() override { turret_ = std::make_unique<Subject>("turret.plc", kProgram, "nc110"); }

  std::unique_ptr<Subject> turret_;
};

TEST_F(MutationTest, UnchangedIsProved) { EXPECT_EQ(turret_->Caught(), ""); }

TEST_F(MutationTest, ChangesAreCaught) { ExpectSampleCaught(*turret_, kMutations); }

TEST_F(MutationTest, ChangesInLoopsAreCaught) {
  Subject loops("turret.plc", kLoops, "nc110", {{"enable-dow", "on"}});
  ExpectAllCaught(loops, kMutationsOfLoops);
}

TEST_F(MutationTest, ChangesInLoopsOfTechnolAreCaught) {
  Subject loop("turret.plc", kLoopOfTechnol, "technol");
  ExpectAllCaught(loop, kMutationsOfTechnol);
}

TEST_F(MutationTest, ChangesInLoopsOfHost50AreCaught) {
  Subject loop("turret.il", kLoopOfHost50, "host50");
  ExpectAllCaught(loop, kMutationsOfHost50);
}

TEST_F(MutationTest, TheOrderOfCallsAcrossAModuleIsCaught) {
  Subject calls("turret.plc", kOrderOfProStep, "prostep");
  ExpectAllCaught(calls, kMutationsOfOrder);
}

TEST_F(MutationTest, ChangesOfCallsInProStepAreCaught) {
  Subject calls("turret.plc", kCallsOfProStep, "prostep");
  ExpectAllCaught(calls, kMutationsOfProStep);
}

TEST_F(MutationTest, FlagsThatChangeTheMeaningAreCaught) {
  for (const Flags& flags : kFlags) {
    const std::string caught = turret_->Caught(Words(flags.text));
    EXPECT_EQ(caught.empty(), flags.expected == Outcome::kProved) << flags.text << ": " << caught;
    ExpectInTable(flags.text, caught);
  }
}

}  // namespace
}  // namespace plcxx::prove
