#include "transpiler/dialects/hnc/lowering/handlers.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering/memory.h"

namespace plcxx::hnc {

using ir::ValueId;

void Handlers::Call(uint32_t kind, ir::PlaceId channel, const std::function<void()>& otherwise) {
  bool any = false;
  for (uint32_t c = 0; c < 4; ++c) {
    any = any || !functions_[c][kind].empty() || fixed_[c][kind].value_or(FunctionId()).valid();
  }
  if (!any) {
    if (otherwise) otherwise();
    return;
  }
  ir::Switch channels;
  const auto none = [&] {
    if (otherwise) otherwise();
  };
  const auto call = [&](FunctionId handler, uint32_t channel_number) {
    const ir::RoutineId routine = placement_.routines[handler.index];
    std::vector<ValueId> arguments;
    if (!program_.routines[routine].parameters.empty()) arguments.push_back(Word(channel_number));
    builder_.CallRoutine(routine, std::move(arguments));
  };
  for (uint32_t c = 0; c < 4; ++c) {
    const FunctionId fixed = fixed_[c][kind].value_or(FunctionId());
    if (fixed.valid()) {
      builder_.AddArm(channels, {c}, [&] { call(fixed, c); });
      continue;
    }
    const std::vector<FunctionId>& handlers = functions_[c][kind];
    if (handlers.empty()) continue;
    builder_.AddArm(channels, {c}, [&] {
      ir::Switch slots;
      for (uint32_t i = 0; i < handlers.size(); ++i) {
        builder_.AddArm(slots, {i + 1}, [&] { call(handlers[i], c); });
      }
      builder_.AddArm(slots, {}, none);
      builder_.SwitchOn(builder_.Load(slots_[c][kind]), std::move(slots));
    });
  }
  builder_.AddArm(channels, {}, none);
  builder_.SwitchOn(builder_.Load(channel), std::move(channels));
}

void Handlers::Register(const Expr& call) {
  for (const Registration& registration : facts_.registrations()) {
    if (&ExprAt(registration.call) != &call) continue;
    const ir::PlaceId slot = SlotOf(registration);
    if (slot.valid()) builder_.Store(slot, builder_.Constant(ir::Type::kI8, this->NumberOf(registration)));
    return;
  }
}

void Handlers::AddSlots() {
  for (const Registration& registration : facts_.registrations()) {
    if (fixed_[registration.channel][registration.kind]) continue;
    ir::PlaceId& slot = slots_[registration.channel][registration.kind];
    if (!slot.valid()) {
      slot = memory_.AddScalar(
          "handler_" + std::string(1, kHandlerKinds[registration.kind]) + std::to_string(registration.channel),
          ir::Type::kI8);
    }
    if (!registration.function.valid()) continue;
    std::vector<FunctionId>& handlers = functions_[registration.channel][registration.kind];
    if (std::ranges::find(handlers, registration.function) == handlers.end()) handlers.push_back(registration.function);
  }
}

uint8_t Handlers::NumberOf(const Registration& registration) const {
  if (!registration.function.valid()) return 0;
  const std::vector<FunctionId>& handlers = functions_[registration.channel][registration.kind];
  return static_cast<uint8_t>(std::ranges::find(handlers, registration.function) - handlers.begin() + 1);
}

}  // namespace plcxx::hnc
