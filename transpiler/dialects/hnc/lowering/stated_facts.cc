#include "transpiler/dialects/hnc/lowering/stated_facts.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

void StatedFacts::Check(ir::FactKind kind, ValueId fact, ValueId value) {
  if (!checks_.on()) return;
  if (given_.valid()) fact = Pure(OpKind::kBitOr, {Pure(OpKind::kBitNot, {given_}), fact});
  checks_.Check(kind, fact, value);
}

void StatedFacts::Where(ValueId condition, bool holds, const std::function<void()>& body) {
  if (!checks_.on()) {
    body();
    return;
  }
  const ValueId chosen = holds ? condition : Pure(OpKind::kBitNot, {condition});
  const ValueId outer = given_;
  given_ = outer.valid() ? Pure(OpKind::kBitAnd, {outer, chosen}) : chosen;
  body();
  given_ = outer;
}

void StatedFacts::CheckBounds(ir::FactKind kind, const Value& value) {
  if (!checks_.on() || value.is_bit || !IsInteger(TypeAt(value.type)) || KnownInteger(value)) return;
  const OpKind made_by = program_[value.id].op;
  const bool from_byte = made_by == OpKind::kWiden8To16 || made_by == OpKind::kWiden8To32;
  if (from_byte && Bounds{0, 255}.Within(value.bounds)) return;
  const Type& type = TypeAt(value.type);
  const Bounds all = BoundsOf(type);
  if (all.Within(value.bounds)) return;
  // Compared as it is kept, whatever its bounds say of its sign.
  const bool wide = type.bits == 32, sign = type.is_signed;
  ValueId number = value.id;
  if (type.bits == 8) number = Pure(sign ? OpKind::kSignExtend8To16 : OpKind::kWiden8To16, {number});
  const auto constant = [&](int64_t bound) {
    return wide ? Long(static_cast<uint32_t>(bound)) : Word(static_cast<uint32_t>(bound) & 0xFFFF);
  };
  const OpKind not_below = wide ? (sign ? OpKind::kSignedGreaterEqual32 : OpKind::kGreaterEqual32)
                                : (sign ? OpKind::kSignedGreaterEqual16 : OpKind::kGreaterEqual16);
  const OpKind not_above = wide ? (sign ? OpKind::kSignedLessEqual32 : OpKind::kLessEqual32)
                                : (sign ? OpKind::kSignedLessEqual16 : OpKind::kLessEqual16);
  if (value.bounds.low > all.low) Check(kind, Pure(not_below, {number, constant(value.bounds.low)}), number);
  if (value.bounds.high < all.high) Check(kind, Pure(not_above, {number, constant(value.bounds.high)}), number);
}

}  // namespace plcxx::hnc
