#include "transpiler/prove/verify/constant_arguments.h"

#include <algorithm>

namespace plcxx::prove::verify {
namespace {

constexpr size_t kMostCases = 16;

/// What a call passes to a parameter, if it is a constant.
std::optional<uint64_t> ConstantFor(const ir::Program& program, const ir::Call& call, ir::PlaceId parameter) {
  const std::vector<ir::PlaceId>& places = program.routines[call.routine].parameter_places;
  const auto at = static_cast<size_t>(std::ranges::find(places, parameter) - places.begin());
  if (at >= call.arguments.size()) return std::nullopt;
  const ir::Inst& value = program[ir::InstId(call.arguments[at].index)];
  return value.op == ir::OpKind::kConst ? std::optional(ir::ConstantValue(value)) : std::nullopt;
}

}  // namespace

std::vector<ArgumentCase> ArgumentCases(const ir::Program& program, const Unit& unit) {
  const ArgumentCase unknown(unit.values.size());
  // A chunk gets its locals from the middle of a routine; others are called from outside with anything.
  if (unit.part.region.valid() || program.routines[unit.part.routine].kind != ir::RoutineKind::kSubroutine)
    return {unknown};
  std::vector<ArgumentCase> cases;
  std::vector<bool> is_constant(unit.values.size(), true);
  for (uint32_t i = 0; i < program.calls.size(); ++i) {
    const ir::Call& call = program.calls[ir::CallId(i)];
    if (call.routine != unit.part.routine) continue;
    ArgumentCase& one = cases.emplace_back(unknown);
    for (size_t k = 0; k < unit.values.size(); ++k) {
      one[k] = ConstantFor(program, call, unit.values[k]);
      is_constant[k] = is_constant[k] && one[k].has_value();
    }
  }
  std::vector<ArgumentCase> distinct;
  for (ArgumentCase& one : cases) {
    for (size_t k = 0; k < one.size(); ++k) {
      if (!is_constant[k]) one[k].reset();
    }
    if (std::ranges::find(distinct, one) == distinct.end()) distinct.push_back(std::move(one));
  }
  if (distinct.empty() || distinct.size() > kMostCases) return {unknown};
  return distinct;
}

}  // namespace plcxx::prove::verify
