// Facts that decisions rest on, as assertions (option facts=checked): a comparison folded, a sign dropped, a
// check of an index or a divisor left out, a loop called proved. A false one leaves the number of its statement in
// `false_fact`.

#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

void Lowering::AddFalseFact() {
  if (settings_.facts == FactsOption::kChecked) false_fact_ = AddScalar("false_fact", ir::Type::kI32);
}

void Lowering::Check(ValueId fact) {
  if (!false_fact_.valid()) return;
  ValueId wrong = Pure(OpKind::kBitNot, {fact});
  if (given_.valid()) wrong = Pure(OpKind::kBitAnd, {given_, wrong});
  When(wrong, [this] { NoteFalseFact(); });
}

/// The first one says why; what comes after it may follow from it.
void Lowering::NoteFalseFact() {
  When(Pure(OpKind::kEqual32, {builder_.Load(false_fact_), Long(0)}), [this] {
    builder_.Store(false_fact_, builder_.Constant(ir::Type::kI32, statement_id_ == 0 ? 1 : statement_id_, 16));
  });
}

/// That a number is where it is believed to be. What its type, or the byte that it was widened from, says is no belief.
void Lowering::CheckBounds(const Value& value) {
  if (!false_fact_.valid() || value.is_bit || !IsInteger(TypeAt(value.type)) || KnownInteger(value)) return;
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
  if (value.bounds.low > all.low) Check(Pure(not_below, {number, constant(value.bounds.low)}));
  if (value.bounds.high < all.high) Check(Pure(not_above, {number, constant(value.bounds.high)}));
}

}  // namespace plcxx::hnc
