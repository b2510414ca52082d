#include "transpiler/driver/soak_files.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <system_error>
#include <utility>
#include <variant>

#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/soak_output.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/scenarios/heading.h"
#include "transpiler/scenarios/known_runs.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/support/read_file.h"

namespace plcxx::driver {
namespace {

std::string PathBelow(const std::string& directory, const std::string& name) {
  return (std::filesystem::path(directory) / name).generic_string();
}

/// A run that this command wrote: "run-0123456789abcdef.yaml".
bool IsKeptRun(const std::string& name) {
  constexpr std::string_view kBegin = "run-", kEnd = ".yaml";
  constexpr size_t kDigits = 16;
  if (!name.starts_with(kBegin) || !name.ends_with(kEnd)) return false;
  const std::string_view digits =
      std::string_view(name).substr(kBegin.size(), name.size() - kBegin.size() - kEnd.size());
  return digits.size() == kDigits && digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

void RemoveRedundant(const std::string& directory, const soak::Record& record) {
  std::error_code error;
  std::vector<std::filesystem::path> redundant;
  for (const auto& entry : std::filesystem::directory_iterator(CorpusFolder(directory), error)) {
    const std::string name = entry.path().filename().string();
    if (IsKeptRun(name) && !record.corpus.contains(name)) redundant.push_back(entry.path());
  }
  for (const std::filesystem::path& path : redundant) std::filesystem::remove(path, error);
}

/// A scenario that the command wrote, as it has to be in another folder; none where its program is not there, or it is
/// no scenario.
std::optional<std::string> MovedScenario(const std::string& path, const std::string& directory) {
  const std::optional<std::string> text = support::ReadFile(path);
  if (!text) return std::nullopt;
  const scenarios::ScenarioOrErrors read = scenarios::ReadScenario(path, scenarios::Reach::kAnywhere);
  const auto* const scenario = std::get_if<scenarios::Scenario>(&read);
  if (scenario == nullptr) return std::nullopt;
  const compilation::CompilationRequest request = scenarios::RequestOf(*scenario, {});
  const compilation::Compilation loaded = compilation::Compile(request, compilation::Stage::kLoaded);
  if (!loaded.ok() || loaded.dialect == nullptr) return std::nullopt;
  const size_t comment_end = text->find('\n');
  const size_t properties = text->find("\nproperties:"), steps = text->find("\nsteps:");
  const size_t rest = std::min(properties, steps);
  if (comment_end == std::string::npos || rest == std::string::npos) return std::nullopt;
  return text->substr(0, comment_end + 1) + scenarios::ScenarioHeading(loaded, request, directory) +
         text->substr(rest + 1);
}

}  // namespace

std::string CorpusFolder(const std::string& directory) { return PathBelow(directory, kSoakCorpus); }

std::vector<soak::Stimuli> StimuliOf(const std::vector<std::vector<scenarios::KnownStep>>& runs) {
  std::vector<soak::Stimuli> all;
  for (const std::vector<scenarios::KnownStep>& steps : runs) {
    soak::Stimuli& stimuli = all.emplace_back();
    for (const scenarios::KnownStep& step : steps) {
      stimuli.emplace_back(review::diff::WithoutWords(step)).words = step.words;
    }
  }
  return all;
}

std::vector<soak::Stimuli> ReadCorpus(const std::string& directory) {
  return StimuliOf(scenarios::KnownRunsIn(CorpusFolder(directory), scenarios::Reach::kAnywhere));
}

bool CanTakeRecord(const std::string& directory) {
  const std::string path = PathBelow(directory, kSoakRecord);
  if (!CanBeWritten({path})) return false;
  const std::optional<std::string> text = support::ReadFile(path);
  if (!text) return true;
  const std::variant<soak::Record, std::string> read = soak::ReadRecord(*text);
  const auto* const why = std::get_if<std::string>(&read);
  if (why == nullptr || *why == soak::kOfAnotherVersion) return true;
  // Whatever it is, no soak wrote it, and it may be needed.
  PrintUsageError("'" + path + "' is not overwritten: " + *why + "; remove it, or name another folder with -o");
  return false;
}

bool WriteSoak(const std::string& directory, const soak::Record& record, std::vector<emit::OutputFile> files,
               std::vector<std::string> protected_paths) {
  files.push_back({kSoakRecord, soak::ToJson(record)});
  files.push_back({kSoakPage, SoakPage(record)});
  OutputRequest output;
  output.protected_paths = std::move(protected_paths);
  for (emit::OutputFile& file : files) {
    file.name = PathBelow(directory, file.name);
    output.files.push_back(std::move(file));
  }
  std::error_code none;  // what is wrong is told when the file is written
  std::filesystem::create_directories(CorpusFolder(directory), none);
  if (const std::optional<WriteFailure> failure = WriteAll(output)) {
    CannotWrite(*failure);
    return false;
  }
  RemoveRedundant(directory, record);
  return true;
}

int MergeSoaks(const std::string& directory, const std::vector<std::string>& from, const std::string& form) {
  std::optional<soak::Record> merged;
  for (const std::string& folder : from) {
    const std::string path = PathBelow(folder, kSoakRecord);
    const std::optional<std::string> text = support::ReadFile(path);
    if (!text) {
      return UsageError("cannot read '" + path + "': is '" + folder + "' a folder that plcxx soak -o wrote?");
    }
    std::variant<soak::Record, std::string> read = soak::ReadRecord(*text);
    std::string wrong;
    if (const auto* const why = std::get_if<std::string>(&read)) {
      wrong = *why;
    } else if (!merged) {
      merged = std::move(std::get<soak::Record>(read));
    } else {
      wrong = soak::AddRecord(*merged, std::get<soak::Record>(read));
    }
    if (!wrong.empty()) {
      return UsageError("cannot merge '" + path + "': " + wrong);
    }
  }
  std::vector<emit::OutputFile> files;
  const auto take = [&](const std::string& name, const std::string& target) {
    for (const std::string& folder : from) {
      const std::string path = PathBelow(folder, name);
      std::optional<std::string> text =
          MovedScenario(path, std::filesystem::path(PathBelow(directory, target)).parent_path().generic_string());
      if (!text) text = support::ReadFile(path);
      if (!text) continue;
      files.push_back({target, std::move(*text)});
      return true;
    }
    PrintUsageError("'" + name + "' is in none of the folders");
    return false;
  };
  for (const auto& [name, goals] : merged->corpus) {
    const std::string path = std::string(kSoakCorpus) + "/" + name;
    if (!take(path, path)) return kWrongUse;
  }
  for (const soak::FindingRecord& finding : merged->findings) {
    if (!take(finding.file, finding.file)) return kWrongUse;
  }
  if (!WriteSoak(directory, *merged, std::move(files), {})) return kWrongUse;
  return TellSoak(*merged, directory, form);
}

int TellSoak(const soak::Record& record, const std::string& directory, const std::string& form) {
  std::cout << (form == "json" ? soak::ToJson(record) : SoakText(record, directory));
  return record.findings.empty() ? kDone : kProgramHasErrors;
}

}  // namespace plcxx::driver
