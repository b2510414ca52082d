// plcxx completion and plcxx manual: what shells and man are to know of the command line.
#include <array>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/driver/common_options.h"
#include "transpiler/driver/completion.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/terminal.h"
#include "transpiler/support/near_words.h"

namespace plcxx::driver {
namespace {

constexpr const char* kCompletionFooter = R"(Examples:
  source <(plcxx completion bash)                                        in this shell
  plcxx completion zsh > ~/.zfunc/_plcxx                                 a folder of $fpath
  plcxx completion fish > ~/.config/fish/completions/plcxx.fish

The package of plcxx installs all three.
Exit codes: 0 shown, 2 no such shell.)";

constexpr const char* kManualFooter = R"(Examples:
  plcxx manual check | man -l -
  plcxx manual -o share/man/man1       all pages: plcxx.1, plcxx-check.1 ...

Exit codes: 0 shown or written, 2 no such command.)";

int PrintCompletion(CLI::App& app, const std::string& shell) {
  const std::optional<std::string> script = CompletionScript(shell, CommandTable(app));
  if (!script) {
    constexpr std::array<std::string_view, 3> kShells = {"bash", "zsh", "fish"};
    return UsageError("'" + shell + "' is no shell that plcxx knows" + support::ThereAre(shell, kShells));
  }
  std::cout << *script;
  return kDone;
}

/// As --help has it, but with what every option of every dialect means: a page cannot ask which dialect it is, nor in
/// which folder it is read.
std::vector<CommandRow> ManualTable(CLI::App& app) {
  std::vector<CommandRow> table = CommandTable(app);
  const std::string here = DialectOptionsText(CommonOptions());
  for (CommandRow& command : table) {
    const size_t at = command.footer.find(here);
    if (at != std::string::npos) command.footer.replace(at, here.size(), AllDialectOptionsText());
  }
  return table;
}

int PrintManual(CLI::App& app, const std::string& name, const std::string& folder) {
  const std::vector<CommandRow> table = ManualTable(app);
  OutputRequest output{folder, {}, {}};
  for (const CommandRow& command : table) {
    if (folder.empty() && command.name == name) {
      std::cout << ManualPage(command, table);
      return kDone;
    }
    const std::string file = (command.name.empty() ? "plcxx" : "plcxx-" + command.name) + ".1";
    output.files.push_back({PathIn(folder, file), ManualPage(command, table)});
  }
  if (folder.empty()) {
    std::vector<std::string> names;
    for (const CommandRow& command : table) {
      if (!command.name.empty()) names.push_back(command.name);
    }
    return UsageError("'" + name + "' is no command of plcxx" + support::ThereAre(name, names));
  }
  if (const auto failure = WriteAll(output)) {
    return CannotWrite(*failure);
  }
  return kDone;
}

}  // namespace

void AddCompletion(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("completion", "Print the completion of the command line for a shell");
  const auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash, zsh or fish")->required()->type_name("");
  command->footer(kCompletionFooter);
  command->callback([shell, &app, &run] { run = [shell, &app] { return PrintCompletion(app, *shell); }; });
}

void AddManual(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("manual", "Print a manual page, or write all of them");
  const auto name = std::make_shared<std::string>();
  const auto folder = std::make_shared<std::string>();
  command->add_option("COMMAND", *name, "The page of a command; else of plcxx")->type_name("");
  command->add_option("-o", *folder, "Write all pages into this folder")->type_name("DIR");
  command->footer(kManualFooter);
  command->callback(
      [name, folder, &app, &run] { run = [name, folder, &app] { return PrintManual(app, *name, *folder); }; });
}

}  // namespace plcxx::driver
