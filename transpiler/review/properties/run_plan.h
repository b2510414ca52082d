// A run of a program as it is planned: what is set when, and how long it takes.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/symbolic/execute/cells.h"

namespace plcxx::review::properties {

/// Inputs as they are set before a period, requests as they are taken back.
struct RunEvent {
  uint32_t period = 0;  // from 1
  execute::CellId cell;
  bool value = false;
};

struct RunPlan {
  std::vector<RunEvent> events;  // ascending by period
  uint32_t periods = 0;
};

}  // namespace plcxx::review::properties
