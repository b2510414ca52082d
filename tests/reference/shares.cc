#include "tests/reference/shares.h"

#include <algorithm>
#include <iostream>
#include <sstream>
#include <variant>

#include "tests/reference/compilers.h"
#include "transpiler/compile/child_process.h"
#include "transpiler/scenarios/suite.h"

namespace plcxx::reference {
namespace {

constexpr int kSecondsForAProgram = 120;

std::vector<std::string> SourcesOf(const JudgedProgram& program) {
  std::vector<std::string> sources;
  for (const RandomFile& file : program.program.files) {
    if (file.is_source) sources.push_back(program.folder + "/" + file.name);
  }
  return sources;
}

/// From the lines "  slow: proved (...)" and "  fast: different".
void Verify(size_t number, const JudgedProgram& program, const Judges& judges, ShareCounts& counts,
            std::vector<Disagreement>& found) {
  std::vector<std::string> command = {judges.plcxx, "verify", "--time",    "4s",
                                      "--jobs",     "1",      "--dialect", program.dialect};
  for (const auto& [key, value] : program.program.options) {
    command.emplace_back("--set");
    command.push_back(key + "=" + value);
  }
  for (std::string& source : SourcesOf(program)) command.push_back(std::move(source));
  const compile::ProcessResult result =
      compile::RunProcessGroup(command, 10 * kSecondsForAProgram, program.folder, judges.stops);
  bool is_different = result.exit_code != 0 && result.exit_code != 1;
  bool any = false;
  std::istringstream lines(result.output);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  ") || line.starts_with("   ")) continue;
    const size_t colon = line.find(": ");
    if (colon == std::string::npos) continue;
    const std::string_view verdict = std::string_view(line).substr(colon + 2);
    counts.proved += verdict.starts_with("proved") ? 1 : 0;
    counts.not_decided += verdict.starts_with("not decided") ? 1 : 0;
    is_different |= verdict.starts_with("different");
    any |= verdict.starts_with("proved") || verdict.starts_with("not decided");
  }
  if (is_different || !any) found.push_back({number, "plcxx verify:\n" + result.output});
}

}  // namespace

std::vector<Disagreement> Judge(Share share, const std::vector<JudgedProgram>& programs, const Judges& judges,
                                ShareCounts& counts) {
  std::vector<Disagreement> found;
  counts.programs += programs.size();
  if (share == Share::kVerified) {
    for (size_t i = 0; i < programs.size() && !judges.stops(); ++i) Verify(i, programs[i], judges, counts, found);
    return found;
  }
  std::vector<std::string> command = {judges.soak, "--judge", std::string(kShareNames[static_cast<size_t>(share)])};
  const bool is_emulated = share == Share::kEmulated;
  for (const std::string& platform : is_emulated ? judges.machines : judges.compilers) {
    command.emplace_back("--compiler");
    command.push_back(platform);
  }
  for (const JudgedProgram& program : programs) command.push_back(program.folder + "/scenario.yaml");
  const auto seconds = static_cast<int>(kSecondsForAProgram * (programs.size() + 2));
  const compile::ProcessResult result = compile::RunProcessGroup(command, seconds, {}, judges.stops);
  std::istringstream lines(result.output);
  Disagreement* now = nullptr;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("FAILED ")) {
      const std::string folder = line.substr(7, line.rfind('/') - 7);
      const auto at = std::ranges::find(programs, folder, &JudgedProgram::folder);
      found.push_back({static_cast<size_t>(at == programs.end() ? 0 : at - programs.begin()), ""});
      now = &found.back();
    }
    if (now != nullptr) now->text += line + "\n";
  }
  if (found.empty() && result.exit_code != 0) found.push_back({0, "the judge itself: " + result.output});
  return found;
}

int RunJudge(Share share, const std::vector<std::string>& platforms, const std::vector<std::string>& scenarios) {
  if (platforms.empty() || scenarios.empty()) {
    std::cerr << "nothing to run\n";
    return 2;
  }
  scenarios::SuiteOptions options;
  options.jobs = 1;
  options.time_limit = kSecondsForAProgram;
  for (const std::string& name : platforms) {
    if (share != Share::kEmulated) {
      options.platforms.push_back({MakeCompiler(name), 1});
      continue;
    }
    auto machine = engines::MakeEmulatedPlatform(name);
    if (const auto* failure = std::get_if<engines::CompileFailure>(&machine)) {
      std::cerr << failure->message << "\n";
      return 2;
    }
    options.platforms.push_back({std::get<std::shared_ptr<const engines::Platform>>(machine), 1});
  }
  bool failed = false;
  const auto results = scenarios::TestScenarios(scenarios, options, [](const scenarios::ScenarioResult&) {});
  for (size_t i = 0; i < results.size(); ++i) {
    if (results[i].test.outcome == scenarios::TestOutcome::kPassed) continue;
    failed = true;
    std::cout << "FAILED " << scenarios[i] << "\n" << results[i].test.text << "\n";
  }
  return failed ? 1 : 0;
}

}  // namespace plcxx::reference
