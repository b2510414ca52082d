#include "transpiler/engines/platform.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "transpiler/compile/runtime_files.h"
#include "transpiler/compile/target.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/engines/embedded_consoles.h"
#include "transpiler/support/check.h"

namespace plcxx::engines {
namespace {

constexpr int kVersionSeconds = 10;
constexpr int kPlatformSeconds = 60;

struct EmulatedMachine {
  std::string_view name, target, emulator, emulator_package, compiler_package, processor, script;
};

constexpr EmulatedMachine kEmulatedMachines[] = {
#define PLCXX_EMULATED(name, target, emulator, emulator_package, compiler_package, processor, script) \
  {name, target, emulator, emulator_package, compiler_package, processor, script},
#include "transpiler/engines/emulated_machines.def"
#undef PLCXX_EMULATED
};

std::vector<std::string> Words(std::string_view text) {
  std::vector<std::string> words;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find(' ', at), text.size());
    if (end > at) words.emplace_back(text.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

std::string_view ConsoleFile(std::string_view name) {
  for (unsigned i = 0; i < kConsoleFilesCount; ++i) {
    if (kConsoleFiles[i].name == name) return {kConsoleFiles[i].text, kConsoleFiles[i].size};
  }
  PLCXX_CHECK(false);
}

bool Runs(const std::string& command) {
  return compile::RunProcess({command, "--version"}, kVersionSeconds).exit_code == 0;
}

std::string Missing(std::string_view engine, const std::string& command, std::string_view package) {
  return "engine '" + std::string(engine) + "' needs '" + command + "': install " + std::string(package);
}

}  // namespace

PlatformOrFailure MakeHostPlatform(const std::string& compiler) {
  auto platform = std::make_shared<Platform>();
  const compile::TemporaryDirectory& shared = platform->shared;
  if (!shared.valid() || !compile::WriteRuntime(shared.path()) || !shared.Write("console.h", ConsoleFile("host.h"))) {
    return CompileFailure{shared.WhyNot()};
  }
  platform->name = "compiled";
  // Such a program runs for milliseconds and is compiled for a second: what is inlined although nothing is optimized
  // was more than half of the compiler's time, so the attribute becomes one without effect.
  platform->compile = compile::CommandWords(compiler);
  platform->compile.insert(platform->compile.end(),
                           {"-std=c++17", "-O0", "-Dalways_inline=unused", "-w", "-I", shared.path()});
  return platform;
}

std::vector<std::string_view> EmulatedMachines() {
  std::vector<std::string_view> names;
  for (const EmulatedMachine& machine : kEmulatedMachines) names.push_back(machine.name);
  return names;
}

PlatformOrFailure MakeEmulatedPlatform(std::string_view name) {
  const auto* const machine = std::ranges::find(kEmulatedMachines, name, &EmulatedMachine::name);
  PLCXX_CHECK(machine != std::end(kEmulatedMachines));
  const compile::Target* const target = compile::FindTarget(machine->target);
  PLCXX_CHECK(target != nullptr);

  auto platform = std::make_shared<Platform>();
  platform->name = name;
  platform->emulator = Words(machine->emulator);
  const std::string compiler = std::string(target->prefix) + "g++";
  if (!Runs(compiler)) return CompileFailure{Missing(name, compiler, machine->compiler_package)};
  if (!Runs(platform->emulator[0]))
    return CompileFailure{Missing(name, platform->emulator[0], machine->emulator_package)};
  for (const char* word : {"-nodefaults", "-display", "none", "-semihosting-config", "enable=on,target=native"})
    platform->emulator.emplace_back(word);
  platform->emulator.emplace_back("-kernel");

  const compile::TemporaryDirectory& shared = platform->shared;
  if (!shared.valid() || !compile::WriteRuntime(shared.path())) return CompileFailure{shared.WhyNot()};
  bool written = shared.Write("console.h", ConsoleFile("emulated.h"));
  for (const std::string_view file :
       {std::string_view("processor.h"), std::string_view("emulated.cc"), machine->processor, machine->script})
    written = written && shared.Write(std::string(file), ConsoleFile(file));
  if (!written) return CompileFailure{shared.WhyNot()};

  platform->compile = {compiler};
  for (const std::string& flag : compile::FlagsOf(*target)) platform->compile.push_back(flag);
  // As an integrator compiles; a multiplication and an addition never become one, which would round once.
  for (const char* flag : {"-std=c++17", "-O2", "-w", "-ffp-contract=off", "-ffreestanding", "-fno-exceptions",
                           "-fno-rtti", "-nostdlib", "-I"})
    platform->compile.emplace_back(flag);
  platform->compile.push_back(shared.path());

  const std::string object = shared.path() + "/console.o";
  std::vector<std::string> arguments = platform->compile;
  arguments.insert(arguments.end(),
                   {"-fno-tree-loop-distribute-patterns", "-r", "-o", object, shared.path() + "/emulated.cc",
                    shared.path() + "/" + std::string(machine->processor)});
  const compile::ProcessResult result = compile::RunProcess(arguments, kPlatformSeconds);
  if (result.exit_code != 0)
    return CompileFailure{"'" + compiler + "' cannot compile the console:\n" + FirstLines(result.output)};
  platform->link = {object, "-T", shared.path() + "/" + std::string(machine->script), "-Wl,--no-warn-rwx-segments",
                    "-lgcc"};
  return platform;
}

std::string FindCompiler() {
  const char* chosen = std::getenv("CXX");
  if (chosen != nullptr && *chosen != '\0') return chosen;
  for (const char* candidate : {"c++", "g++", "clang++"}) {
    if (Runs(candidate)) return candidate;
  }
  return "";
}

std::string FirstLines(const std::string& text) {
  constexpr size_t kLines = 20;
  size_t end = 0;
  for (size_t i = 0; i < kLines && end != std::string::npos; ++i) end = text.find('\n', end == 0 ? 0 : end + 1);
  return end == std::string::npos ? text : text.substr(0, end);
}

}  // namespace plcxx::engines
