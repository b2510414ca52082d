// Subcommands of the contract that this version does not have yet: they are known and say so.
#include <array>
#include <string>

#include "transpiler/driver/common_options.h"
#include "transpiler/driver/exit_codes.h"
#include "transpiler/driver/terminal.h"

namespace plcxx::driver {
namespace {

struct LaterCommand {
  const char* name;
  const char* meaning;
};
constexpr std::array<LaterCommand, 1> kLaterCommands = {{
    {"diff", "Which outputs' logic changed (comes with a later version)"},
}};

}  // namespace

void AddLaterCommands(CLI::App& app, Run& run) {
  for (const LaterCommand& later : kLaterCommands) {
    CLI::App* command = app.add_subcommand(later.name, later.meaning);
    command->allow_extras();
    const std::string name = later.name;
    command->callback([name, &run] {
      run = [name] {
        PrintUsageError("'" + name + "' comes with a later version of plcxx");
        return static_cast<int>(kWrongUse);
      };
    });
  }
}

}  // namespace plcxx::driver
