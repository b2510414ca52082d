// What is broken must not be proved: generated code, the runtime's functions and the compiler's flags, each changed in
// one place. The program unchanged is proved, so that what fails fails by the change.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tests/temporary_directory.h"
#include "transpiler/compile/runtime_files.h"
#include "transpiler/compile/target.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/driver/compilation.h"
#include "transpiler/emit/cpp_printer.h"
#include "transpiler/prove/compiled/bitcode.h"
#include "transpiler/prove/compiled/verify.h"

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

struct Mutation {
  std::string_view name;
  std::string_view file;  // "turret.cpp", "plcxx/timers.h"
  std::string_view from;  // stands in it once
  std::string_view to;
};

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

class MutationTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto found = compile::FindToolchain(compile::Targets().front(), kVerifyCompiler);
    ASSERT_TRUE(std::holds_alternative<compile::Toolchain>(found));
    toolchain_ = std::get<compile::Toolchain>(found);
    driver::CompilationRequest request;
    request.sources = {directory_.Write("turret.plc", kProgram)};
    request.dialect = "nc110";
    compilation_ = driver::Compile(request);
    ASSERT_TRUE(compilation_.ok());
    emittable_ = emit::Legalize(compilation_.program, {.name = "turret"});
    files_ = emit::PrintCpp(emittable_, *compilation_.sources);
    for (const compile::RuntimeFile& file : compile::RuntimeFiles())
      runtime_.push_back({.name = file.name, .text = std::string(file.text)});
  }

  /// What is not proved, in words; empty: all is.
  std::string Verdict(const std::vector<std::string>& flags = {}) {
    std::vector<std::string> further = {"-Wno-everything"};
    further.insert(further.end(), flags.begin(), flags.end());
    auto compiled =
        CompileToBitcode({.toolchain = &toolchain_, .files = &files_, .further_flags = further, .runtime = runtime_});
    if (const auto* failure = std::get_if<BitcodeFailure>(&compiled)) return "not compiled: " + failure->output;
    const LoadedCode loaded = LoadCode(std::get<Bitcode>(compiled).files);
    if (loaded.code == nullptr) return loaded.reason;
    std::string text;
    for (const RoutineProof& proof : Verify(emittable_, *loaded.code, RoutinesToVerify(compilation_.program), {})) {
      if (proof.result == ProofResult::kProved) continue;
      text += proof.routine + (proof.result == ProofResult::kDifferent ? " different: " : ": ") + proof.reason;
      for (const CodeDifference& difference : proof.differences) text += difference.what + " ";
      text += "\n";
    }
    return text;
  }

  /// The file's text, generated or of the runtime.
  std::string& TextOf(std::string_view name) {
    for (std::vector<emit::OutputFile>* all : {&files_, &runtime_}) {
      for (emit::OutputFile& file : *all) {
        if (file.name == name) return file.text;
      }
    }
    ADD_FAILURE() << "no file " << name;
    return files_.front().text;
  }

  testing_support::TemporaryDirectory directory_;
  compile::Toolchain toolchain_;
  driver::Compilation compilation_;
  emit::Emittable emittable_;
  std::vector<emit::OutputFile> files_, runtime_;
};

TEST_F(MutationTest, UnchangedIsProved) { EXPECT_EQ(Verdict(), ""); }

TEST_F(MutationTest, ChangesAreCaught) {
  for (const Mutation& mutation : kMutations) {
    std::string& text = TextOf(mutation.file);
    const std::string whole = text;
    const size_t at = text.find(mutation.from);
    ASSERT_NE(at, std::string::npos) << mutation.name;
    ASSERT_EQ(text.find(mutation.from, at + 1), std::string::npos) << mutation.name;
    text.replace(at, mutation.from.size(), mutation.to);
    const std::string verdict = Verdict();
    // It differs, and a state shows it; "not decided" would be too little.
    EXPECT_NE(verdict.find(" different: "), std::string::npos) << mutation.name << ": " << verdict;
    text = whole;
  }
}

TEST_F(MutationTest, FlagsAreCaught) {
  // Names of the runtime or of the program bent by the command line, as a project's own flags may do it.
  EXPECT_NE(Verdict({"-DAddSaturate32=Add32"}), "");
  EXPECT_NE(Verdict({"-D_PLCXX=1", "-Delapsed_ms=last_ms"}), "");
  EXPECT_NE(Verdict({"-include", "stdint.h", "-Duint32_t=uint16_t"}), "");
}

}  // namespace
}  // namespace plcxx::prove
