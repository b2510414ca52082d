// The commands of the page where it shows a running machine: what a link can do, and why it cannot do the rest.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "transpiler/live/commands.h"
#include "transpiler/live/linked_machine.h"

namespace plcxx::live {

/// Why a running machine does not do what this command asks for; empty: it does, or there is no such command.
std::string_view RefusedOverLink(std::string_view command);

/// The session is not held: most commands wait for the machine.
CommandResult RunLinkedCommand(LinkedMachine& machine, const nlohmann::ordered_json& command);

}  // namespace plcxx::live
