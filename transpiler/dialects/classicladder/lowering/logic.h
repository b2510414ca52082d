// Signals of a rung: bits that are computed, or known while the program is made.
#pragma once

#include "transpiler/dialects/classicladder/lowering/context.h"

namespace plcxx::classicladder {

/// What comes out of an element, or into one.
struct Signal {
  enum class Kind : uint8_t { kZero, kOne, kValue } kind = Kind::kZero;
  ir::ValueId value;

  static Signal One() { return {.kind = Kind::kOne, .value = {}}; }
  static Signal Of(ir::ValueId value) { return {.kind = Kind::kValue, .value = value}; }
};

class Logic : Context {
 public:
  explicit Logic(const Context& context) : Context(context) {}

  ir::ValueId ToBit(Signal signal);
  Signal And(Signal a, Signal b);
  Signal Or(Signal a, Signal b);
  Signal Not(Signal a);
  /// Where `condition` is known, there is no branch.
  template <class Then>
  void When(Signal condition, Then&& then) {
    if (condition.kind == Signal::Kind::kOne) return then();
    if (condition.kind == Signal::Kind::kValue) builder_.When(condition.value, then);
  }
  template <class Then, class Otherwise>
  void Choose(Signal condition, Then&& then, Otherwise&& otherwise) {
    if (condition.kind == Signal::Kind::kOne) return then();
    if (condition.kind == Signal::Kind::kZero) return otherwise();
    builder_.Choose(condition.value, then, otherwise);
  }
};

}  // namespace plcxx::classicladder
