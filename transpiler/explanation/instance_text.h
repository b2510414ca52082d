// What a timer, a counter or an edge has kept, in words: how long a timer has run, and what is left.
#pragma once

#include <cstdint>
#include <string>

#include "transpiler/ir/program.h"
#include "transpiler/sim/instances.h"

namespace plcxx::explanation {

/// "1200 of 3000 ms, 1800 ms left"; of what is no timer its fields: "count 3, input 1".
std::string InstanceText(const ir::Program& program, ir::StateId state, const sim::Instances& instances);
/// The same with its verb, so that a sentence can begin with the instance's name: "has run 20 of 3000 ms, 2980 ms
/// left", "is not running", "had count 5, input 1"; of an edge, which is one bit, "had 1".
std::string InstancePredicate(const ir::Program& program, ir::StateId state, const sim::Instances& instances);
/// The value of a field. Counters that count down to a value below 0 have their numbers in two's complement.
std::string FieldDigits(ir::StateKind kind, ir::Type type, uint64_t value);
/// Whether it shows how long it has run, and what is left.
bool IsTimer(ir::StateKind kind);
/// Whether it shows one field only, which then is the instance.
bool HasOneField(ir::StateKind kind);

}  // namespace plcxx::explanation
