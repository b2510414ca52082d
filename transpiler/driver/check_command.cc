// plcxx check: diagnostics only.
#include <iostream>
#include <memory>

#include "transpiler/compilation/preemption.h"
#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/accepted_warnings.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/plant_choice.h"
#include "transpiler/driver/program_output.h"
#include "transpiler/driver/project_choice.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/support/counted.h"

namespace plcxx::driver {
namespace {

constexpr const char* kCheckFooter = R"(Examples:
  plcxx check                          the program of plcxx.yaml, in this folder or above
  plcxx check turret.sym turret.plc
  plcxx check main.plc -Werror -Wno-W303
  plcxx check main.plc --diagnostics=sarif > main.sarif
  plcxx check --write-baseline         an old program: from now on only new warnings are shown

The plant and the panel that plcxx.yaml names are looked at, too. Text goes to standard error, JSON and SARIF to standard output. plcxx explain CODE tells more about a message.
plcxx emit --help lists what --set takes.
Exit codes: 0 no errors, 1 the program has errors, 2 wrong use, 3 a fault of plcxx.)";

struct CheckSettings {
  CommonOptions common;
  bool preemptive = false;
  bool write_baseline = false;
};

/// What is warned of today is accepted from now on.
int WriteBaseline(const CommonOptions& options, const compilation::CompilationRequest& asked,
                  compilation::Stage until) {
  compilation::CompilationRequest request = asked;
  request.warnings.errors.clear();
  request.warnings.all_errors = false;
  const compilation::Compilation compilation = compilation::Compile(request, until);
  if (!compilation.ok()) {
    PrintDiagnostics(compilation, MessagesOf(options));
    PrintUsageError("a program with errors has no baseline: mend them first");
    return ExitCodeOf(compilation);
  }
  const std::string named = BaselineOf(options);
  const std::string path = named.empty() ? PathIn(request.base_directory, std::string(project::kBaselineFile)) : named;
  OutputRequest output;
  output.files = {{path, project::BaselineText(compilation, request.base_directory)}};
  output.protected_paths = PathsRead(compilation, options);
  if (!named.empty()) output.named = {named};
  if (const auto failure = WriteAll(output)) {
    return CannotWrite(*failure);
  }
  std::cerr << "wrote " << diag::Escaped(path) << ": "
            << support::Counted(compilation.diagnostics.all().size(), "warning") << " accepted\n";
  if (named.empty()) {
    std::cerr << "it counts with --baseline " << diag::Escaped(path)
              << ", or with 'warnings: {baseline: " << project::kBaselineFile << "}' in " << project::kProjectFile
              << '\n';
  }
  return kDone;
}

/// Whether the plant and the panel that plcxx.yaml names are files of this program; what is wrong has been printed.
bool CheckMachine(const CommonOptions& options, const compilation::Compilation& compilation) {
  if (!options.program || !compilation.ok() || !compilation.has_program) return true;
  const auto plant = ChoosePlant("", options, compilation);
  const auto panel = ChoosePanel("", options, compilation, plant ? plant->get() : nullptr);
  return plant && panel;
}

int RunCheck(const CheckSettings& settings) {
  const CommonOptions& options = settings.common;
  std::optional<compilation::CompilationRequest> request = MakeRequest(options);
  if (!request) return kWrongUse;
  request->lists = dialects::Lists::kNone;
  ProgressLine progress;
  request->progress = [&progress](std::string_view phase) { progress.Show(phase); };
  const compilation::Stage until = settings.preemptive ? compilation::Stage::kOptimized : compilation::Stage::kChecked;
  if (settings.write_baseline) return WriteBaseline(options, *request, until);
  project::Accepted accepted;
  std::optional<compilation::Compilation> compiled = CompileProgram(options, *request, until, accepted);
  if (!compiled) return kWrongUse;
  compilation::Compilation& compilation = *compiled;
  if (settings.preemptive) static_cast<void>(compilation::CheckPreemptive(compilation));
  progress.Clear();
  PrintDiagnostics(compilation, MessagesOf(options));
  const bool is_machine_right = CheckMachine(options, compilation);
  // The text of diagnostics ends with their count; where there are none, one line says that the check was done.
  if (is_machine_right && compilation.diagnostics.all().empty() &&
      MessagesOf(options).format == DiagnosticsFormat::kText) {
    std::cerr << compilation.name << ": " << CountText(compilation.diagnostics) << '\n';
  }
  if (MessagesOf(options).format == DiagnosticsFormat::kText && accepted.warnings + accepted.stale > 0) {
    std::cerr << diag::Escaped(BaselineOf(options)) << ": " << support::Counted(accepted.warnings, "accepted warning");
    if (accepted.stale > 0) std::cerr << ", " << accepted.stale << " more that are gone: --write-baseline drops them";
    std::cerr << '\n';
  }
  return is_machine_right ? ExitCodeOf(compilation) : kWrongUse;
}

}  // namespace

void AddCheck(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("check", "Tell what is wrong or doubtful; write nothing");
  const auto settings = std::make_shared<CheckSettings>();
  AddCommonOptions(*command, settings->common);
  command->add_flag("--preemptive", settings->preemptive,
                    "Also refuse what is not safe when the fast part runs from an interrupt above the slow part");
  command
      ->add_option("--baseline", settings->common.baseline,
                   "File of warnings that are accepted; else the one that plcxx.yaml names")
      ->type_name("FILE")
      ->group("Messages");
  command
      ->add_flag("--write-baseline", settings->write_baseline,
                 "Accept the warnings of today, by statement: only new ones are shown from now on")
      ->group("Messages");
  command->footer(kCheckFooter);
  command->callback([settings, &run] { run = [settings] { return RunForPrograms(*settings, RunCheck); }; });
}

}  // namespace plcxx::driver
