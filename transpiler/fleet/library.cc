#include "transpiler/fleet/library.h"

#include <filesystem>
#include <system_error>
#include <vector>

#include "transpiler/compile/runtime_files.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/fleet/embedded_runtime.h"
#include "transpiler/fleet/specialize.h"
#include "transpiler/support/sha256.h"

namespace plcxx::fleet {
namespace {

constexpr int kMostCompileSeconds = 600;

std::vector<std::string> Command(const LibraryRequest& request, unsigned lanes) {
  std::vector<std::string> command = compile::CommandWords(request.compiler);
  command.insert(command.end(), {"-std=c++17", "-O" + request.level, "-w", "-fPIC", "-shared", "-ffp-contract=off",
                                 "-fno-exceptions", "-fno-rtti", "-DPLCXX_FLEET_WORDS=" + std::to_string(lanes / 64),
                                 "-DPLCXX_FLEET_FORCES=" + std::to_string(request.forces ? 1 : 0)});
#if defined(__x86_64__)
  if (lanes >= 256) command.emplace_back("-mavx2");
  if (lanes >= 512) {
    for (const char* flag : {"-mavx512f", "-mavx512bw", "-mavx512dq", "-mavx512vl", "-mprefer-vector-width=512"})
      command.emplace_back(flag);
  }
#endif
  return command;
}

std::string FirstLines(const std::string& text) {
  constexpr size_t kMostCharacters = 2000;
  return text.substr(0, kMostCharacters);
}

bool WriteHeaders(const compile::TemporaryDirectory& directory) {
  // Where they are in the sources, too: they include each other by that name.
  const std::string folder = "transpiler/fleet/runtime/";
  std::error_code error;
  std::filesystem::create_directories(directory.path() + "/" + folder, error);
  bool written = !error && compile::WriteRuntime(directory.path());
  for (unsigned i = 0; i < kFleetRuntimeCount; ++i)
    written =
        directory.Write(folder + kFleetRuntime[i].name, {kFleetRuntime[i].text, kFleetRuntime[i].size}) && written;
  return written;
}

/// Where the result of these bytes is kept; empty: nowhere.
std::string CachePlace(const LibraryRequest& request, const std::vector<std::string>& command,
                       const std::string& text) {
  if (request.cache.empty()) return {};
  std::vector<std::string> version = compile::CommandWords(request.compiler);
  version.emplace_back("--version");
  std::string all = text + compile::RunProcess(version, 10).output;
  for (const std::string& word : command) all += word + "\n";
  for (unsigned i = 0; i < kFleetRuntimeCount; ++i) all.append(kFleetRuntime[i].text, kFleetRuntime[i].size);
  for (const compile::RuntimeFile& file : compile::RuntimeFiles()) all += file.text;
  const std::string digest = support::Sha256(all);
  if (digest.empty()) return {};
  std::error_code error;
  std::filesystem::create_directories(request.cache, error);
  return error ? std::string() : (std::filesystem::path(request.cache) / (digest + ".so")).string();
}

/// Empty: it is at `place`.
std::string Compile(const LibraryRequest& request, std::vector<std::string> command, const std::string& text,
                    const std::string& place) {
  const compile::TemporaryDirectory directory;
  if (!directory.valid() || !WriteHeaders(directory) || !directory.Write("fleet.cpp", text)) return directory.WhyNot();
  // Beside its place first: another process may look for it meanwhile.
  const std::string made = place + "." + std::filesystem::path(directory.path()).filename().string();
  command.insert(command.end(), {"-I", directory.path(), "-o", made, directory.path() + "/fleet.cpp"});
  const compile::ProcessResult result = compile::RunProcess(
      command, request.seconds != 0 ? std::min(request.seconds, kMostCompileSeconds) : kMostCompileSeconds);
  if (result.exit_code != 0)
    return "'" + request.compiler + "' cannot compile the code of a fleet:\n" + FirstLines(result.output);
  std::error_code error;
  if (!std::filesystem::exists(made, error))
    return "'" + request.compiler + "' reported no error, and has made no code";
  std::filesystem::rename(made, place, error);
  return error ? "cannot write '" + place + "'" : std::string();
}

}  // namespace

unsigned WidestFleet() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return 512;
  if (__builtin_cpu_supports("avx2")) return 256;
#endif
  return 64;
}

std::string TooWide(unsigned lanes) {
  if (lanes <= WidestFleet()) return {};
  return "this processor has fleets of up to " + std::to_string(WidestFleet()) + " machines";
}

LibraryOrFailure CompileFleet(const ir::Program& program, const LibraryRequest& request) {
  if (std::string reason = TooWide(request.lanes); !reason.empty()) return reason;
  auto library = std::make_shared<Library>();
  library->program = &program;
  const ir::Program specialized = Specialize(program);
  const SameEverywhere same(specialized);
  library->layout = LayOut(specialized, same);
  library->lanes = request.lanes != 0 ? request.lanes : WidestFleet();
  library->forces = request.forces;
  const Code code = WriteCode(specialized, library->layout, same);
  library->share = code.share;
  const std::vector<std::string> command = Command(request, library->lanes);
  const compile::TemporaryDirectory directory;
  if (!directory.valid()) return directory.WhyNot();
  std::string place = CachePlace(request, command, code.text);
  if (place.empty()) place = directory.path() + "/fleet.so";
  std::error_code error;
  if (!std::filesystem::exists(place, error)) {
    if (std::string failure = Compile(request, command, code.text, place); !failure.empty()) return failure;
  }
  library->loaded = std::make_unique<support::LoadedLibrary>(place);  // stays loaded when the file is gone
  void* const bytes = library->loaded->Find("plcxx_fleet_bytes");
  void* const run = library->loaded->Find("plcxx_fleet_run");
  if (bytes == nullptr || run == nullptr) return "the code of a fleet cannot be loaded: " + library->loaded->reason();
  library->state_bytes = reinterpret_cast<uint64_t (*)()>(bytes)();
  library->run = reinterpret_cast<decltype(library->run)>(run);
  return std::shared_ptr<const Library>(std::move(library));
}

}  // namespace plcxx::fleet
