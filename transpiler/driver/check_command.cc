// plcxx check: diagnostics only.
#include <iostream>
#include <memory>

#include "transpiler/compilation/preemption.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/terminal.h"

namespace plcxx::driver {
namespace {

constexpr const char* kCheckFooter = R"(Examples:
  plcxx check turret.sym turret.plc
  plcxx check main.plc -Werror -Wno-W303
  plcxx check main.plc --diagnostics=sarif > main.sarif

Text goes to standard error, JSON and SARIF to standard output. plcxx explain CODE tells more about a message.
plcxx emit --help lists what --set takes.
Exit codes: 0 no errors, 1 the program has errors, 2 wrong use, 3 a fault of plcxx.)";

struct CheckSettings {
  CommonOptions common;
  bool preemptive = false;
};

int RunCheck(const CheckSettings& settings) {
  const CommonOptions& options = settings.common;
  std::optional<compilation::CompilationRequest> request = MakeRequest(options);
  if (!request) return kWrongUse;
  ProgressLine progress;
  request->progress = [&progress](std::string_view phase) { progress.Show(phase); };
  compilation::Compilation compilation = compilation::Compile(
      *request, settings.preemptive ? compilation::Stage::kOptimized : compilation::Stage::kChecked);
  if (settings.preemptive) static_cast<void>(compilation::CheckPreemptive(compilation));
  progress.Clear();
  PrintDiagnostics(compilation, MessagesOf(options));
  // The text of diagnostics ends with their count; where there are none, one line says that the check was done.
  if (compilation.diagnostics.all().empty() && MessagesOf(options).format == DiagnosticsFormat::kText) {
    std::cerr << compilation.name << ": " << CountText(compilation.diagnostics) << '\n';
  }
  return ExitCodeOf(compilation);
}

}  // namespace

void AddCheck(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("check", "Tell what is wrong or doubtful; write nothing");
  const auto settings = std::make_shared<CheckSettings>();
  AddCommonOptions(*command, settings->common);
  command->add_flag("--preemptive", settings->preemptive,
                    "Also refuse what is not safe when the fast part runs from an interrupt above the slow part");
  command->footer(kCheckFooter);
  command->callback([settings, &run] { run = [settings] { return RunCheck(*settings); }; });
}

}  // namespace plcxx::driver
