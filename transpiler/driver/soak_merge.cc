// plcxx soak --merge: folders of several soaks become one.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/soak_files.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/scenarios/heading.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/support/read_file.h"

namespace plcxx::driver {
namespace {

std::string PathInFolder(const std::string& directory, const std::string& name) {
  return (std::filesystem::path(directory) / name).generic_string();
}

/// A folder that is merged.
struct MergedFolder {
  std::string path;
  soak::Record record;
};

/// None: reported.
std::optional<std::vector<MergedFolder>> ReadFolders(const std::vector<std::string>& from) {
  std::vector<MergedFolder> folders;
  for (const std::string& folder : from) {
    const std::string path = PathInFolder(folder, kSoakRecord);
    const std::optional<std::string> text = support::ReadFile(path);
    if (!text) {
      PrintUsageError("cannot read '" + path + "': is '" + folder + "' a folder that plcxx soak -o wrote?");
      return std::nullopt;
    }
    std::variant<soak::Record, std::string> read = soak::ReadRecord(*text);
    if (const auto* const why = std::get_if<std::string>(&read)) {
      PrintUsageError("cannot merge '" + path + "': " + *why);
      return std::nullopt;
    }
    folders.push_back({folder, std::move(std::get<soak::Record>(read))});
  }
  return folders;
}

/// A scenario that the command wrote, as it has to be in another folder; as it is where its program is not there.
std::string MovedScenario(const std::string& text, const scenarios::Scenario& scenario, const std::string& directory) {
  const compilation::CompilationRequest request = scenarios::RequestOf(scenario, {});
  const compilation::Compilation loaded = compilation::Compile(request, compilation::Stage::kLoaded);
  if (!loaded.ok() || loaded.dialect == nullptr) return text;
  const size_t comment_end = text.find('\n');
  const size_t properties = text.find("\nproperties:"), steps = text.find("\nsteps:");
  const size_t rest = std::min(properties, steps);
  if (comment_end == std::string::npos || rest == std::string::npos) return text;
  return text.substr(0, comment_end + 1) + scenarios::ScenarioHeading(loaded, request, directory) +
         text.substr(rest + 1);
}

/// The first of these files that can be read, moved; the first that cannot is noted in `unreadable`.
std::optional<std::string> MoveFirstReadable(const std::vector<std::string>& paths, const std::string& directory,
                                             std::vector<scenarios::ScenarioError>& unreadable) {
  for (const std::string& path : paths) {
    const std::optional<std::string> text = support::ReadFile(path);
    if (!text) continue;
    const scenarios::ScenarioOrErrors read = scenarios::ParseScenario(path, *text);
    if (const auto* const scenario = std::get_if<scenarios::Scenario>(&read))
      return MovedScenario(*text, *scenario, directory);
    unreadable.push_back(std::get<std::vector<scenarios::ScenarioError>>(read).front());
  }
  return std::nullopt;
}

bool IsInNone(const std::string& name) {
  PrintUsageError("'" + name +
                  "' is in none of the folders: its file is missing there; run that soak again, or leave " +
                  "its folder out");
  return false;
}

/// Runs worth keeping; those that cannot be read are left out, and told. False: reported.
bool TakeRuns(const std::vector<MergedFolder>& folders, const std::string& directory, soak::Record& merged,
              std::vector<emit::OutputFile>& files) {
  std::vector<std::string> left_out;
  for (const auto& [run, goals] : merged.corpus) {
    const std::string name = std::string(kSoakCorpus) + "/" + run;
    std::vector<std::string> paths;
    for (const MergedFolder& folder : folders) paths.push_back(PathInFolder(folder.path, name));
    std::vector<scenarios::ScenarioError> unreadable;
    std::optional<std::string> text = MoveFirstReadable(paths, CorpusFolder(directory), unreadable);
    if (text) {
      files.push_back({name, std::move(*text)});
    } else if (unreadable.empty()) {
      return IsInNone(name);
    } else {
      PrintNote("'" + unreadable.front().path + "' is left out, what it reaches stays in the record: " +
                unreadable.front().message + "; run that soak again to have it");
      left_out.push_back(run);
    }
  }
  for (const std::string& run : left_out) merged.corpus.erase(run);
  return true;
}

/// Each from a folder where it is that finding: another one may have its name elsewhere. False: reported.
bool TakeFindings(const std::vector<MergedFolder>& folders, const std::string& directory, soak::Record& merged,
                  std::vector<emit::OutputFile>& files) {
  std::set<std::string> names;
  for (soak::FindingRecord& finding : merged.findings) {
    std::vector<std::string> paths;
    for (const MergedFolder& folder : folders) {
      const bool has_it = std::ranges::any_of(folder.record.findings, [&](const soak::FindingRecord& one) {
        return one.key == finding.key && one.file == finding.file && one.steps == finding.steps;
      });
      if (has_it) paths.push_back(PathInFolder(folder.path, finding.file));
    }
    std::vector<scenarios::ScenarioError> unreadable;
    std::optional<std::string> text = MoveFirstReadable(paths, directory, unreadable);
    for (size_t i = 0; i < paths.size() && !text; ++i) text = support::ReadFile(paths[i]);
    if (!text) return IsInNone(finding.file);
    const std::filesystem::path name(finding.file);
    for (int i = 2; !names.insert(finding.file).second || IsTakenByOther(directory, finding.file); ++i)
      finding.file = name.stem().string() + "-" + std::to_string(i) + ".yaml";
    files.push_back({finding.file, std::move(*text)});
  }
  return true;
}

}  // namespace

int MergeSoaks(const std::string& directory, const std::vector<std::string>& from, const std::string& form) {
  const std::optional<std::vector<MergedFolder>> folders = ReadFolders(from);
  if (!folders) return kWrongUse;
  soak::Record merged = folders->front().record;
  for (size_t i = 1; i < folders->size(); ++i) {
    const MergedFolder& folder = (*folders)[i];
    if (const std::string wrong = soak::AddRecord(merged, folder.record); !wrong.empty())
      return UsageError("cannot merge '" + PathInFolder(folder.path, kSoakRecord) + "': " + wrong);
  }
  std::vector<emit::OutputFile> files;
  if (!TakeRuns(*folders, directory, merged, files) || !TakeFindings(*folders, directory, merged, files))
    return kWrongUse;
  const bool is_written = WriteSoak(directory, merged, {.files = std::move(files), .protected_paths = {}, .stays = {}});
  const int code = TellSoak(merged, is_written ? directory : "", form);
  return is_written ? code : kWrongUse;
}

}  // namespace plcxx::driver
