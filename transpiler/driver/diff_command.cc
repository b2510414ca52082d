// plcxx diff: which outputs behave differently, and when.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <set>
#include <variant>

#include "transpiler/driver/common_options.h"
#include "transpiler/driver/diff_output.h"
#include "transpiler/driver/diff_page.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/one_of.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/own_files.h"
#include "transpiler/driver/project_choice.h"
#include "transpiler/driver/scenario_source.h"
#include "transpiler/driver/sim_plan.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/engines/platform.h"
#include "transpiler/review/diff/diff.h"
#include "transpiler/review/diff/sources.h"
#include "transpiler/review/diff/statements.h"

namespace plcxx::driver {
namespace {

constexpr const char* kDiffFooter =
    R"(Each output, call, retentive and internal location is proved to behave alike for every input and all scans, or shown
to differ by a run, or listed as not decided. Renamed and moved statements, and logic written in another way, come out
as equal. The slow part is compared as a whole pass, however it is sliced.

What a verdict claims:
  proved equal   whatever inputs, control and host functions do, scan after scan, also after power failures: the same
  different      in the run that is shown, which both versions were executed with
  not decided    nothing, and it is no success: more --time, a scenario near the change, or a reviewer decides
It does not claim that either version is right (plcxx prove), that their compiled code is (plcxx verify), or that both
take the same time; what was left out or not looked at is named in its first line. docs/review.md has the whole list.

Examples:
  plcxx diff main..                                        the program of plcxx.yaml, against the work tree
  plcxx diff old/turret.plc turret.plc                     two files
  plcxx diff old new                                       two directories: sources as their scenarios name them
  plcxx diff old new --sources turret.sym turret.plc       ... or as you do
  plcxx diff --git v1.2..HEAD turret.sym turret.plc        two revisions; 'v1.2..' is against the work tree
  plcxx diff old new --counterexamples found               a scenario for each difference: it passes on the old version
  plcxx test found/U4A8.yaml --sources turret.plc          ... and fails on the new one
  plcxx diff old new --map LAMP=LAMP_H1                    what is the same though it has another name and address
  plcxx diff old new --format markdown                     for a merge request
  plcxx diff old new --format html >review.html            both versions in one page, with ladder pictures

With git, for a program in one file:
  git config diff.plc.command "plcxx diff --git-external"  and in .gitattributes: *.plc diff=plc
  git config diff.plc.textconv "plcxx print ir-structured" shows the logic instead of the text

Exit codes: as of diff, 0 the versions behave alike, 1 they differ or it is not decided, 2 they cannot be compared.)";

enum class DiffFormat : uint8_t { kText, kMarkdown, kJson, kSarif };

struct DiffSettings {
  CommonOptions common;
  review::diff::DiffWords words;
  std::vector<std::string> same;
  std::string scenarios, format = "text", time = "60s";
};

/// Options for both sides; sources are found later.
std::optional<compilation::CompilationRequest> CommonRequest(const DiffSettings& settings) {
  CommonOptions common = settings.common;
  common.sources.clear();
  return MakeRequest(common);
}

/// A file name for an item: what file systems dislike becomes '_'.
std::string FileNameOf(const std::string& item) {
  std::string name;
  for (const char c : item) {
    const bool plain =
        (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' || c == '_';
    name += plain ? c : '_';
  }
  return name;
}

int WriteScenarios(const review::diff::Diff& diff, const std::string& directory) {
  OutputRequest output{.directory = directory, .files = {}, .protected_paths = {}};
  std::set<std::string> names;
  for (const review::diff::DiffItem& item : diff.items) {
    if (!item.counterexample || item.counterexample->scenario.empty()) continue;
    const std::string name = FreeName(directory, FileNameOf(item.name), kDifferenceHead, names);
    output.files.push_back({PathIn(directory, name), item.counterexample->scenario});
  }
  const std::optional<WriteFailure> failure = WriteAll(output);
  if (!failure) return kDone;
  return CannotWrite(*failure);
}

std::string RenderedDiff(const review::diff::Diff& diff, const DiffNames& names, const std::string& format) {
  if (format == "markdown") return DiffMarkdown(diff, names);
  if (format == "json") return DiffJson(diff, names);
  if (format == "sarif") return DiffSarif(diff, names);
  return DiffText(diff, names, ShowsColours(Stream::kOutput) ? diag::Colour::kOn : diag::Colour::kOff);
}

/// false: the program has errors, which have been told.
bool IsUsable(const review::diff::DiffSide& side, const DiffSettings& settings) {
  if (side.compilation.ok() && side.compilation.has_program) return true;
  MessageStyle messages = MessagesOf(settings.common);
  messages.hidden = side.hidden_prefix;
  messages.shown = side.label + ":";
  PrintDiagnosticsBeside(side.compilation, messages);
  // What was wrong with a file or an option has named it.
  if (side.compilation.wrong_use || !side.compilation.reached) return false;
  PrintUsageError("'" + side.label +
                  "' cannot be compared: " + (side.compilation.ok() ? "it has no program" : "it has errors"));
  return false;
}

int RunDiff(const DiffSettings& settings) {
  const auto begin = std::chrono::steady_clock::now();
  const std::optional<compilation::CompilationRequest> common = CommonRequest(settings);
  if (!common) return kWrongUse;
  const std::optional<uint64_t> time_ms = ParseDuration(settings.time);
  if (!time_ms || *time_ms == 0) {
    return UsageError("'" + settings.time + "' is no time; write for example 30s");
  }
  const std::string scenario = settings.scenarios.empty() ? "" : PathIn(settings.scenarios, "found.yaml");
  if (!CanBeWritten({scenario})) return kWrongUse;
  std::variant<review::diff::DiffRequests, std::string> resolved = review::diff::ResolveDiff(settings.words, *common);
  if (const auto* const why = std::get_if<std::string>(&resolved)) {
    return UsageError(*why);
  }
  auto& requests = std::get<review::diff::DiffRequests>(resolved);
  if (!requests.one_sided.empty()) {
    std::cout << requests.one_sided << "\n";
    return kDone;
  }
  review::diff::DiffOptions options{.same = {},
                                    .time_ms = *time_ms,
                                    .begin = begin,
                                    .scenario_directory = settings.scenarios,
                                    .compiler = engines::FindCompiler(),
                                    .progress = {}};
  for (const std::string& pair : settings.same) {
    const size_t equals = pair.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == pair.size()) {
      return UsageError("--map takes OLD=NEW, not '" + pair + "'");
    }
    options.same.emplace_back(pair.substr(0, equals), pair.substr(equals + 1));
  }
  ProgressLine progress;
  options.progress = [&progress](const std::string& what) { progress.Show(what); };
  review::diff::DiffSide old_side = review::diff::MakeDiffSide(requests.old_side.label, requests.old_side.compilation,
                                                               requests.old_side.hidden_prefix);
  review::diff::DiffSide new_side = review::diff::MakeDiffSide(requests.new_side.label, requests.new_side.compilation,
                                                               requests.new_side.hidden_prefix);
  old_side.file_name = requests.old_side.file_name;
  new_side.file_name = requests.new_side.file_name;
  progress.Clear();
  // git takes anything but 0 for a broken tool, and shows no other file.
  const int not_compared = settings.words.external ? kDone : kWrongUse;
  if (!IsUsable(old_side, settings) || !IsUsable(new_side, settings)) return not_compared;
  if (old_side.compilation.dialect != new_side.compilation.dialect) {
    PrintUsageError("the versions are in different languages: " + std::string(old_side.compilation.dialect->name) +
                    " and " + std::string(new_side.compilation.dialect->name));
    return not_compared;
  }
  review::diff::Diff diff = review::diff::CompareSides(old_side, new_side, options);
  std::ranges::copy(requests.not_looked_at, std::back_inserter(diff.not_looked_at));
  progress.Clear();
  if (!diff.refusal.empty()) {
    PrintUsageError("cannot compare: " + diff.refusal);
    return not_compared;
  }
  if (settings.format == "html" && settings.common.is_one_of_several) {
    return UsageError("--format html is a page about one program: choose it with --program NAME");
  }
  if (settings.format == "html") {
    std::cout << DiffPage(diff, old_side, new_side);
  } else {
    const std::string program = settings.common.is_one_of_several ? settings.words.program : "";
    std::cout << RenderedDiff(
        diff, {requests.old_side.label, requests.new_side.label, program, review::diff::FileOfProgram(new_side)},
        settings.format);
  }
  if (!settings.scenarios.empty()) {
    if (const int written = WriteScenarios(diff, settings.scenarios); written != kDone) return written;
  }
  if (settings.words.external) return kDone;
  return diff.items.empty() ? kDone : kProgramHasErrors;
}

Result ResultOf(const DiffSettings& settings) {
  if (settings.format == "json") return Result::kJson;
  return settings.format == "sarif" ? Result::kSarif : Result::kNamed;
}

/// What nobody would look at is refused; empty: nothing of that.
std::string WhyNotTogether(const DiffSettings& settings) {
  const review::diff::DiffWords& words = settings.words;
  if (words.external) return {};
  if (words.paths.empty()) {
    return words.sources.empty() ? ""
                                 : "--sources is about two directories: name them in front of it, or leave it out: the "
                                   "program is that of plcxx.yaml";
  }
  const bool may_be_projects = std::ranges::any_of(words.paths, [](const std::string& path) {
    std::error_code error;
    return std::filesystem::is_directory(path, error) || IsScenario(path);
  });
  const bool named = !settings.common.project.empty() || settings.common.all ||
                     (!settings.common.program_names.empty() && !may_be_projects);
  return named ? "sources and a project are named: leave one of them out" : "";
}

/// Two revisions of a project are compared program by program, as the work tree names them.
int RunDiffOf(const DiffSettings& asked) {
  DiffSettings settings = asked;
  review::diff::DiffWords& words = settings.words;
  words.reach = settings.common.allow_outside ? project::Reach::kAnywhere : project::Reach::kProject;
  std::error_code error;
  if (words.paths.size() == 1 && words.revisions.empty() && words.paths[0].find("..") != std::string::npos &&
      !std::filesystem::exists(words.paths[0], error)) {
    words.revisions = std::move(words.paths[0]);
    words.paths.clear();
  }
  if (const std::string why = WhyNotTogether(settings); !why.empty()) return UsageError(why);
  if (!words.paths.empty()) {
    if (settings.common.program_names.size() == 1) words.program = settings.common.program_names.front();
    return RunDiff(settings);
  }
  if (words.revisions.empty()) words.revisions = "HEAD..";
  std::optional<std::string> why_no_revisions;  // once for all programs
  return ForEachProgram(
      settings.common,
      [&](const CommonOptions& common) {
        if (!why_no_revisions) {
          why_no_revisions = review::diff::WhyNoRevisions(words.revisions);
          if (!why_no_revisions->empty()) PrintUsageError(*why_no_revisions);
        }
        if (!why_no_revisions->empty()) return static_cast<int>(kWrongUse);
        DiffSettings own = settings;
        own.common.is_one_of_several = common.is_one_of_several;
        own.scenarios = FolderOf(common, settings.scenarios);
        own.words.project = std::filesystem::proximate(common.project, error).generic_string();  // also in a revision
        own.words.program = project::NameOf(*common.program);
        return RunDiff(own);
      },
      ResultOf(settings));
}

}  // namespace

