// Programs as generated C++, emitted in the debug flavour and compiled for a platform, with the harness that serves an
// engine (harness.h).
//
// In: programs. Out: for each its place in an executable, or why there is none. The compiler's start, the headers and
// the linker cost more than most programs of scenarios, so that programs that are known together share an executable:
// each is in a namespace of its own. A process runs one of them.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/compile/child_process.h"
#include "transpiler/emit/emittable.h"
#include "transpiler/engines/platform.h"
#include "transpiler/ir/program.h"
#include "transpiler/source/source.h"

namespace plcxx::engines {

/// The file, which disappears with the object, and its processes that serve nobody. Of one thread.
class Executable {
 public:
  const compile::TemporaryDirectory& directory() const { return directory_; }
  std::string path() const { return directory_.path() + "/program"; }
  /// One that reads the number of a program next. None: it cannot be started.
  std::unique_ptr<compile::ChildProcess> TakeProcess(const Platform& platform);
  void GiveBack(std::unique_ptr<compile::ChildProcess> process) { idle_.push_back(std::move(process)); }

 private:
  compile::TemporaryDirectory directory_;
  std::vector<std::unique_ptr<compile::ChildProcess>> idle_;
};

/// A program that was compiled once; engines start processes of it.
struct CompiledProgram {
  const ir::Program* program = nullptr;
  emit::layout::Layout layout;
  std::shared_ptr<const Platform> platform;
  std::shared_ptr<Executable> executable;
  uint32_t number = 0;  // in the executable
  emit::Flavour flavour = emit::Flavour::kRelease;
};

using CompiledOrFailure = std::variant<std::shared_ptr<CompiledProgram>, CompileFailure>;

inline constexpr int kMostCompileSeconds = 300;

/// `program` must be structured and outlive the result.
struct ProgramToCompile {
  const ir::Program* program = nullptr;
  const source::SourceManager* sources = nullptr;
  /// What users ship, unless something is to be forced or a statement to be switched off.
  emit::Flavour flavour = emit::Flavour::kRelease;
};

/// A result for each. When the compiler refuses them together, or they do not fit into a processor's memory together,
/// each half is compiled by itself: a failure is that of one program, and the others do not notice. A compiler that
/// does not end in `seconds` fails.
std::vector<CompiledOrFailure> CompileTogether(const std::shared_ptr<const Platform>& platform,
                                               std::span<const ProgramToCompile> programs,
                                               int seconds = kMostCompileSeconds);

CompiledOrFailure CompileFor(const std::shared_ptr<const Platform>& platform, const ir::Program& program,
                             const source::SourceManager& sources, emit::Flavour flavour,
                             int seconds = kMostCompileSeconds);

}  // namespace plcxx::engines
