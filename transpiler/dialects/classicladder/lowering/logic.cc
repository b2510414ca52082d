#include "transpiler/dialects/classicladder/lowering/logic.h"

namespace plcxx::classicladder {

using ir::OpKind;
using ir::ValueId;

ValueId Logic::ToBit(Signal signal) {
  if (signal.kind == Signal::Kind::kValue) return signal.value;
  return builder_.Bit(signal.kind == Signal::Kind::kOne ? 1 : 0);
}

Signal Logic::And(Signal a, Signal b) {
  if (a.kind == Signal::Kind::kZero || b.kind == Signal::Kind::kZero) return {};
  if (a.kind == Signal::Kind::kOne) return b;
  if (b.kind == Signal::Kind::kOne) return a;
  return Signal::Of(builder_.Pure(OpKind::kBitAnd, {a.value, b.value}));
}

Signal Logic::Or(Signal a, Signal b) {
  if (a.kind == Signal::Kind::kOne || b.kind == Signal::Kind::kOne) return Signal::One();
  if (a.kind == Signal::Kind::kZero) return b;
  if (b.kind == Signal::Kind::kZero || a.value == b.value) return a;
  return Signal::Of(builder_.Pure(OpKind::kBitOr, {a.value, b.value}));
}

Signal Logic::Not(Signal a) {
  if (a.kind == Signal::Kind::kZero) return Signal::One();
  if (a.kind == Signal::Kind::kOne) return {};
  return Signal::Of(builder_.Pure(OpKind::kBitNot, {a.value}));
}

}  // namespace plcxx::classicladder
