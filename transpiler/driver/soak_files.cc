#include "transpiler/driver/soak_files.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <system_error>
#include <utility>
#include <variant>

#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/own_files.h"
#include "transpiler/driver/soak_output.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/scenarios/heading.h"
#include "transpiler/scenarios/known_runs.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/soak/kept_runs.h"
#include "transpiler/support/listed.h"
#include "transpiler/support/read_file.h"

namespace plcxx::driver {
namespace {

constexpr size_t kMostDropped = 10;  // words that are named

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

void RemoveRedundant(const std::string& directory, const soak::Record& record, const std::set<std::string>& stays) {
  std::error_code error;
  std::vector<std::filesystem::path> redundant;
  for (const auto& entry : std::filesystem::directory_iterator(CorpusFolder(directory), error)) {
    const std::string name = entry.path().filename().string();
    if (IsKeptRun(name) && !record.corpus.contains(name) && !stays.contains(name)) redundant.push_back(entry.path());
  }
  for (const std::filesystem::path& path : redundant) std::filesystem::remove(path, error);
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

Corpus ReadCorpus(const std::string& directory, const compilation::Compilation& compilation) {
  Corpus corpus;
  const auto name_of = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
  const scenarios::RunFiles files = scenarios::ReadRunsIn(CorpusFolder(directory), scenarios::Reach::kAnywhere);
  for (const scenarios::RunFiles::Unreadable& one : files.unreadable) {
    corpus.unreadable.insert(name_of(one.path));
    PrintNote("'" + one.path + "' is no run to begin with: " + one.error.message + "; repair or remove it");
  }
  std::vector<std::vector<scenarios::KnownStep>> runs;
  for (const scenarios::RunFiles::Run& run : files.runs) {
    corpus.names.push_back(name_of(run.path));
    runs.push_back(run.steps);
  }
  corpus.runs = StimuliOf(runs);
  const std::set<std::string> dropped = soak::FitTo(compilation, corpus.runs);
  if (!dropped.empty()) {
    std::vector<std::string> names;
    for (const std::string& name : dropped) names.push_back("'" + name + "'");
    PrintNote("runs in '" + CorpusFolder(directory) +
              "' set what this program does not have, or to values that it does " +
              "not take: " + support::Listed(names, kMostDropped) +
              "; they are run without it, as runs of another version of the program");
  }
  return corpus;
}

bool IsTakenByOther(const std::string& directory, const std::string& name) {
  const std::string path = PathBelow(directory, name);
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return false;
  return !std::filesystem::is_regular_file(status) || IsForeign(path, kKeptRunHead);
}

namespace {

/// False: reported.
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

/// All of the files of a soak, as they are written.
OutputRequest OutputOf(const std::string& directory, const soak::Record& record, SoakOutput soaked) {
  soaked.files.push_back({kSoakRecord, soak::ToJson(record)});
  soaked.files.push_back({kSoakPage, SoakPage(record)});
  OutputRequest output;
  output.protected_paths = std::move(soaked.protected_paths);
  for (emit::OutputFile& file : soaked.files) {
    file.name = PathBelow(directory, file.name);
    output.files.push_back(std::move(file));
  }
  return output;
}

}  // namespace

bool CanTakeSoak(const std::string& directory, const std::vector<std::string>& protected_paths) {
  if (!CanTakeRecord(directory)) return false;
  // A soak in which nothing was seen, and one run: what is in the way of these is in the way of any.
  const std::string run = std::string(kSoakCorpus) + "/" + soak::CorpusName({});
  OutputRequest output =
      OutputOf(directory, {}, {.files = {{run, kKeptRunHead}}, .protected_paths = protected_paths, .stays = {}});
  output.directory = CorpusFolder(directory);
  const std::optional<WriteFailure> failure = CannotWriteAll(output);
  if (failure) CannotWrite(*failure);
  return !failure;
}

bool WriteSoak(const std::string& directory, const soak::Record& record, SoakOutput soaked) {
  const std::set<std::string> stays = std::move(soaked.stays);
  const OutputRequest output = OutputOf(directory, record, std::move(soaked));
  std::error_code none;  // what is wrong is told when the file is written
  std::filesystem::create_directories(CorpusFolder(directory), none);
  if (const std::optional<WriteFailure> failure = WriteAll(output)) {
    CannotWrite(*failure);
    return false;
  }
  RemoveRedundant(directory, record, stays);
  return true;
}

int TellSoak(const soak::Record& record, const std::string& directory, const std::string& form) {
  std::cout << (form == "json" ? soak::ToJson(record) : SoakText(record, directory));
  return record.findings.empty() ? kDone : kProgramHasErrors;
}

}  // namespace plcxx::driver
