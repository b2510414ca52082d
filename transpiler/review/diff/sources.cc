#include "transpiler/review/diff/sources.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "transpiler/dialects/dialect.h"
#include "transpiler/project/project.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/support/near_words.h"

namespace plcxx::review::diff {
namespace {

namespace fs = std::filesystem;

constexpr int kGitSeconds = 60;
constexpr size_t kMostNames = 10'000;  // of branches and tags
constexpr const char* kNoFile = "/dev/null";

/// The sources of a directory when the user names none: what its scenarios say, else what looks like a source.
struct FoundSources {
  std::vector<std::string> sources;
  std::string dialect, reason;
};

std::vector<fs::path> FilesOf(const std::string& directory) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, error)) {
    if (entry.is_regular_file(error)) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// Those that can be read and name sources, in the order of their files.
std::vector<scenarios::Scenario> ScenariosIn(const std::string& directory) {
  std::vector<scenarios::Scenario> found;
  for (const fs::path& file : FilesOf(directory)) {
    if (file.extension() != ".yaml") continue;
    scenarios::ScenarioOrErrors read = scenarios::ReadScenario(file.string());
    auto* const scenario = std::get_if<scenarios::Scenario>(&read);
    // A program that is written in its scenario is that scenario's alone.
    if (scenario != nullptr && !scenario->sources.empty() && scenario->texts.empty())
      found.push_back(std::move(*scenario));
  }
  return found;
}

FoundSources FindSources(const std::string& directory) {
  FoundSources found;
  for (const scenarios::Scenario& scenario : ScenariosIn(directory)) {
    if (!found.sources.empty() && found.sources != scenario.sources) {
      found.reason = "the scenarios of directory '" + directory + "' name different sources; name them with --sources";
      return found;
    }
    found.sources = scenario.sources;
    found.dialect = scenario.dialect;
  }
  if (!found.sources.empty()) return found;
  for (const fs::path& file : FilesOf(directory)) {
    for (const dialects::Dialect* dialect : dialects::AllDialects()) {
      if (std::ranges::find(dialect->extensions, file.extension().string()) == dialect->extensions.end()) continue;
      found.sources.push_back(file.filename().string());
      break;
    }
  }
  if (found.sources.empty()) found.reason = "there is no source of a known dialect in directory '" + directory + "'";
  return found;
}

/// The program that a project file says, with what the command line says before it; gives why not. `where` is the file
/// for the user: that of a revision is a copy.
std::optional<std::string> TakeProject(const std::string& path, const std::string& where, const DiffWords& words,
                                       compilation::CompilationRequest& request) {
  project::ProjectOrErrors read = project::ReadProject(path, words.reach);
  if (auto* errors = std::get_if<std::vector<yaml::Error>>(&read)) {
    std::string text = "the project cannot be read";
    for (yaml::Error& error : *errors) {
      if (error.path == path) error.path = where;
      text += "\n" + ToText(error);
    }
    return text;
  }
  const auto& project = std::get<project::Project>(read);
  if (words.program.empty() && project.programs.size() > 1)
    return where + " has several programs: choose one with --program NAME";
  const project::Program* program =  // the only one may have got another name since
      project.programs.size() == 1 ? &project.programs.front() : project::FindProgram(project, words.program);
  if (program == nullptr) {
    std::string names;
    for (const project::Program& other : project.programs)
      names += (names.empty() ? "" : ", ") + project::NameOf(other);
    return "there is no program '" + words.program + "' in " + where + "; there are: " + names;
  }
  compilation::CompilationRequest own = project::RequestOf(*program);
  if (!request.dialect.empty()) own.dialect = request.dialect;
  if (request.encoding) own.encoding = request.encoding;
  own.options.insert(own.options.end(), request.options.begin(), request.options.end());
  own.include_directories.insert(own.include_directories.begin(), request.include_directories.begin(),
                                 request.include_directories.end());
  own.macros.insert(own.macros.end(), request.macros.begin(), request.macros.end());
  if (own.base_directory.empty()) own.base_directory = ".";
  request = std::move(own);
  return std::nullopt;
}

bool IsYaml(const std::string& path) { return fs::path(path).extension() == ".yaml"; }

std::string NoProgram(const std::string& path) {
  return "'" + path +
         "' is YAML, as scenarios are: diff compares programs; name the sources of both versions, or their folders";
}

std::optional<std::string> FillRequest(const std::string& path, const DiffWords& words,
                                       compilation::CompilationRequest& request) {
  const std::vector<std::string>& sources = words.sources;
  std::error_code error;
  if (!fs::is_directory(path, error)) {
    if (!sources.empty()) return "--sources names files of two directories, and '" + path + "' is none";
    if (words.external) {  // git goes on with the next file only when the tool has not failed
      request.sources = {path};
      return std::nullopt;
    }
    if (fs::path(path).filename() == project::kProjectFile)
      return "'" + path + "' is a project: name its folder, as in 'plcxx diff " +
             (fs::path(path).has_parent_path() ? fs::path(path).parent_path().string() : std::string(".")) +
             " NEW', or 'plcxx diff A..B' in it for two versions in git";
    if (IsYaml(path)) return NoProgram(path);
    request.sources = {path};
    return std::nullopt;
  }
  for (const std::string& source : sources) {
    if (IsYaml(source)) return NoProgram(source);
  }
  request.base_directory = path;
  request.sources = sources;
  if (!sources.empty()) return std::nullopt;
  const fs::path project = fs::path(path) / project::kProjectFile;
  if (fs::is_regular_file(project, error)) return TakeProject(project.string(), project.string(), words, request);
  FoundSources found = FindSources(path);
  if (!found.reason.empty()) return found.reason;
  request.sources = std::move(found.sources);
  if (request.dialect.empty()) request.dialect = found.dialect;
  return std::nullopt;
}

/// Options with which the scenarios of a program run it: what most of them say.
struct ScenarioOptions {
  fs::path directory;
  std::map<std::string, std::string> options;
  std::set<std::string> differing;  // not the same in all
  std::string dialect;
  size_t count = 0;  // scenarios
};

ScenarioOptions OptionsBeside(const compilation::CompilationRequest& request) {
  const auto path_of = [](const fs::path& directory, const std::string& source) {
    return (directory / source).lexically_normal();
  };
  ScenarioOptions found{.directory = (fs::path(request.base_directory) / request.sources.front()).parent_path()};
  const std::string directory = found.directory.empty() ? "." : found.directory.string();
  std::map<std::string, std::map<std::string, size_t>> counts;  // by name and value
  for (const scenarios::Scenario& scenario : ScenariosIn(directory)) {
    const bool is_of_program =
        std::ranges::equal(scenario.sources, request.sources, [&](const auto& one, const auto& other) {
          return path_of(found.directory, one) == path_of(request.base_directory, other);
        });
    if (!is_of_program) continue;
    std::map<std::string, std::string> options = scenario.options;
    if (scenario.program) options.insert(scenario.program->options.begin(), scenario.program->options.end());
    for (const auto& [name, value] : options) ++counts[name][value];
    found.dialect = scenario.dialect;
    ++found.count;
  }
  for (const auto& [name, values] : counts) {
    const auto most = std::ranges::max_element(values, {}, [](const auto& value) { return value.second; });
    size_t with_it = 0;
    for (const auto& [value, count] : values) with_it += count;
    if (most->second != found.count) found.differing.insert(name);
    if (most->second >= found.count - with_it) found.options.emplace(name, most->first);
  }
  return found;
}

/// The command line's options count first. A file is named from where the scenario stands.
void TakeOptions(const ScenarioOptions& found, compilation::CompilationRequest& request) {
  std::vector<std::pair<std::string, std::string>> taken;
  for (const auto& [name, value] : found.options) {
    const auto has_name = [&name](const auto& own) { return own.first == name; };
    if (std::ranges::any_of(request.options, has_name)) continue;
    if (name == "encoding") {
      if (!request.encoding) request.encoding = source::EncodingByName(value);
      continue;
    }
    std::error_code error;
    const fs::path file = found.directory / value;
    const bool is_elsewhere = found.directory.lexically_normal() != fs::path(request.base_directory).lexically_normal();
    const bool is_file = is_elsewhere && fs::is_regular_file(file, error);
    if (name == "system-include") {
      request.system_include_directories.push_back(file.string());
    } else {
      taken.emplace_back(name, is_file ? fs::absolute(file).string() : value);
    }
  }
  request.options.insert(request.options.begin(), taken.begin(), taken.end());  // the later one counts
  if (request.dialect.empty()) request.dialect = found.dialect;
}

/// A version without scenarios is run as the other one: two versions with different options would differ by them.
void TakeOptionsOfScenarios(DiffRequests& requests) {
  std::set<std::string> given;
  for (const auto& [name, value] : requests.old_side.compilation.options) given.insert(name);
  const ScenarioOptions of_old = OptionsBeside(requests.old_side.compilation),
                        of_new = OptionsBeside(requests.new_side.compilation);
  TakeOptions(of_old.count != 0 ? of_old : of_new, requests.old_side.compilation);
  TakeOptions(of_new.count != 0 ? of_new : of_old, requests.new_side.compilation);
  std::set<std::string> differing = of_old.differing;
  differing.insert(of_new.differing.begin(), of_new.differing.end());
  for (const std::string& name : given) differing.erase(name);
  if (differing.empty()) return;
  std::string names;
  for (const std::string& name : differing) names += (names.empty() ? "" : ", ") + name;
  requests.not_looked_at.push_back("the program with options that only some of its scenarios have (" + names +
                                   "); give them with --set");
}

std::string FirstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

struct Git {
  std::string top, prefix, reason;
};

Git FindGit() {
  Git git;
  const auto top = compile::RunProcess({"git", "rev-parse", "--show-toplevel"}, kGitSeconds);
  const auto prefix = compile::RunProcess({"git", "rev-parse", "--show-prefix"}, kGitSeconds);
  if (top.exit_code != 0) {
    git.reason = "git has no version here (" + FirstLine(top.output) + "): name both, as in 'plcxx diff OLD NEW'";
  } else {
    git.top = FirstLine(top.output);
    git.prefix = FirstLine(prefix.output);
  }
  return git;
}

std::string NoRevision(const Git& git, const std::string& revision, const std::string& why) {
  const auto listed = compile::RunProcess({"git", "for-each-ref", "--format=%(refname:short)"}, kGitSeconds, git.top);
  std::vector<std::string> names;
  std::istringstream lines(listed.output);
  for (std::string line; names.size() < kMostNames && std::getline(lines, line);) names.push_back(line);
  if (listed.exit_code != 0) names.clear();
  if (revision == "HEAD") {  // which every repository with a commit has
    return "git has no version here yet: commit the program first, or name two files or folders, as in 'plcxx diff OLD "
           "NEW'";
  }
  return "git has no version '" + revision + "'" + support::DidYouMean(revision, names) + " (" + why + ")";
}

/// Copies a revision; gives why not.
std::optional<std::string> CopyRevision(const Git& git, const std::string& revision, const std::string& directory) {
  const std::string archive = directory + "/revision.tar";
  const auto made =
      compile::RunProcess({"git", "archive", "--format=tar", "-o", archive, "--", revision}, kGitSeconds, git.top);
  if (made.exit_code != 0) return NoRevision(git, revision, FirstLine(made.output));
  const auto unpacked = compile::RunProcess({"tar", "-xf", archive, "-C", directory}, kGitSeconds);
  std::error_code error;
  fs::remove(archive, error);
  if (unpacked.exit_code != 0) return "--git: cannot unpack '" + revision + "': " + FirstLine(unpacked.output);
  return std::nullopt;
}

/// The same path in a copy of the repository; none: it lies outside, where no revision has anything.
std::optional<std::string> InCopy(const Git& git, const std::string& copy, const std::string& path) {
  std::error_code error;
  const fs::path inside = fs::weakly_canonical(fs::absolute(path), error).lexically_relative(git.top);
  if (inside.empty() || *inside.begin() == "..") return std::nullopt;
  return (fs::path(copy) / inside).lexically_normal().string();
}

/// What the command line names stands in the work tree; of a revision it is what the revision has there. Relative names
/// of sources and options are looked for in the copy anyway. Gives the folders that lie outside.
std::vector<std::string> TakeNamesOfCopy(const Git& git, const std::string& copy,
                                         compilation::CompilationRequest& request) {
  std::vector<std::string> outside;
  for (std::vector<std::string>* const folders : {&request.include_directories, &request.system_include_directories}) {
    for (std::string& folder : *folders) {
      if (std::optional<std::string> own = InCopy(git, copy, folder)) {
        folder = *std::move(own);
      } else {
        outside.push_back(folder);
      }
    }
  }
  const auto take_absolute = [&](std::string& path) {
    if (!fs::path(path).is_absolute()) return;
    if (std::optional<std::string> own = InCopy(git, copy, path)) path = *std::move(own);
  };
  for (std::string& source : request.sources) take_absolute(source);
  for (auto& [name, value] : request.options) take_absolute(value);
  return outside;
}

std::variant<DiffRequests, std::string> ResolveRevisions(const DiffWords& words,
                                                         const compilation::CompilationRequest& common) {
  const size_t dots = words.revisions.find("..");
  if (dots == std::string::npos || dots == 0) {
    return "--git takes two revisions, as in 'v1.2..HEAD', not '" + words.revisions + "'";
  }
  if (words.paths.empty() && words.project.empty())
    return "name the sources of the program behind --git " + words.revisions;
  const std::string old_revision = words.revisions.substr(0, dots);
  std::string new_revision = words.revisions.substr(dots + 2);
  const Git git = FindGit();
  if (!git.reason.empty()) return git.reason;
  DiffRequests requests;
  for (const bool is_old : {true, false}) {
    DiffRequest& side = is_old ? requests.old_side : requests.new_side;
    side.compilation = common;
    side.compilation.sources = words.paths;
    side.label = is_old ? old_revision : new_revision;
    if (!is_old && new_revision.empty()) {
      side.label = "the work tree";  // "A.."
      if (!words.paths.empty()) continue;
      if (std::optional<std::string> wrong = TakeProject(words.project, words.project, words, side.compilation))
        return *wrong;
      continue;
    }
    requests.copies.push_back(std::make_unique<compile::TemporaryDirectory>());
    const std::string& copy = requests.copies.back()->path();
    if (std::optional<std::string> failed = CopyRevision(git, side.label, copy)) return *failed;
    const std::vector<std::string> outside = TakeNamesOfCopy(git, copy, side.compilation);
    if (is_old && !outside.empty()) {
      std::string folders;
      for (const std::string& folder : outside) folders += (folders.empty() ? "" : ", ") + folder;
      requests.not_looked_at.push_back("what other versions of folders outside of the repository had (" + folders +
                                       ")");
    }
    side.compilation.base_directory = git.prefix.empty() ? copy : copy + "/" + git.prefix;
    while (side.compilation.base_directory.ends_with('/')) side.compilation.base_directory.pop_back();
    side.hidden_prefix = side.compilation.base_directory + "/";
    if (!words.paths.empty()) continue;
    // The copy is a project of its own: what its plcxx.yaml names has to be in it.
    std::error_code error;
    fs::create_directory(fs::path(copy) / ".git", error);
    const fs::path file = (fs::path(side.compilation.base_directory) / words.project).lexically_normal();
    if (!fs::exists(file, error))
      return "'" + side.label + "' has no " + words.project +
             ": name the sources of the program, as in 'plcxx diff --git " + words.revisions + " FILE...'";
    const std::string where = words.project + " of '" + side.label + "'";
    if (std::optional<std::string> wrong = TakeProject(file.string(), where, words, side.compilation)) return *wrong;
  }
  if (!words.paths.empty()) TakeOptionsOfScenarios(requests);
  return requests;
}

}  // namespace

