#include "transpiler/scenarios/groups.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

namespace plcxx::scenarios {
namespace {

// From 16 programs on, what a compiler needs to start is small beside what it needs for the programs; and all of them
// have to fit into the memory of the smallest emulated processor.
constexpr size_t kMostPrograms = 24;
constexpr uintmax_t kMostSourceBytes = 64 << 10;
// Of one program: the processes divide more of them, though each compiles the program.
constexpr size_t kMostScenarios = 64;

struct GroupedProgram {
  ItemGroup items;
  uintmax_t source_bytes = 0;
};

uintmax_t SourceBytes(const compilation::CompilationRequest& request) {
  uintmax_t bytes = 0;
  for (const auto& [path, text] : request.texts) bytes += text.size();
  for (const std::string& source : request.sources) {
    std::error_code error;
    const uintmax_t size = std::filesystem::file_size(std::filesystem::path(request.base_directory) / source, error);
    if (!error) bytes += size;
  }
  return bytes;
}

std::vector<GroupedProgram> ProgramsOf(const std::vector<GroupedScenario>& scenarios) {
  std::vector<GroupedProgram> programs;
  std::map<std::string, size_t> known;
  for (const GroupedScenario& scenario : scenarios) {
    const std::string key = KeyOf(scenario.request);
    const auto found = known.find(key);
    if (found != known.end() && programs[found->second].items.size() < kMostScenarios) {
      programs[found->second].items.push_back(scenario.item);
      continue;
    }
    known[key] = programs.size();
    programs.push_back({{scenario.item}, SourceBytes(scenario.request)});
  }
  return programs;
}

}  // namespace

std::vector<ItemGroup> MakeGroups(const std::vector<GroupedScenario>& scenarios, unsigned jobs) {
  const std::vector<GroupedProgram> programs = ProgramsOf(scenarios);
  const size_t share = (programs.size() + jobs - 1) / std::max(jobs, 1U);
  const size_t most = std::clamp<size_t>(share, 1, kMostPrograms);
  std::vector<ItemGroup> groups;
  size_t count = 0;
  uintmax_t bytes = 0;
  for (const GroupedProgram& program : programs) {
    if (groups.empty() || count == most || bytes + program.source_bytes > kMostSourceBytes) {
      groups.emplace_back();
      count = 0;
      bytes = 0;
    }
    groups.back().insert(groups.back().end(), program.items.begin(), program.items.end());
    ++count;
    bytes += program.source_bytes;
  }
  return groups;
}

}  // namespace plcxx::scenarios
