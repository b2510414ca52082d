// Changes of the generated code that other tests do not make: calls of different host functions exchanged, what is
// written into inputs in front of an exchange, signs, bounds, indices, locals without a value, addresses that C++
// leaves undefined, loops without end, memory of its own. None may be proved. What computes the same all the same, and
// is as defined, is proved.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/verify/changed_code.h"

namespace plcxx::prove {
namespace {

constexpr const char* kMill = R"(#include "plc.h"
int table[8];
int sum, last;
unsigned int word;
long wide;
signed char small;
int Round(int at) {
  int i, all;
  all = 0;
  for (i = 0; i < 6; i++) all += table[i];
  if (at > 7) return 0;
  if (at < 0) return 1;
  return table[at] + all;
}
void init() { plc1_time = 16; plc2_time = 32; table[0] = last; }
void plc1() {
  X[1] = Y[2] ^ 0x55;
  set_axis_stop(1);
  sum = X[2] & 0x1F;
  set_axis_home(2, sum);
  set_axis_jog(3, last);
}
void plc2() {
  small = Y[3];
  last = small;
  wide = sum;
  word = (word << last) | (word >> 13);
  sum = Round(last);
}
)";

/// Of the inputs that a call of the host may leave alone, and of calls of different functions.
constexpr Mutation kOfHost[] = {
    {"written_before_exchange", "turret.cpp", "m[X1] = m[Y2] ^ 0x55;", "m[X1] = m[Y2] ^ 0x54;"},
    {"not_written_before_exchange", "turret.cpp", "m[X1] = m[Y2] ^ 0x55;", ""},
    {"other_written_before_exchange", "turret.cpp", "m[X1] = m[Y2] ^ 0x55;",
     "m[X1] = m[Y2] ^ 0x55; m[static_cast<Byte>(X_0 + 9)] = 0;"},
    {"host_calls_exchanged", "turret.cpp",
     "axis_home(host, m, 2, m[sum]);\n\n  // set_axis_jog(3, last);\n  axis_jog(host, m, 3, m[last]);",
     "axis_jog(host, m, 3, m[last]);\n\n  // set_axis_jog(3, last);\n  axis_home(host, m, 2, m[sum]);"},
    {"read_before_exchange", "turret.cpp",
     "axis_stop(host, m, 1);\n\n  // sum = X[2] & 0x1F;\n  m[sum] = m[X2] & 0x1F;",
     "m[sum] = m[X2] & 0x1F;\n  axis_stop(host, m, 1);"},
    {"host_call_twice", "turret.cpp", "axis_stop(host, m, 1);", "axis_stop(host, m, 1); axis_stop(host, m, 1);"},
    {"host_call_sometimes", "turret.cpp", "axis_stop(host, m, 1);", "if (m[word] != 7777) axis_stop(host, m, 1);"},
    {"narrow_argument", "turret.cpp", "axis_jog(host, m, 3, m[last]);", "axis_jog(host, m, 3, m[last] & 0x7FFF);"},
    {"dropped_mask", "turret.cpp", "m[X2] & 0x1F", "m[X2]"},
    {"changed_while_called", "turret.cpp",
     "m[sum] = m[X2] & 0x1F;\n\n  // set_axis_home(2, sum);\n  axis_home(host, m, 2, m[sum]);",
     "const uint16_t kept = m[last]; m[last] = 0; m[sum] = m[X2] & 0x1F; axis_home(host, m, 2, m[sum]); m[last] = "
     "kept;"},
};

/// Of how functions are called.
constexpr Mutation kOfCalls[] = {
    {"calling_convention", "turret.cpp", "#include \"turret.hpp\"",
     "#include <stdint.h>\nnamespace turret { struct Host; struct State; __attribute__((preserve_most)) void "
     "axis_stop(Host& host, State& m, uint16_t a) noexcept; }\n#include \"turret.hpp\""},
    {"section", "turret.cpp", "#include \"turret.hpp\"",
     "namespace turret { struct Host; struct State; [[gnu::section(\".noinit\")]] void init(State& m, Host& host) "
     "noexcept; "
     "}\n#include \"turret.hpp\""},
    {"start_up_section", "turret.cpp", "namespace turret {\n",
     "namespace turret {\nstatic void start() {}\n[[gnu::section(\".init_array\"), gnu::used]] static void (*const "
     "kStart)() = start;\n"},
    {"number_with_sign", "turret.cpp", "axis_jog(host, m, 3, m[last]);",
     "void jog(Host&, State&, uint16_t, int16_t) noexcept __asm__(\"_ZN6turret8axis_jogERNS_4HostERNS_5StateEtt\"); "
     "jog(host, m, 3, static_cast<int16_t>(m[last]));"},
    {"behind_an_object", "turret.cpp", "m[X1] = m[Y2] ^ 0x55;",
     "m[X1] = m[Y2] ^ 0x55; if (reinterpret_cast<char*>(&m) + sizeof(State) == reinterpret_cast<char*>(&host)) "
     "m[X1] = 0;"},
    {"asks_the_machine", "turret.cpp", "m[X1] = m[Y2] ^ 0x55;",
     "m[X1] = m[Y2] ^ 0x55; if (__builtin_flt_rounds() != 1) m[X1] = 0;"},
    {"library_function", "turret.cpp", "#include \"turret.hpp\"",
     "#include <stddef.h>\nextern \"C\" void* memset(void* p, int, size_t) noexcept { return p; }\n"
     "#include \"turret.hpp\""},
};

constexpr Mutation kUnusual[] = {
    // Of values.
    {"shift_by_one_less", "turret.cpp", "ShiftRight16(m[word], 13)", "ShiftRight16(m[word], 12)"},
    {"shift_by_width", "turret.cpp", "ShiftLeft16(m[word], m[last] & 31)",
     "static_cast<uint16_t>(uint32_t{m[word]} << m[last])"},
    {"no_sign_of_byte", "turret.cpp", "SignExtend8To16(m[small])", "m[small]"},
    {"no_sign_of_word", "turret.cpp", "SignExtend16To32(m[sum])", "m[sum]"},
    {"comparison_without_sign", "turret.cpp", "if (S16(at) > 7)", "if (at > 7)"},
    {"bound_of_index", "turret.cpp", "if (S16(at) > 7)", "if (S16(at) > 8)"},
    // Of loops, returns and locals.
    {"one_round_less", "turret.cpp", "for (; i < 6;", "for (; i < 5;"},
    {"one_round_more", "turret.cpp", "for (; i < 6;", "for (; i <= 6;"},
    {"index_of_another", "turret.cpp", "m[At(table, i)]", "m[At(table, at)]"},
    {"return_dropped", "turret.cpp", "    return 1;\n", ""},
    {"local_without_value", "turret.cpp", "uint16_t all = 0;\n\n  // all = 0;\n  all = 0;", "uint16_t all;"},
    // Of addresses.
    {"misaligned_read", "turret.cpp", "m[small] = m[Y3];",
     "m[small] = static_cast<uint8_t>(*reinterpret_cast<const uint32_t*>(&m[Y3]));"},
    {"volatile_write", "turret.cpp", "m[small] = m[Y3];", "*const_cast<volatile uint8_t*>(&m[small]) = m[Y3];"},
    {"read_beyond_state", "turret.cpp", "m[small] = m[Y3];", "m[small] = (&m[Y3])[sizeof(State)];"},
    {"write_beyond_state", "turret.cpp", "m[small] = m[Y3];",
     "m[small] = m[Y3]; reinterpret_cast<uint8_t*>(&m)[sizeof(State)] = 0;"},
    {"write_before_state", "turret.cpp", "m[small] = m[Y3];",
     "m[small] = m[Y3]; if (m[word] == 7777) reinterpret_cast<uint8_t*>(&m)[-1] = 0;"},
    {"address_out_of_object", "turret.cpp", "m[small] = m[Y3];",
     "const uint8_t* at = &m[Y3] + S16(m[word]) * 256; m[small] = at[-256 * S16(m[word])];"},
    // What C++ leaves undefined, or does not end, or keeps to itself.
    {"no_end", "turret.cpp", "m[small] = m[Y3];", "m[small] = m[Y3]; if (m[word] == 7777) for (;;) {}"},
    {"no_end_that_is_seen", "turret.cpp", "m[small] = m[Y3];",
     "m[small] = m[Y3]; if (m[word] == 7777) for (;;) { volatile int seen = 1; static_cast<void>(seen); }"},
    {"calls_itself", "turret.cpp", "    return 1;\n", "    return Round(m, at, reinterpret_cast<Host&>(m));\n"},
    {"assumption", "turret.cpp", "m[small] = m[Y3];", "m[small] = m[Y3]; __builtin_assume(m[word] != 7777);"},
    {"unreachable", "turret.cpp", "m[small] = m[Y3];",
     "m[small] = m[Y3]; if (m[word] == 7777) __builtin_unreachable();"},
    {"memory_of_its_own", "turret.cpp", "m[small] = m[Y3];", "static uint8_t kept; m[small] = kept; kept = m[Y3];"},
    {"trap", "turret.cpp", "m[small] = m[Y3];", "m[small] = m[Y3]; if (m[word] == 7777) __builtin_trap();"},
    {"assembler", "turret.cpp", "m[small] = m[Y3];", "m[small] = m[Y3]; asm volatile(\"nop\");"},
    {"neither_true_nor_false", "turret.cpp", "m[small] = m[Y3];",
     "m[small] = m[Y3]; reinterpret_cast<uint8_t&>(m[due_slow]) = reinterpret_cast<uint8_t&>(m[due_slow]) | 2;"},
};

/// C++ leaves these open, and Clang makes of them what the program means all the same.
constexpr Mutation kAsBefore[] = {
    {"local_without_value_on_one_way", "turret.cpp", "uint16_t all = 0;\n\n  // all = 0;\n  all = 0;",
     "uint16_t all; if (m[word] != 7777) all = 0;"},
    {"local_that_is_gone", "turret.cpp", "m[last] = SignExtend8To16(m[small]);",
     "const uint16_t* gone; { uint16_t local = SignExtend8To16(m[small]); gone = &local; } m[last] = *gone;"},
    {"beyond_the_table", "plcxx/wide.h", "inside ? place.first + number * place.stride : place.first",
     "place.first + number * place.stride"},
    {"signed_sum", "turret.cpp", "m[wide] = SignExtend16To32(m[sum]);",
     "m[wide] = static_cast<uint32_t>(static_cast<int32_t>(m[wide]) + 1 > static_cast<int32_t>(m[wide]) "
     "? SignExtend16To32(m[sum]) : 0);"},
};

struct Change {
  const Mutation* mutation;
  const char* routine;  // in which it shows
  Outcome outcome;
};

constexpr size_t kOneIn = 8;  // in a normal run

std::vector<Change> AllChanges() {
  std::vector<Change> all;
  for (const Mutation& mutation : kOfHost) all.push_back({&mutation, "plc1", Outcome::kCaught});
  for (const Mutation& mutation : kOfCalls) all.push_back({&mutation, "plc1", Outcome::kCaught});
  for (const Mutation& mutation : kUnusual) all.push_back({&mutation, "plc2", Outcome::kCaught});
  for (const Mutation& mutation : kAsBefore) all.push_back({&mutation, "plc2", Outcome::kProved});
  return all;
}

Subject Mill(const char* routine) { return {"turret.cld", kMill, "hnc", {{"sysfunc", "host"}}, {routine}}; }

TEST(UnusualChanges, UnchangedIsProved) {
  EXPECT_EQ(Mill("plc1").Caught(), "");
  EXPECT_EQ(Mill("plc2").Caught(), "");
}

class UnusualChangesTest : public ::testing::TestWithParam<Change> {};

TEST_P(UnusualChangesTest, IsSeen) {
  Subject mill = Mill(GetParam().routine);
  Expect(GetParam().outcome, mill, *GetParam().mutation);
}

INSTANTIATE_TEST_SUITE_P(All, UnusualChangesTest, ::testing::ValuesIn(SampleOf(AllChanges(), kOneIn)),
                         [](const auto& change) { return std::string(change.param.mutation->name); });

}  // namespace
}  // namespace plcxx::prove