void AddDiff(CLI::App& app, Run& run) {
  CLI::App* command =
      app.add_subcommand("diff", "Which outputs behave differently, and when: proved or shown by a run");
  const auto settings = std::make_shared<DiffSettings>();
  AddProgramOptions(*command, settings->common);
  command
      ->add_option("OLD NEW", settings->words.paths,
                   "Two files or directories; with --git the program's sources. A..B, or nothing for HEAD..: two "
                   "revisions of the project, each as its plcxx.yaml says")
      ->type_name("");
  AddProjectOptions(*command, settings->common);
  command->add_option("--sources", settings->words.sources, "The program's sources, relative to both directories")
      ->type_name("FILE...");
  command->add_option("--git", settings->words.revisions, "Compare two revisions")->type_name("A..B");
  command->add_flag("--git-external", settings->words.external, "Take the words that git gives to a diff tool");
  command->add_option("--map", settings->same, "A location of the old version that is another one in the new version")
      ->type_name("OLD=NEW")
      ->allow_extra_args(false)
      ->take_all();
  command->add_option("--counterexamples", settings->scenarios, "Write a scenario for each difference")
      ->type_name("DIR");
  command->add_option("--format", settings->format, "text, markdown, json, sarif or html")
      ->type_name("FORMAT")
      ->default_str("text")
      ->check(OneOf({"text", "markdown", "json", "sarif", "html"}));
  command->add_option("--time", settings->time, "What is not decided by then stays so")
      ->type_name("TIME")
      ->default_str("60s");
  command->footer(kDiffFooter);
  command->callback([settings, &run] { run = [settings] { return RunDiffOf(*settings); }; });
}

}  // namespace plcxx::driver
