// What GCC makes for RV32IMAC and ARMv7E-M is proved equal to the program, instruction by instruction; and an
// instruction that is changed in its assembler is caught, wherever it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "tests/temporary_directory.h"
#include "transpiler/compile/child_process.h"
#include "transpiler/compile/runtime_files.h"
#include "transpiler/compile/target.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/driver/compilation.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/prove/compiled/object_code.h"
#include "transpiler/prove/compiled/verify.h"

namespace plcxx::prove {
namespace {

/// Both parts, timers and counters of the runtime, branches, a product, bytes and bits.
constexpr const char* kMachineProgram = R"(U4A0=I0A0*/I0A1+U4A0*I0A2
P0=I0A3
$
U4A2=[W3K0=33H]*/U4A0
T5I(10)=I0A4*/I0A5
U4A3=T5U+[W3K0<12H]
C1I(5)=I0A6
U4A4=[C1W=3]
DOF ONE: U4A4
W100K0=[W3K0+W4K0]
ENDF ONE
W100K2=BIN(W5K0)
U4A5=[W100K2>W100K0]
)";

/// Numbers of two registers, a rest, shifts by numbers and comparisons with and without sign.
constexpr const char* kMachineNumbers = R"(#include <plc.h>
long total;
int rest, part;
unsigned char index;
void init(void) { plc1_time = 16; plc2_time = 32; }
void plc1(void)
{
  total += (long)P[0] * P[1];
  rest = P[4] % 7;
  part = P_i[5] >> (P[6] & 15);
  index = X[0] & 7;
  Y[index] = X[index] ^ 0x55;
  if (total > 100000L && P_i[7] < -3) Y[9] = 1;
}
void plc2(void) { Y[10] = total >> 8; }
)";

struct InstructionChange {
  const char* name;
  const char* pattern;      // of a whole line of assembler
  const char* replacement;  // with $1 and so on
};

constexpr InstructionChange kRiscvChanges[] = {
    {"branch inverted", "(\\tb)eq(\\t.*)", "$1ne$2"},
    {"branch inverted", "(\\tb)ne(\\t.*)", "$1eq$2"},
    {"sum to difference", "\\tadd(\\t.*)", "\tsub$1"},
    {"and to or", "\\tand(\\t.*)", "\tor$1"},
    {"another byte written", "(\\tsb\\t\\w+,)\\d+(\\(a0\\))", "${1}0$2"},
    {"register not restored", "\\tlw\\ts0,.*", "\tnop"},
};

constexpr InstructionChange kArmChanges[] = {
    {"branch inverted", "(\\tb)eq(\\t.*)", "$1ne$2"},      {"branch inverted", "(\\tb)ne(\\t.*)", "$1eq$2"},
    {"condition inverted", "(\\tmov)ne(\\t.*)", "$1eq$2"}, {"and to or", "\\tands(\\t.*)", "\torrs$1"},
    {"sum to difference", "\\tadds(\\t.*)", "\tsubs$1"},
};

/// A program and the compiler of a target.
class MachineSubject {
 public:
  MachineSubject(const char* target, const char* file, const char* text, const char* dialect)
      : target_(*compile::FindTarget(target)) {
    auto found = compile::FindToolchain(target_, "");
    if (auto* toolchain = std::get_if<compile::Toolchain>(&found)) toolchain_ = std::move(*toolchain);
    driver::CompilationRequest request;
    request.sources = {directory_.Write(file, text)};
    request.dialect = dialect;
    compilation_ = driver::Compile(request);
    EXPECT_TRUE(compilation_.ok());
    emittable_ = emit::legalize::Legalize(compilation_.program, {.name = "turret"});
    EXPECT_TRUE(compile::WriteRuntime(directory_.path().string()));
    for (const emit::OutputFile& output : emit::print::PrintCpp(emittable_, *compilation_.sources))
      directory_.Write(output.name, output.text);
  }

  bool has_compiler() const { return toolchain_.has_value(); }

