#include "transpiler/compile/compile_library.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <optional>
#include <thread>

#include "transpiler/compile/child_process.h"
#include "transpiler/compile/known_objects.h"
#include "transpiler/compile/runtime_files.h"
#include "transpiler/support/read_file.h"
#include "transpiler/support/sha256.h"

namespace plcxx::compile {
namespace {

constexpr int kCompileSeconds = 1800;
constexpr int kArchiveSeconds = 300;

std::string FirstFault(const std::string& output) {
  size_t begin = output.find("error:");
  begin = begin == std::string::npos ? 0 : output.rfind('\n', begin) + 1;
  return output.empty() ? "it ended without a word" : output.substr(begin, output.find('\n', begin) - begin);
}

std::string ObjectName(const std::string& source) {
  return std::filesystem::path(source).replace_extension(".o").string();
}

bool WriteSources(const LibraryRequest& request, std::vector<std::string>& sources) {
  bool written = WriteRuntime(request.directory);
  for (const emit::OutputFile& file : *request.files) {
    const bool source = file.name.ends_with(".cpp");
    if (!source && !IsHeader(file)) continue;
    const std::filesystem::path place = std::filesystem::path(request.directory) / file.name;
    std::error_code error;
    std::filesystem::create_directories(place.parent_path(), error);
    std::ofstream out(place, std::ios::binary);
    out << file.text;
    written = written && out.good();
    if (source) sources.push_back(file.name);
  }
  return written;
}

/// The objects of the library, with what they are made of; `bytes` is empty of those that are to be compiled.
KnownObjects TakeUnchanged(const LibraryRequest& request) {
  namespace fs = std::filesystem;
  const std::string common = CommonInputs(*request.toolchain, *request.files);
  KnownObjects objects;
  for (const emit::OutputFile& file : *request.files) {
    if (!file.name.ends_with(".cpp")) continue;
    const std::string object = ObjectName(file.name);
    objects[object].inputs = InputsOf(*request.toolchain, *request.target, request.level, file, object, common);
  }
  const fs::path library = fs::path(request.previous) / ("lib" + request.name);
  const KnownObjects known = ReadRecord(support::ReadFile(library.string() + ".objects").value_or(""));
  std::vector<std::string> wanted;
  for (const auto& [name, object] : objects) {
    const auto found = known.find(name);
    if (found != known.end() && found->second.inputs == object.inputs) wanted.push_back(name);
  }
  if (wanted.empty()) return objects;
  // What the archiver does not find stays to be compiled; what it gives is looked at.
  TakeObjects(request.toolchain->archiver, library.string() + ".a", wanted, request.directory);
  for (const std::string& name : wanted) {
    const fs::path place = fs::path(request.directory) / name;
    const std::string& bytes = known.at(name).bytes;
    std::error_code failed;
    if (support::Sha256(support::ReadFile(place).value_or("")) == bytes) {
      objects[name].bytes = bytes;
    } else {
      fs::remove(place, failed);
    }
  }
  return objects;
}

/// Compiles all of them, `jobs` at a time; the fault of the first one that has any.
std::optional<RefusedSource> CompileAll(const LibraryRequest& request, const std::vector<std::string>& sources) {
  std::atomic<size_t> next = 0;
  std::mutex guard;
  size_t done = 0;
  std::vector<std::optional<RefusedSource>> faults(sources.size());
  const auto work = [&] {
    for (size_t i = next++; i < sources.size(); i = next++) {
      const ProcessResult result = RunProcess(CompileCommand(*request.toolchain, *request.target, request.level,
                                                             request.directory, sources[i], ObjectName(sources[i])),
                                              kCompileSeconds, request.directory);
      if (result.exit_code != 0) faults[i] = RefusedSource{sources[i], FirstFault(result.output), result.output};
      const std::lock_guard<std::mutex> lock(guard);
      ++done;
      request.progress("compiling: " + std::to_string(done) + " of " + std::to_string(sources.size()));
    }
  };
  std::vector<std::thread> workers;
  const size_t count = std::clamp<size_t>(request.jobs, 1, std::max<size_t>(sources.size(), 1));
  for (size_t i = 1; i < count; ++i) workers.emplace_back(work);
  work();
  for (std::thread& worker : workers) worker.join();
  const auto first = std::ranges::find_if(faults, [](const auto& fault) { return fault.has_value(); });
  return first == faults.end() ? std::nullopt : *first;
}

}  // namespace

std::variant<Library, RefusedSource, NoRoom> CompileLibrary(const LibraryRequest& request) {
  std::vector<std::string> sources;
  if (!WriteSources(request, sources)) return NoRoom{};
  KnownObjects objects = TakeUnchanged(request);
  std::vector<std::string> changed;
  for (const std::string& source : sources) {
    if (objects.at(ObjectName(source)).bytes.empty()) changed.push_back(source);
  }
  request.progress("compiling");
  if (auto fault = CompileAll(request, changed)) return *fault;
  for (const std::string& source : changed) {
    const std::string object = ObjectName(source);
    objects.at(object).bytes =
        support::Sha256(support::ReadFile(std::filesystem::path(request.directory) / object).value_or(""));
  }

  Library library;
  library.record = RecordText(objects);
  library.archive = "lib" + request.name + ".a";
  std::vector<std::string> command = {request.toolchain->archiver, "rcsD", library.archive};
  for (const std::string& source : sources) {
    library.objects.push_back(ObjectName(source));
    command.push_back(library.objects.back());
  }
  const ProcessResult result = RunProcess(command, kArchiveSeconds, request.directory);
  if (result.exit_code != 0) return RefusedSource{"", FirstFault(result.output), result.output};
  return library;
}

}  // namespace plcxx::compile
