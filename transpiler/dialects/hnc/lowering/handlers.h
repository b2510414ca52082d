// Handlers of M, S, T, B and E requests (specification 7.3): numbers of functions that are known when compiling; no
// function pointers exist at run time.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "transpiler/dialects/hnc/analysis/registrations.h"
#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class Memory;

class Handlers : Context {
 public:
  Handlers(const Context& context, Memory& memory) : Context(context), memory_(memory) {}

  /// Calls what is registered for the kind; `otherwise` where nothing is. Slots are read where handlers are not fixed.
  void Call(uint32_t kind, ir::PlaceId channel, const std::function<void()>& otherwise);
  /// A handler goes into its slot, as a number among the functions that are registered anywhere for it. One that is
  /// fixed has no slot: the dispatcher calls it.
  void Register(const Expr& call);
  void AddSlots();
  /// None: what is registered for it is fixed, or nothing is.
  ir::PlaceId SlotOf(const Registration& registration) const { return slots_[registration.channel][registration.kind]; }
  /// What its slot holds after the registration: 0 for none.
  uint8_t NumberOf(const Registration& registration) const;

 private:
  Memory& memory_;
  FixedHandlers fixed_ = FindFixedHandlers(unit_, facts_);
  std::array<std::array<ir::PlaceId, 5>, 4> slots_;                  // of handlers that are not fixed
  std::array<std::array<std::vector<FunctionId>, 5>, 4> functions_;  // by channel and kind: that a slot may hold
};

}  // namespace plcxx::hnc
