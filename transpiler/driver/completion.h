// Completion of the command line for shells, made from the table of commands.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/driver/command_table.h"

namespace plcxx::driver {

/// The script for "bash", "zsh" or "fish"; none for another one.
std::optional<std::string> CompletionScript(std::string_view shell, const std::vector<CommandRow>& table);

/// A manual page in roff: plcxx(1), plcxx-check(1) ...
std::string ManualPage(const CommandRow& command, const std::vector<CommandRow>& table);

}  // namespace plcxx::driver
