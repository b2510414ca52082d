#include "transpiler/engines/compiled_program.h"

#include <unistd.h>

#include <cerrno>
#include <utility>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/engines/harness.h"

namespace plcxx::engines {
namespace {

class Batch {
 public:
  Batch(const std::shared_ptr<const Platform>& platform, std::span<const ProgramToCompile> programs)
      : platform_(platform), programs_(programs), executable_(std::make_shared<Executable>()) {}

  /// None: compiled, and it can be started.
  std::variant<std::monostate, CompileFailure> Compile(int seconds) {
    const compile::TemporaryDirectory& directory = executable_->directory();
    if (!directory.valid()) return CompileFailure{directory.WhyNot()};
    arguments_ = platform_->compile;
    arguments_.insert(arguments_.end(), {"-I", directory.path(), "-o", executable_->path()});
    bool written = true;
    for (const ProgramToCompile& program : programs_) written = Emit(program) && written;
    written = directory.Write("harness.cpp", HarnessText(emitted_)) && written;
    if (!written) return CompileFailure{directory.WhyNot()};
    arguments_.push_back(directory.path() + "/harness.cpp");
    arguments_.insert(arguments_.end(), platform_->link.begin(), platform_->link.end());
    const compile::ProcessResult result = compile::RunProcess(arguments_, seconds);
    if (result.exit_code == 0) return WhyItCannotStart();
    std::string first = FirstLines(result.output);
    const bool silent = first.find_first_not_of(" \r\n") == std::string::npos;
    if (silent && (result.exit_code < 0 || result.exit_code == 127)) {
      return CompileFailure{"'" + arguments_[0] +
                            "' cannot be run, or did not end in time: install it, or name another with --cxx"};
    }
    if (silent) first = "it ended with exit code " + std::to_string(result.exit_code) + " and said nothing";
    return CompileFailure{"'" + arguments_[0] + "' cannot compile the generated code:\n" + first};
  }

  std::shared_ptr<CompiledProgram> Compiled(uint32_t number) const {
    auto compiled = std::make_shared<CompiledProgram>();
    compiled->program = programs_[number].program;
    compiled->layout = emitted_[number].layout;
    compiled->platform = platform_;
    compiled->executable = executable_;
    compiled->number = number;
    compiled->flavour = programs_[number].flavour;
    return compiled;
  }

 private:
  /// An emulator only reads the file.
  std::variant<std::monostate, CompileFailure> WhyItCannotStart() const {
    if (access(executable_->path().c_str(), platform_->emulator.empty() ? X_OK : R_OK) == 0) return std::monostate();
    if (errno != EACCES) return CompileFailure{"'" + arguments_[0] + "' reported no error, and has made no program"};
    return CompileFailure{"programs in '" + executable_->directory().path() +
                          "' may not be executed: let TMPDIR name a folder of a disk that is not mounted noexec"};
  }

  /// Whether its files could be written.
  bool Emit(const ProgramToCompile& program) {
    const compile::TemporaryDirectory& directory = executable_->directory();
    std::string name = "program";
    if (!emitted_.empty()) name += std::to_string(emitted_.size() + 1);
    emitted_.push_back(emit::legalize::Legalize(
        *program.program, {.name = std::move(name), .flavour = program.flavour, .simulated = true}));
    const emit::Emittable& emittable = emitted_.back();
    bool written = true;
    for (const emit::OutputFile& file : emit::print::PrintCpp(emittable, *program.sources)) {
      written = directory.Write(file.name, file.text) && written;
      if (file.name.ends_with(".cpp") && emittable.parts.size() > 1)
        arguments_.push_back(directory.path() + "/" + file.name);
    }
    return written;
  }

  const std::shared_ptr<const Platform>& platform_;
  std::span<const ProgramToCompile> programs_;
  std::shared_ptr<Executable> executable_;
  std::vector<emit::Emittable> emitted_;
  std::vector<std::string> arguments_;
};

}  // namespace

std::unique_ptr<compile::ChildProcess> Executable::TakeProcess(const Platform& platform) {
  if (!idle_.empty()) {
    auto process = std::move(idle_.back());
    idle_.pop_back();
    return process;
  }
  auto process = std::make_unique<compile::ChildProcess>();
  std::vector<std::string> command = platform.emulator;
  command.push_back(path());
  if (!process->Start(command)) return nullptr;
  return process;
}

std::vector<CompiledOrFailure> CompileTogether(const std::shared_ptr<const Platform>& platform,
                                               std::span<const ProgramToCompile> programs, int seconds) {
  std::vector<CompiledOrFailure> results;
  if (programs.empty()) return results;
  Batch batch(platform, programs);
  const auto compiled = batch.Compile(seconds);
  if (const auto* failure = std::get_if<CompileFailure>(&compiled)) {
    if (programs.size() == 1) return {*failure};
    const size_t half = programs.size() / 2;
    results = CompileTogether(platform, programs.first(half), seconds);
    for (CompiledOrFailure& result : CompileTogether(platform, programs.subspan(half), seconds))
      results.push_back(std::move(result));
    return results;
  }
  for (uint32_t i = 0; i < programs.size(); ++i) results.emplace_back(batch.Compiled(i));
  return results;
}

CompiledOrFailure CompileFor(const std::shared_ptr<const Platform>& platform, const ir::Program& program,
                             const source::SourceManager& sources, emit::Flavour flavour, int seconds) {
  const ProgramToCompile one{&program, &sources, flavour};
  return CompileTogether(platform, {&one, 1}, seconds).front();
}

}  // namespace plcxx::engines