std::string WhyNoRevisions(const std::string& revisions) {
  const size_t dots = revisions.find("..");
  if (dots == std::string::npos || dots == 0) return {};  // ResolveDiff tells
  const Git git = FindGit();
  if (!git.reason.empty()) return git.reason;
  for (const std::string& revision : {revisions.substr(0, dots), revisions.substr(dots + 2)}) {
    if (revision.empty()) continue;
    const auto found =
        compile::RunProcess({"git", "rev-parse", "--verify", "--end-of-options", revision + "^{tree}"}, kGitSeconds);
    if (found.exit_code != 0) return NoRevision(git, revision, FirstLine(found.output));
  }
  return {};
}

std::variant<DiffRequests, std::string> ResolveDiff(const DiffWords& words,
                                                    const compilation::CompilationRequest& common) {
  if (!words.revisions.empty()) return ResolveRevisions(words, common);
  DiffRequests requests;
  std::vector<std::string> paths = words.paths;
  std::vector<std::string> names;
  if (words.external) {
    // git's words: path old-file old-hex old-mode new-file new-hex new-mode; of a renamed file its new path and how
    // much it is like the old one, too. A file that one side alone has is compared with the empty device.
    if (paths.size() != 7 && paths.size() != 9) return "--git-external takes the words that git gives to a diff tool";
    names = {paths[0], paths[paths.size() == 9 ? 7 : 0]};
    paths = {paths[1], paths[4]};
    if (paths[0] == kNoFile || paths[1] == kNoFile) {
      requests.one_sided = names[0] + ": only in the " + (paths[0] == kNoFile ? "new" : "old") + " version";
      return requests;
    }
  }
  std::error_code error;
  if (paths.size() == 1 && !fs::exists(paths[0], error)) {
    return "'" + paths[0] + "' is no file: two files or directories are compared; '" + paths[0] +
           "..' compares that version in git with the work tree";
  }
  if (paths.size() != 2)
    return "diff takes an old and a new program: two files, two directories, or --git A..B SOURCE...";
  for (const bool is_old : {true, false}) {
    DiffRequest& side = is_old ? requests.old_side : requests.new_side;
    const size_t at = is_old ? 0 : 1;
    side.compilation = common;
    side.label = names.empty() ? paths[at] : names[at] + (is_old ? " (old)" : " (new)");
    if (!names.empty()) side.file_name = names[at];
    if (std::optional<std::string> wrong = FillRequest(paths[at], words, side.compilation)) return *wrong;
  }
  // What git hands over are copies somewhere.
  if (!words.external) TakeOptionsOfScenarios(requests);
  return requests;
}

}  // namespace plcxx::review::diff