  std::string Assembler(const std::string& level) {
    Run(level, "turret.cpp", "turret.s", "-S");
    std::ifstream stream(directory_.File("turret.s"), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// The first routine that is not proved, with what differs; empty: all are.
  std::string Caught(const std::string& assembler) {
    directory_.Write("turret.s", assembler);
    if (!Run("2", "turret.s", "turret.o", "-c")) return "not assembled";
    std::ifstream stream(directory_.File("turret.o"), std::ios::binary);
    const std::vector<std::string> objects = {{std::istreambuf_iterator<char>(stream), {}}};
    const std::vector<compiled::Signature> signatures = compiled::SignaturesOf(emittable_);
    const compiled::LoadedCode loaded = compiled::LoadObjectCode(
        {.objects = objects, .signatures = signatures, .processor = std::string(target_.processor)});
    if (loaded.code == nullptr) return loaded.reason;
    for (const compiled::RoutineProof& proof :
         compiled::Verify(emittable_, *loaded.code, compiled::RoutinesToVerify(compilation_.program), {})) {
      if (!proof.exported || proof.result == compiled::ProofResult::kProved) continue;
      return proof.routine + ": " + (proof.differences.empty() ? proof.reason : proof.differences.front().what);
    }
    return "";
  }

 private:
  bool Run(const std::string& level, const std::string& from, const std::string& to, const char* kind) {
    std::vector<std::string> command =
        compile::CompileCommand(*toolchain_, target_, level, directory_.path().string(), from, to);
    for (std::string& word : command) {
      if (word == "-c") word = kind;
    }
    command.emplace_back("-g0");
    const compile::ProcessResult result = compile::RunProcess(command, 60, directory_.path().string());
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return result.exit_code == 0;
  }

  testing_support::TemporaryDirectory directory_;
  const compile::Target& target_;
  std::optional<compile::Toolchain> toolchain_;
  driver::Compilation compilation_;
  emit::Emittable emittable_;
};

struct MachineCase {
  const char* target;
  const char* file;
  const char* text;
  const char* dialect;
};

constexpr MachineCase kMachineCases[] = {{"rv32imac", "turret.plc", kMachineProgram, "nc110"},
                                         {"cortex-m4", "turret.plc", kMachineProgram, "nc110"},
                                         {"rv32imac", "mill.cld", kMachineNumbers, "hnc"},
                                         {"cortex-m4", "mill.cld", kMachineNumbers, "hnc"}};

TEST(MachineCode, IsProved) {
  for (const MachineCase& one : kMachineCases) {
    MachineSubject subject(one.target, one.file, one.text, one.dialect);
    if (!subject.has_compiler()) GTEST_SKIP() << "no compiler for " << one.target;
    for (const char* level : {"2", "s"})
      EXPECT_EQ(subject.Caught(subject.Assembler(level)), "") << one.target << " " << one.file << " -O" << level;
  }
}

/// Each line that the pattern fits is changed alone.
void ExpectChangesCaught(MachineSubject& subject, std::span<const InstructionChange> changes) {
  constexpr int kMostPlaces = 4;  // of one change, for the time that they take
  const std::string assembler = subject.Assembler("2");
  ASSERT_EQ(subject.Caught(assembler), "");
  for (const InstructionChange& change : changes) {
    const std::regex pattern(change.pattern);
    int places = 0;
    for (size_t at = 0; at < assembler.size() && places < kMostPlaces;) {
      const size_t end = std::min(assembler.find('\n', at), assembler.size());
      const std::string line = assembler.substr(at, end - at);
      if (std::regex_match(line, pattern)) {
        const std::string other = std::regex_replace(line, pattern, change.replacement);
        const std::string changed = assembler.substr(0, at) + other + assembler.substr(end);
        EXPECT_NE(subject.Caught(changed), "") << change.name << ":" << line << " ->" << other;
        ++places;
      }
      at = end + 1;
    }
    EXPECT_GT(places, 0) << "nothing fits: " << change.name << " " << change.pattern;
  }
}

TEST(MachineCode, ChangedInstructionsOfRiscvAreCaught) {
  MachineSubject subject("rv32imac", "turret.plc", kMachineProgram, "nc110");
  if (!subject.has_compiler()) GTEST_SKIP() << "no compiler";
  ExpectChangesCaught(subject, kRiscvChanges);
}

TEST(MachineCode, ChangedInstructionsOfArmAreCaught) {
  MachineSubject subject("cortex-m4", "turret.plc", kMachineProgram, "nc110");
  if (!subject.has_compiler()) GTEST_SKIP() << "no compiler";
  ExpectChangesCaught(subject, kArmChanges);
}

}  // namespace
}  // namespace plcxx::prove
