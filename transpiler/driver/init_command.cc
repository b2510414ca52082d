// plcxx init: a folder of files from a control becomes a project.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "transpiler/compilation/dialect_choice.h"
#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/one_of.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/project/project.h"
#include "transpiler/project/proposal.h"
#include "transpiler/source/columns.h"
#include "transpiler/support/near_words.h"
#include "transpiler/support/read_file.h"

namespace plcxx::driver {
namespace {

namespace fs = std::filesystem;

constexpr const char* kInitFooter = R"(Examples:
  plcxx init                          the files in this folder, as they came from the control
  plcxx init lathe --dialect nc110
  plcxx init --pipeline gitlab

Writes plcxx.yaml, .gitattributes, a first scenario and, where the folder's repository is at GitHub or GitLab, a
pipeline in the root of the repository; says what it decided and why. Files that exist are left as they are.
Exit codes: 0 written, 1 no file is a source that plcxx knows, 2 wrong use, 3 a fault of plcxx.)";

struct InitSettings {
  std::string folder, dialect, pipeline = "auto";
};

void Say(const std::string& what, const std::string& text) {
  constexpr size_t kWidth = 10;
  std::cout << source::LeftAligned(what, kWidth) << diag::Escaped(text) << '\n';
}

void Show(const project::ProposedProgram& program) {
  constexpr size_t kWhatWidth = 10;
  size_t name_width = 18;
  for (const project::ProposedFile& file : program.files)
    name_width = std::max(name_width, source::ColumnsOf(file.name));
  Say("program", program.name + (program.folder.empty() ? "" : ", in " + program.folder));
  Say("dialect", program.dialect + ": " + program.why_dialect);
  for (const project::ProposedFile& file : program.files) {
    Say("", source::LeftAligned(file.name, name_width) + "  " + source::LeftAligned(file.what, kWhatWidth) +
                (file.encoding.empty() ? "" : file.encoding + ", ") + file.reason);
  }
  if (program.sources.empty()) return;
  if (!program.order.empty()) Say("order", program.order + "; the sources run in this order: look at it once");
  Say("check", program.check);
}

/// What to do after it: a program with errors is neither tested nor emitted.
void SayNext(const std::vector<project::ProposedProgram>& programs) {
  const std::string all = programs.size() > 1 ? " --all" : "";
  const bool ok = std::ranges::all_of(programs, [](const project::ProposedProgram& program) { return program.ok; });
  Say("next", ok ? "plcxx check" + all + ", plcxx test" + all + ", plcxx emit" + all
                 : "plcxx check" + all + " shows the errors; plcxx test and plcxx emit work when there are none");
}

/// The service whose files lie there; empty: none.
std::string ServiceByFiles(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder / ".gitlab-ci.yml", error)) return "gitlab";
  return fs::exists(folder / ".github", error) ? "github" : "";
}

/// Services read pipelines in the root of a repository alone. Without a repository: where a service's files are, else
/// the folder itself.
fs::path RootOf(const fs::path& folder) {
  fs::path with_files;
  for (fs::path at = folder;; at = at.parent_path()) {
    if (project::IsVersioned(at.string())) return at;
    if (with_files.empty() && !ServiceByFiles(at).empty()) with_files = at;
    if (at == at.parent_path()) return with_files.empty() ? folder : with_files;
  }
}

/// By files of a service, else by the address that git fetches from.
std::string ServiceOf(const fs::path& root) {
  if (std::string service = ServiceByFiles(root); !service.empty()) return service;
  const std::string config = support::ReadFile(root / ".git" / "config").value_or("");
  if (config.find("github.com") != std::string::npos) return "github";
  return config.find("gitlab") != std::string::npos ? "gitlab" : "";
}

/// Writes those that are not there; what stands in the way of it.
std::optional<WriteFailure> WriteNew(const std::vector<project::PipelineFile>& files) {
  std::error_code error;
  std::string heading = "wrote";
  for (const project::PipelineFile& file : files) {
    const fs::path path = file.path;
    if (fs::exists(fs::symlink_status(path, error))) {
      Say("left", path.generic_string() + ": it is there already");
      continue;
    }
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
    if (auto failure = WriteAll({{}, {{path.string(), file.text}}, {}})) return failure;
    Say(heading, path.generic_string());
    heading.clear();
  }
  return std::nullopt;
}

int RunInit(const InitSettings& settings) {
  std::error_code error;
  const std::string folder = settings.folder;
  if (!folder.empty() && !fs::is_directory(folder, error)) {
    return UsageError("'" + folder + "' is no folder");
  }
  if (!settings.dialect.empty() && dialects::DialectByName(settings.dialect) == nullptr) {
    return UsageError("'" + settings.dialect + "' is no dialect" +
                      support::ThereAre(settings.dialect, compilation::DialectNames()));
  }
  std::vector<project::ProposedProgram> programs = project::ProposePrograms(folder, settings.dialect);
  if (programs.empty()) {
    PrintUsageError(
        "no file in '" + (folder.empty() ? std::string(".") : folder) +
        (settings.dialect.empty()
             ? "' is a source that plcxx knows; --dialect NAME says which language they are in"
             : "' is a source of " + settings.dialect + "; without --dialect, plcxx looks for the language itself"));
    return kProgramHasErrors;
  }
  for (const project::ProposedProgram& program : programs) Show(program);
  std::string no_program;
  for (const project::ProposedProgram& program : programs)
    if (program.sources.empty()) no_program = program.no_program;
  std::erase_if(programs, [](const project::ProposedProgram& program) { return program.sources.empty(); });
  if (programs.empty()) {
    PrintUsageError("nothing was written, for there is no program: " + no_program);
    return kProgramHasErrors;
  }

  const fs::path here = folder;
  std::vector<project::PipelineFile> files = {{(here / project::kProjectFile).string(), project::ProjectText(programs)},
                                              {(here / ".gitattributes").string(), project::AttributesText(programs)}};
  for (const project::ProposedProgram& program : programs)
    files.push_back({(here / program.folder / "power_on.yaml").string(), project::ScenarioText()});
  const fs::path whole = fs::canonical(folder.empty() ? fs::path(".") : here, error);
  const fs::path root = RootOf(whole);
  const std::string service = settings.pipeline == "auto" ? ServiceOf(root) : settings.pipeline;
  const std::string below = root == whole ? "" : whole.lexically_relative(root).generic_string();
  if (auto pipeline = project::Pipeline(service, programs.size(), below)) {
    const fs::path to = below.empty() ? here : root.lexically_proximate(fs::current_path(error));
    files.push_back({(to / pipeline->path).lexically_normal().string(), std::move(pipeline->text)});
  }
  if (const auto failure = WriteNew(files)) return CannotWrite(*failure);
  if (service.empty() && settings.pipeline == "auto") Say("", "no pipeline: --pipeline github or gitlab writes one");
  SayNext(programs);
  return kDone;
}

}  // namespace

void AddInit(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("init", "Make a project of a folder of files, as they came from the control");
  const auto settings = std::make_shared<InitSettings>();
  command->add_option("DIR", settings->folder, "The folder; else the current one")->type_name("");
  command->add_option("--dialect", settings->dialect, "Language of the sources; else found out")->type_name("NAME");
  command->add_option("--pipeline", settings->pipeline, "github, gitlab or none; else where the repository is")
      ->type_name("SERVICE")
      ->check(OneOf({"auto", "github", "gitlab", "none"}));
  command->footer(kInitFooter);
  command->callback([settings, &run] { run = [settings] { return RunInit(*settings); }; });
}

}  // namespace plcxx::driver
