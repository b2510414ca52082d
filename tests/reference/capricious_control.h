// A control that does what it may at any time: refuses, answers late or with anything, writes what is its own.
//
// The controls of scenarios are obliging: a request stays busy until a step ends it, a variable is always there to be
// read, and memory changes between periods only. So what a program does with other answers, and with what the control
// writes at the moment at which it hands over its inputs, no scenario shows.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "transpiler/dialects/dialect.h"
#include "transpiler/ir/program.h"

namespace plcxx::reference {

/// Around `control`, which may be none: it goes on answering, and keeps the machine's inputs.
std::unique_ptr<dialects::ControlStub> MakeCapricious(const ir::Program& program, uint64_t seed,
                                                      std::unique_ptr<dialects::ControlStub> control);

/// The line of a scenario that asks for it (Render writes it), and its seed; none: the scenario does not.
std::string CapriciousLine(uint64_t seed);
std::optional<uint64_t> CapriciousSeed(const std::string& scenario_path);

}  // namespace plcxx::reference
