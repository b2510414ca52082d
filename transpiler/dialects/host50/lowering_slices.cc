// SLICES=SLICED: the slow part cut into as many slices as a slow cycle has ticks (4.3).
//
// Where no jump leaves its slice, the slow routine is a choice by the slice. Otherwise a cursor says which network
// comes next, and the networks stand one behind the other: jumps go as in the uncut part, in front of each network at
// which a slice may end its tick's part is asked, and at the begin of a tick the cursor's network is gone to.

#include "transpiler/dialects/host50/lowering_internal.h"

namespace plcxx::host50 {

using ir::OpKind;
using ir::ValueId;

std::vector<uint32_t> Lowering::SliceOfNetworks(const Section& section) const {
  uint64_t all = 0, before = 0;
  for (uint32_t i = 0; i < section.networks.count; ++i) all += WeightOf(tree_, NetworkId(section.networks.first + i));
  std::vector<uint32_t> slices;
  for (uint32_t i = 0; i < section.networks.count; ++i) {
    slices.push_back(static_cast<uint32_t>(settings_.slowdiv * before / all));
    before += WeightOf(tree_, NetworkId(section.networks.first + i));
  }
  return slices;
}

/// Whether an LBL goes to another slice, or back: then a refused one would end the whole pass.
bool Lowering::JumpsLeaveSlices(const Section& section, const std::vector<uint32_t>& slices) const {
  for (uint32_t i = 0; i < section.networks.count; ++i) {
    const Span& instructions = tree_.networks[NetworkId(section.networks.first + i)].instructions;
    for (uint32_t k = 0; k < instructions.count; ++k) {
      const Instruction& instruction = tree_.instructions[InstructionId(instructions.first + k)];
      if (instruction.op != Op::kLbl) continue;
      const uint32_t target = OperandOf(tree_, instruction, 0).network.index - section.networks.first;
      if (target <= i || slices[target] != slices[i]) return true;
    }
  }
  return false;
}

void Lowering::SlicesByChoice(const Section& section, const std::vector<uint32_t>& slices) {
  ir::Switch choice;
  for (uint32_t i = 0; i < section.networks.count;) {
    const uint32_t slice = slices[i];
    const ir::RegionId region = builder_.RegionOf([&] {
      for (; i < section.networks.count && slices[i] == slice; ++i) {
        BeginNetwork(NetworkId(section.networks.first + i));
        LowerNetwork(NetworkId(section.networks.first + i));
      }
    });
    choice.cases.push_back({.values = {slice}, .region = region});
  }
  builder_.SetRange({});
  if (!choice.cases.empty()) builder_.SwitchOn(builder_.Load(slice_), std::move(choice));
}

void Lowering::SlicesByCursor(const Section& section, const std::vector<uint32_t>& slices) {
  const uint32_t count = section.networks.count, first = section.networks.first;
  const auto number = [this](uint32_t value) { return builder_.Constant(ir::Type::kI32, value); };
  now_.cursor = NewSystemPlace("next_network", ir::Type::kI32);
  if (has_way_back_[now_.section.index]) CountJumps(ir::Lifetime::kVolatile);
  const ValueId slice = builder_.Load(slice_), zero = number(0);
  const ValueId begins = builder_.Pure(OpKind::kEqual32, {slice, zero});
  builder_.If(begins, builder_.RegionOf([&] {
    builder_.Store(now_.cursor, number(0));
    if (now_.jumps_left.valid()) builder_.Store(now_.jumps_left, number(kMostJumps));
  }));
  // Where no network ends this tick's part below, the pass is over until slice 0 begins the next one.
  const ValueId next = builder_.Load(now_.cursor), behind = number(count);
  builder_.Store(now_.cursor, behind);
  // A slice's part may end in front of its successor's first network and of each target of a jump.
  const auto may_end_at = [&](uint32_t i) { return i > 0 && (slices[i] != slices[i - 1] || is_target_[first + i]); };
  for (uint32_t i = 1; i < count; ++i) {
    if (may_end_at(i)) builder_.Jump(first + i, builder_.Pure(OpKind::kEqual32, {next, number(i)}));
  }
  builder_.Jump(now_.end_label, builder_.Pure(OpKind::kEqual32, {next, behind}));
  now_.end_is_used = true;
  for (uint32_t i = 0; i < count; ++i) {
    const NetworkId network(first + i);
    const bool asks = may_end_at(i);
    if (asks) is_target_[network.index] = true;
    BeginNetwork(network);
    if (asks && slices[i] > 0) EndSliceBefore(i, slices[i]);
    LowerNetwork(network);
  }
}

/// A statement of its own: the one before must be free to be switched off.
void Lowering::EndSliceBefore(uint32_t index, uint32_t slice) {
  const source::Range range = waiting_comments_.back();  // the NETWORK line
  waiting_comments_.pop_back();
  AddStatement(range, {});
  const ValueId now = builder_.Load(slice_), own = builder_.Constant(ir::Type::kI32, slice);
  const ValueId later = builder_.Pure(OpKind::kLess32, {now, own});
  builder_.If(later, builder_.RegionOf([&] {
    builder_.Store(now_.cursor, builder_.Constant(ir::Type::kI32, index));
    builder_.Jump(now_.end_label);
  }));
}

void Lowering::SlicedSlow(SectionId id) {
  const Section& section = tree_.sections[id];
  const std::vector<uint32_t> slices = SliceOfNetworks(section);
  if (JumpsLeaveSlices(section, slices)) return SlicesByCursor(section, slices);
  SlicesByChoice(section, slices);
}

}  // namespace plcxx::host50
