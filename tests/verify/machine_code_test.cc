// What GCC makes for RV32IMAC and ARMv7E-M is proved equal to the program, instruction by instruction. That a changed
// instruction is not is a test of tests/judges/machine_code.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "tests/temporary_directory.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/compile/child_process.h"
#include "transpiler/compile/runtime_files.h"
#include "transpiler/compile/target.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/prove/verify/object_code.h"
#include "transpiler/prove/verify/verify.h"

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

/// A program and the compiler of a target.
class MachineSubject {
 public:
  MachineSubject(const char* target, const char* file, const char* text, const char* dialect)
      : target_(*compile::FindTarget(target)) {
    auto found = compile::FindToolchain(target_, "");
    if (auto* toolchain = std::get_if<compile::Toolchain>(&found)) toolchain_ = std::move(*toolchain);
    compilation::CompilationRequest request;
    request.sources = {directory_.Write(file, text)};
    request.dialect = dialect;
    compilation_ = compilation::Compile(request);
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
    const std::vector<verify::Signature> signatures = verify::SignaturesOf(emittable_);
    const verify::LoadedCode loaded = verify::LoadObjectCode(
        {.objects = objects, .signatures = signatures, .processor = std::string(target_.processor)});
    if (loaded.code == nullptr) return loaded.reason;
    for (const verify::RoutineProof& proof :
         verify::Verify(emittable_, *loaded.code, verify::RoutinesToVerify(compilation_.program), {})) {
      if (!proof.exported || proof.result == verify::ProofResult::kProved) continue;
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
  compilation::Compilation compilation_;
  emit::Emittable emittable_;
};

struct MachineCase {
  const char* target;
  const char* file;
  const char* text;
  const char* dialect;
};

constexpr MachineCase kMachineCases[] = {{"rv32imac", "turret.plc", kMachineProgram, "nc110"},
                                         {"cortex-m4", "turret.plc", kMachineProgram, "nc110"}};

TEST(MachineCode, IsProved) {
  for (const MachineCase& one : kMachineCases) {
    MachineSubject subject(one.target, one.file, one.text, one.dialect);
    if (!subject.has_compiler()) GTEST_SKIP() << "no compiler for " << one.target;
    for (const char* level : {"2", "s"})
      EXPECT_EQ(subject.Caught(subject.Assembler(level)), "") << one.target << " " << one.file << " -O" << level;
  }
}

}  // namespace
}  // namespace plcxx::prove
