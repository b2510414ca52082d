// How many rounds the loops of a partition make at most that share a budget.
#pragma once

#include <cstdint>
#include <map>

#include "transpiler/ir/program.h"

namespace plcxx::measure {

/// By the place of the budget: what `entry` and all that it calls can take from it in one call, repetitions of all its
/// loops together. Of a budget that is not there the most is not known. `program` is structured.
std::map<uint32_t, uint64_t> BudgetRounds(const ir::Program& program, ir::RoutineId entry);

}  // namespace plcxx::measure
