#include "transpiler/dialects/hnc/lowering/live_path.h"

#include <utility>

namespace plcxx::hnc {

void LivePath::JumpTo(uint32_t label) {
  if (!flow_.reachable) return;
  builder_.Jump(label);
  const auto [target, added] = targets_.emplace(label, flow_);
  if (!added) target->second.JoinWith(flow_);
  flow_.reachable = false;
}

bool LivePath::PlaceLabel(uint32_t label) {
  const auto found = targets_.find(label);
  if (found == targets_.end()) return false;
  builder_.Label(label);
  flow_.JoinWith(found->second);
  targets_.erase(found);
  return true;
}

void LivePath::BeginFunction() {
  next_label_ = kEndOfFunction + 1;
  targets_.clear();
  around_.clear();
}

void LivePath::JumpWhen(ir::ValueId condition, uint32_t label) {
  builder_.Jump(label, condition);
  targets_[label] = flow_;
}

std::vector<Flow> LivePath::Leave() {
  std::vector<Flow> ends = std::move(around_.back().at_ends);
  around_.pop_back();
  return ends;
}

void LivePath::Break() {
  if (!around_.empty()) JumpTo(around_.back().on_break);
}

void LivePath::Continue() {
  for (size_t i = around_.size(); i-- > 0;) {
    if (!around_[i].is_loop) continue;
    JumpTo(around_[i].on_continue);
    return;
  }
}

void LivePath::EndCase() {
  if (flow_.reachable) around_.back().at_ends.push_back(flow_);
  flow_.reachable = false;
}

}  // namespace plcxx::hnc
