#include "transpiler/dialects/classicladder/lowering/jumps.h"

#include <string>

namespace plcxx::classicladder {

using ir::ValueId;

void Jumps::Begin(const Section& section, const std::vector<uint32_t>& chain) {
  now_ = {};
  now_.end_label = next_label_++;
  for (size_t i = 0; i < chain.size(); ++i) now_.order[chain[i]] = i;
  bool goes_back = false;
  for (const uint32_t number : chain) {
    for (const auto& row : tree_.rungs.at(number).rows) {
      for (const Element& element : row) {
        if (element.kind != ElementKind::kJump || !now_.order.contains(element.number)) continue;
        now_.targets.insert(element.number);
        goes_back = goes_back || now_.order[element.number] <= now_.order[number];
      }
    }
  }
  if (!goes_back) return;
  now_.jumps_left = places_.NewSystemPlace("jumps_left_" + std::to_string(section.number), ir::Type::kI32);
  builder_.Store(now_.jumps_left, Word(kMostJumps));
}

void Jumps::BeginRung(uint32_t rung) {
  now_.position = now_.order[rung];
  if (now_.targets.contains(rung)) builder_.Label(LabelOf(rung));
}

void Jumps::End() {
  if (now_.end_is_used) builder_.Label(now_.end_label);
}

uint32_t Jumps::LabelOf(uint32_t rung) {
  const auto [found, is_new] = now_.labels.try_emplace(rung, next_label_);
  if (is_new) ++next_label_;
  return found->second;
}

void Jumps::Refuse() {
  builder_.Store(schedule_.stopped(), builder_.Bit(1));
  faults_.Report(Fault::kJumpLoop);
  now_.end_is_used = true;
  builder_.Jump(now_.end_label);
}

bool Jumps::Jump(Signal condition, uint32_t rung) {
  if (condition.kind == Signal::Kind::kZero) return true;
  const ValueId taken = condition.kind == Signal::Kind::kOne ? ValueId() : condition.value;
  const auto target = now_.order.find(rung);
  if (target == now_.order.end()) {
    now_.end_is_used = true;
    builder_.Jump(now_.end_label, taken);
  } else if (target->second <= now_.position) {
    const ir::RegionId refused = builder_.RegionOf([this] { Refuse(); });
    builder_.JumpBack(LabelOf(rung), taken, now_.jumps_left, refused);
  } else if (!now_.jumps_left.valid()) {
    builder_.Jump(LabelOf(rung), taken);
  } else {
    // The engine counts jumps forward, too.
    logic_.When(condition, [&] {
      const ValueId left = builder_.Load(now_.jumps_left);
      const ValueId none = builder_.Pure(ir::OpKind::kEqual32, {left, Word(0)});
      builder_.When(none, [&] { Refuse(); });
      builder_.Store(now_.jumps_left, builder_.Pure(ir::OpKind::kSub32, {left, Word(1)}));
      builder_.Jump(LabelOf(rung));
    });
  }
  return taken.valid();
}

}  // namespace plcxx::classicladder
