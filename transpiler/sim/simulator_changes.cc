// The simulator with a change: executing it, and finding where one would make a difference.

#include <algorithm>
#include <numeric>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/support/check.h"

namespace plcxx::sim {

using ir::Inst;
using ir::InstId;

Simulator::Changed Simulator::MakeChanged(const ChangedInst& what) const {
  Changed changed{.what = what, .inst = program_[what.id], .call = {}};
  switch (what.how) {
    case ChangedHow::kLeftOut:
      break;
    case ChangedHow::kOperation:
      changed.inst.op = what.operation;
      break;
    case ChangedHow::kOperand: {
      uint32_t use = 0;
      const auto change = [&](uint32_t& word) {
        if (use++ != what.use) return;
        changed.operand = word;
        word = NumberValue();
      };
      if (ir::IsCall(changed.inst)) {
        changed.call = program_.calls[ir::CallId(changed.inst.payload)];
        for (ir::ValueId& argument : changed.call->arguments) change(argument.index);
        changed.inst.payload = program_.calls.size();
      } else {
        ir::ForEachOperand(changed.inst, change);
      }
      break;
    }
  }
  return changed;
}

void Simulator::Change(const std::optional<ChangedInst>& changed) {
  changed_.reset();
  changed_region_ = {};
  looks_for_differences_ = !changed && !differences_.empty();
  if (!changed) return;
  changed_ = MakeChanged(*changed);
  changed_region_ = changed->region;
  values_[NumberValue()] = changed->number;
  const DecodedRegion& region = decoded_regions_[changed->region.index];
  const uint32_t order = decoded_[decoded_at_[changed->id.index]].order;
  // An instruction of a rung is in front of its last one.
  const auto entry = std::lower_bound(ready_.begin() + region.ready_begin, ready_.begin() + region.ready_end, order,
                                      [](const Decoded& one, uint32_t at) { return one.order < at; });
  changed_entry_ = static_cast<uint32_t>(entry - ready_.begin());
}

Flow Simulator::ExecuteChangedInst() {
  if (changed_->what.how == ChangedHow::kLeftOut) return Flow::kOn;
  return ExecuteAs(changed_->what.id, changed_->inst);
}

Flow Simulator::ExecuteChangedRung(const Decoded& rung) {
  const uint32_t count = rung.step_count() + (rung.has_statement() ? 1 : 0) + (rung.has_coil() ? 1 : 0);
  for (uint32_t at = rung.first(); at < rung.first() + count; ++at) {
    const Decoded& inst = decoded_[at];
    const Flow flow = inst.id == changed_->what.id.index ? ExecuteChangedInst() : inst.execute(*this, inst);
    PLCXX_CHECK(flow == Flow::kOn);
  }
  return Flow::kOn;
}

Flow Simulator::ExecuteChangedRegion(const DecodedRegion& region) {
  const uint32_t count = region.end - region.begin;
  executed_ += count;
  for (uint32_t at = region.ready_begin; at < region.ready_end; ++at) {
    const Decoded& inst = ready_[at];
    const Flow flow = at != changed_entry_ ? inst.execute(*this, inst)
                      : IsRung(inst)       ? ExecuteChangedRung(inst)
                                           : ExecuteChangedInst();
    if (flow == Flow::kOn) continue;
    executed_ -= count - (inst.order + 1);
    return flow;
  }
  return Flow::kOn;
}

void Simulator::LookForDifferences(const std::vector<ChangedInst>& changes) {
  differences_.clear();
  found_.clear();
  for (const ChangedInst& change : changes) differences_.push_back(MakeChanged(change));
  differences_in_order_.resize(changes.size());
  std::iota(differences_in_order_.begin(), differences_in_order_.end(), 0U);
  std::ranges::stable_sort(differences_in_order_, {}, [&](uint32_t i) { return changes[i].id.index; });
  differences_begin_.assign(program_.insts.size() + 1, 0);
  for (const ChangedInst& change : changes) ++differences_begin_[change.id.index + 1];
  std::partial_sum(differences_begin_.begin(), differences_begin_.end(), differences_begin_.begin());
  looks_for_differences_ = !changes.empty() && !changed_;
}

/// Of what has effects: whether it would be executed with something else.
bool Simulator::DiffersBefore(const Changed& changed) {
  if (changed.what.how != ChangedHow::kOperand) return true;
  return values_[changed.operand] != changed.what.number;
}

/// Of what only computes.
bool Simulator::DiffersInResult(const Changed& changed) {
  values_[NumberValue()] = changed.what.number;
  ExecuteAs(InstId(OtherResult()), changed.inst);
  return values_[OtherResult()] != values_[changed.what.id.index];
}

Flow Simulator::ExecuteLookingForDifferences(const Decoded& inst) {
  const uint32_t begin = differences_begin_[inst.id], end = differences_begin_[inst.id + 1];
  if (begin == end) return inst.execute(*this, inst);
  const Inst& program_inst = program_[InstId(inst.id)];
  const ir::Shape shape = ir::Info(program_inst.op).shape;
  const bool computes = shape == ir::Shape::kPure || shape == ir::Shape::kLoad;
  const bool stores = shape == ir::Shape::kStore;
  const auto is_judged_behind = [&](const Changed& changed) {
    return computes || (stores && changed.what.how == ChangedHow::kLeftOut);
  };
  const auto look = [&](bool behind, auto&& differs) {
    for (uint32_t at = begin; at < end; ++at) {
      const uint32_t number = differences_in_order_[at];
      Changed& changed = differences_[number];
      if (!changed.wanted || is_judged_behind(changed) != behind || !differs(changed)) continue;
      changed.wanted = false;
      found_.push_back(number);
    }
  };
  look(false, [this](const Changed& changed) { return DiffersBefore(changed); });
  const PlaceAccess* const place = stores ? &places_[program_inst.payload] : nullptr;
  const auto stored = [&] { return stores ? Get(*place, place->indexed ? values_[program_inst.b] : 0) : 0; };
  const uint64_t before = stored();
  const Flow flow = inst.execute(*this, inst);
  if (computes) look(true, [this](const Changed& changed) { return DiffersInResult(changed); });
  if (stores && stored() != before) look(true, [](const Changed&) { return true; });
  return flow;
}

}  // namespace plcxx::sim
