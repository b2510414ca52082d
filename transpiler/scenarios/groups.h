// Which scenarios are worked on together: their programs become one executable for each platform.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/separate_processes.h"

namespace plcxx::scenarios {

/// A scenario that can be run: its number and the request of its program.
struct GroupedScenario {
  uint32_t item = 0;
  compilation::CompilationRequest request;
};

/// In the order of the scenarios, but those of one program together. There are groups for `jobs` processes where there
/// are as many programs; large programs are in groups of their own.
std::vector<ItemGroup> MakeGroups(const std::vector<GroupedScenario>& scenarios, unsigned jobs);

}  // namespace plcxx::scenarios
