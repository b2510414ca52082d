#include "transpiler/sim/changes.h"

#include <algorithm>
#include <numeric>

#include "transpiler/ir/uses.h"

namespace plcxx::sim {

Changed Changes::Made(const ChangedInst& what) const {
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

void Changes::Change(const std::optional<ChangedInst>& changed) {
  changed_.reset();
  region_ = {};
  looks_for_differences_ = !changed && !differences_.empty();
  if (!changed) return;
  changed_ = Made(*changed);
  region_ = changed->region;
  const DecodedRegion& region = code_.Of(changed->region);
  const uint32_t order = code_.Of(changed->id).order;
  // An instruction of a rung is in front of its last one.
  const auto entry = std::lower_bound(code_.ready.begin() + region.ready_begin, code_.ready.begin() + region.ready_end,
                                      order, [](const Decoded& one, uint32_t at) { return one.order < at; });
  entry_ = static_cast<uint32_t>(entry - code_.ready.begin());
}

void Changes::LookForDifferences(const std::vector<ChangedInst>& changes) {
  differences_.clear();
  found_.clear();
  for (const ChangedInst& change : changes) differences_.push_back(Made(change));
  in_order_.resize(changes.size());
  std::iota(in_order_.begin(), in_order_.end(), 0U);
  std::ranges::stable_sort(in_order_, {}, [&](uint32_t i) { return changes[i].id.index; });
  begin_.assign(program_.insts.size() + 1, 0);
  for (const ChangedInst& change : changes) ++begin_[change.id.index + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  looks_for_differences_ = !changes.empty() && !changed_;
}

std::span<const uint32_t> Changes::Of(ir::InstId id) const {
  return std::span(in_order_).subspan(begin_[id.index], begin_[id.index + 1] - begin_[id.index]);
}

void Changes::Found(uint32_t number) {
  differences_[number].wanted = false;
  found_.push_back(number);
}

}  // namespace plcxx::sim
