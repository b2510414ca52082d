#include "transpiler/measure/budgets.h"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"

namespace plcxx::measure {
namespace {

constexpr uint64_t kMost = uint64_t{1} << 40;  // counts saturate here

uint64_t Sum(uint64_t a, uint64_t b) { return std::min(a + b, kMost); }
uint64_t Product(uint64_t a, uint64_t b) { return b != 0 && a > kMost / b ? kMost : a * b; }

/// Counts how often a budget is filled: every filling is taken as the largest one. What is left may be kept in another
/// place while something else counts, or until the next slice: such a place belongs to the budget, too, and a transfer
/// between both fills nothing.
class Fillings {
 public:
  Fillings(const ir::Program& program, ir::PlaceId budget) : program_(program), places_{budget.index} {
    for (size_t known = 0; known != places_.size();) {
      known = places_.size();
      for (const ir::Inst& inst : program_.insts) {
        if (const ir::Inst* value = Stored(inst); value != nullptr && IsLoad(*value)) places_.insert(value->payload);
      }
    }
  }

  /// None: something fills it that is no constant, or a loop without a bound of its own does.
  std::optional<uint64_t> RoundsFrom(ir::RoutineId entry) {
    uint64_t largest = 0;
    for (const ir::Inst& inst : program_.insts) {
      const ir::Inst* value = Stored(inst);
      if (value == nullptr || IsLoad(*value)) continue;
      if (value->op != ir::OpKind::kConst) return std::nullopt;
      largest = std::max(largest, ir::ConstantValue(*value));
    }
    uint64_t fillings = OfRoutine(entry);
    // What was left when the partition began: of an earlier call.
    const bool outlives = std::ranges::any_of(places_, [this](uint32_t place) {
      return program_.spaces[program_.places[ir::PlaceId(place)].space].lifetime != ir::Lifetime::kRoutine;
    });
    if (outlives) fillings = Sum(fillings, 1);
    if (unknown_ || fillings == kMost) return std::nullopt;
    return Product(fillings, largest);
  }

 private:
  static bool IsLoad(const ir::Inst& inst) { return ir::Info(inst.op).shape == ir::Shape::kLoad; }
  /// What is stored into the budget; null: something else happens.
  const ir::Inst* Stored(const ir::Inst& inst) const {
    const bool stores = ir::Info(inst.op).shape == ir::Shape::kStore && places_.contains(inst.payload);
    return stores ? &program_[ir::ValueId(inst.a)] : nullptr;
  }

  uint64_t OfRoutine(ir::RoutineId id) {
    const ir::Routine& routine = program_.routines[id];
    uint64_t count = 0;
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) count = Sum(count, Of(region));
    return count;
  }

  uint64_t Of(ir::RegionId region) {
    uint64_t count = 0;
    if (!region.valid()) return count;
    for (const ir::InstId id : program_.regions[region].insts) count = Sum(count, Of(program_[id]));
    return count;
  }

  uint64_t Of(const ir::Inst& inst) {
    if (const ir::Inst* value = Stored(inst)) return value->op == ir::OpKind::kConst ? 1 : 0;
    if (inst.op == ir::OpKind::kCall) return OfRoutine(program_.calls[ir::CallId(inst.payload)].routine);
    if (!ir::OwnsRegions(inst)) return 0;
    // Arms of a switch may fall into the next one.
    const bool one_of_them = inst.op == ir::OpKind::kIf;
    uint64_t all = 0, most = 0;
    for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) {
      const uint64_t own = Of(owned);
      all = Sum(all, own);
      most = std::max(most, own);
    }
    if (inst.op != ir::OpKind::kLoop) return one_of_them ? most : all;
    const ir::Loop& loop = program_.loops[ir::LoopId(inst.payload)];
    const bool bounded = loop.kind != ir::LoopBound::kBudget;
    if (all > 0 && !bounded) unknown_ = true;
    return bounded ? Product(all, Sum(loop.bound, 1)) : all;
  }

  const ir::Program& program_;
  std::set<uint32_t> places_;  // by PlaceId
  bool unknown_ = false;
};

}  // namespace

std::map<uint32_t, uint64_t> BudgetRounds(const ir::Program& program, ir::RoutineId entry) {
  std::set<uint32_t> budgets;
  for (const ir::Loop& loop : program.loops) {
    if (loop.kind == ir::LoopBound::kBudget) budgets.insert(loop.budget.index);
  }
  std::map<uint32_t, uint64_t> rounds;
  for (const uint32_t budget : budgets) {
    const std::optional<uint64_t> most = Fillings(program, ir::PlaceId(budget)).RoundsFrom(entry);
    if (most) rounds.emplace(budget, *most);
  }
  return rounds;
}

}  // namespace plcxx::measure
