// Mechanisms: waits, steps, automatic timers (specification 6.7, 7.1 to 7.4).

#include <algorithm>

#include "transpiler/dialects/technol/lowering/internal.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

ir::PlaceId Lowering::StepPlace(UnitId unit) {
  const auto [found, is_new] = steps_.try_emplace(unit.index);
  if (is_new) {
    found->second = program_.places.Add({.name = tree_.units[unit].name + "_step",
                                         .type = Type::kI16,
                                         .space = memory_[SpaceKey::kSteps],
                                         .offset = std::exchange(step_bytes_, step_bytes_ + 2)});
  }
  return found->second;
}

ir::PlaceId Lowering::TimerPlace(UnitId unit, uint32_t number) {
  const auto [found, is_new] = timers_.try_emplace(std::pair(unit.index, number));
  if (is_new) {
    const std::string& name = tree_.units[unit].name;
    found->second = program_.places.Add({.name = name + "_timer" + (number == 0 ? "" : std::to_string(number + 1)),
                                         .type = Type::kI16,
                                         .space = memory_[SpaceKey::kSteps],
                                         .offset = std::exchange(step_bytes_, step_bytes_ + 2)});
  }
  return found->second;
}

ir::PlaceId Lowering::ActivationPlace(UnitId unit) {
  const Unit& mechanism = tree_.units[unit];
  if (mechanism.kind == UnitKind::kModule) {
    return SystemPlace(mechanism.module == ModuleKind::kPripravne ? "NC_PRIPRAVNE" : "NC_ZAVERECNE");
  }
  const auto [found, is_new] = activations_.try_emplace(unit.index);
  if (is_new) {
    if (mechanisms_before_.empty()) {
      uint32_t number = 0;
      for (uint32_t i = 0; i < tree_.units.size(); ++i) {
        mechanisms_before_.push_back(number);
        if (tree_.units[UnitId(i)].kind == UnitKind::kMechanism) ++number;
      }
    }
    found->second = program_.places.Add({.name = mechanism.name,
                                         .type = Type::kBit,
                                         .space = memory_[SpaceKey::kMechanisms],
                                         .offset = mechanisms_before_[unit.index],
                                         .bit = 0});
  }
  return found->second;
}

void Lowering::Leave(InstructionId resume) {
  const auto at = std::lower_bound(body_->entries.begin(), body_->entries.end(), resume);
  const bool begins = at == body_->entries.end() || *at != resume;  // as if nothing had run
  if (!body_->entries.empty()) {
    const auto step = begins ? 0 : static_cast<uint64_t>(at - body_->entries.begin()) + 1;
    builder_.Store(StepPlace(body_->unit), builder_.Constant(step, 16));
  }
  end_is_used_ = true;
  builder_.Jump(kEndLabel);
}

void Lowering::Wait() {
  Leave(flow_.ResumeOf(now_));
  registers_.Forget();  // nothing survives
}

void Lowering::WaitFor(const Instruction& /*instruction*/, uint64_t rlo) {
  const ValueId value = registers_.rlo().Get();
  registers_.Spill();
  builder_.When(rlo == 0 ? value : builder_.Not(value), [&] { Leave(flow_.ResumeOf(now_)); });
  registers_.rlo().Know(rlo);
}

/// 16 bits: a constant, or a word that is looked at in each pass.
ValueId Lowering::TimerLimit(const Operand& operand) { return ReadAs(operand, 16); }

void Lowering::WaitAtMost(const Instruction& instruction, uint64_t rlo) {
  const Operand& cell = tree_.OperandOf(instruction, 0);
  const ValueId value = registers_.rlo().Get();
  const Reach timer = ReachOf(cell);
  const ValueId limit = TimerLimit(tree_.OperandOf(instruction, 1));
  const ValueId zero = builder_.Constant(0, 16), one = builder_.Constant(1, 16);
  registers_.Spill();
  builder_.When(rlo == 0 ? value : builder_.Not(value), [&] {
    const auto expire = [&] {
      builder_.Store(timer.place, zero, timer.index);
      Jump(TargetOf(instruction), {});
    };
    if (builder_.KnownValue(limit) == 0) return expire();
    const ValueId count = builder_.Load(timer.place, timer.index);
    builder_.When(builder_.Pure(OpKind::kGreaterEqual32, {builder_.ToWidth(count, 32), builder_.ToWidth(limit, 32)}),
                  expire);
    builder_.Store(timer.place, builder_.Pure(OpKind::kAdd16, {count, one}), timer.index);
    Leave(flow_.ResumeOf(now_));
  });
  builder_.Store(timer.place, zero, timer.index);
  registers_.rlo().Know(rlo);
}

void Lowering::Delay(const Instruction& instruction) {
  const Reach timer = ReachOf(tree_.OperandOf(instruction, 0));
  const ValueId limit = TimerLimit(tree_.OperandOf(instruction, 1));
  registers_.Spill();
  if (builder_.KnownValue(limit) != 0) {
    const ValueId count = builder_.Load(timer.place, timer.index);
    builder_.When(builder_.Pure(OpKind::kLess32, {builder_.ToWidth(count, 32), builder_.ToWidth(limit, 32)}), [&] {
      builder_.Store(timer.place, builder_.Pure(OpKind::kAdd16, {count, builder_.Constant(1, 16)}), timer.index);
      Leave(flow_.ResumeOf(now_));
    });
  }
  builder_.Store(timer.place, builder_.Constant(0, 16), timer.index);
}

void Lowering::Rewind(UnitId unit) {
  const Body* body = BodyOfMechanism(unit);
  if (body != nullptr && !body->entries.empty()) builder_.Store(StepPlace(unit), builder_.Constant(0, 16));
  for (uint32_t i = 0; i < tree_.units[unit].timers; ++i) builder_.Store(TimerPlace(unit, i), builder_.Constant(0, 16));
}

void Lowering::RewindIfCleared(UnitId unit) {
  const Body* body = BodyOfMechanism(unit);
  if ((body == nullptr || body->entries.empty()) && tree_.units[unit].timers == 0) return;
  builder_.When(builder_.Not(builder_.Load(ActivationPlace(unit))), [&] { Rewind(unit); });
}

void Lowering::EndMechanism(UnitId unit) {
  builder_.Store(ActivationPlace(unit), builder_.Bit(0));
  Rewind(unit);
}

void Lowering::InitMechanism(const Instruction& instruction) {
  const UnitId mechanism = tree_.OperandOf(instruction, 0).mechanism;
  EndMechanism(mechanism);
  LeaveStopped(mechanism);
  if (mechanism == body_->unit) registers_.Forget();
}

/// A mechanism that stops itself is left at once. A subprogram runs to its end, so that one that stops everything does,
/// and the mechanism that has called it is left then (6.7, 7.1).
void Lowering::LeaveStopped(UnitId mechanism) {
  if (mechanism == body_->unit) {
    end_is_used_ = true;
    return builder_.Jump(kEndLabel);
  }
  const Body* stopped = BodyOfMechanism(mechanism);
  if (!body_->unit.valid() && stopped != nullptr && stopped->stopped_by_callee) {
    builder_.Store(StoppedPlace(mechanism), builder_.Bit(1));
  }
}

ir::PlaceId Lowering::StoppedPlace(UnitId mechanism) {
  return Local(tree_.units[mechanism].name + "_stopped", Type::kBit);
}

}  // namespace plcxx::technol
