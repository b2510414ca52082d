// What a program uses of what the control has (specification 9 and 10.1): distinct addresses, blocks, networks.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "transpiler/dialects/host50/syntax/syntax.h"

namespace plcxx::host50 {

struct ResourceUse {
  Resource resource{};
  uint32_t used = 0;
  std::optional<source::Range> surplus;  // the first use beyond Available(resource), in source order
};

/// One for each resource, in the order of the report.
std::vector<ResourceUse> ResourcesOf(const Program& program);

}  // namespace plcxx::host50
