#include "transpiler/dialects/technol/lowering/conditions.h"

#include "transpiler/dialects/technol/lowering/flags.h"
#include "transpiler/support/check.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr ByWidth kSignedLess = {OpKind::kSignedLess8, OpKind::kSignedLess16, OpKind::kSignedLess32};
constexpr ByWidth kSignedLessEqual = {OpKind::kSignedLessEqual8, OpKind::kSignedLessEqual16,
                                      OpKind::kSignedLessEqual32};
constexpr ByWidth kSignedGreater = {OpKind::kSignedGreater8, OpKind::kSignedGreater16, OpKind::kSignedGreater32};
constexpr ByWidth kSignedGreaterEqual = {OpKind::kSignedGreaterEqual8, OpKind::kSignedGreaterEqual16,
                                         OpKind::kSignedGreaterEqual32};

}  // namespace

void Conditions::Remember(ValueId left, ValueId right, uint32_t width) {
  compared_ = {.left = left, .right = right, .width = width};
}

ValueId Conditions::Holds(Relation relation) {
  return compared_.left.valid() ? HoldsOfValues(relation) : HoldsOfFlags(relation);
}

ValueId Conditions::HoldsOfValues(Relation relation) {
  const auto with_sign = [&](const ByWidth& comparison) {
    return Pure(comparison.At(compared_.width), {compared_.left, compared_.right});
  };
  const auto without_sign = [&](OpKind comparison) {
    return Pure(comparison, {builder_.ToWidth(compared_.left, 32), builder_.ToWidth(compared_.right, 32)});
  };
  switch (relation) {
    case Relation::kEqual:
      return without_sign(OpKind::kEqual32);
    case Relation::kNotEqual:
      return without_sign(OpKind::kNotEqual32);
    case Relation::kBelow:
      return without_sign(OpKind::kLess32);
    case Relation::kNotBelow:
      return without_sign(OpKind::kGreaterEqual32);
    case Relation::kBelowOrEqual:
      return without_sign(OpKind::kLessEqual32);
    case Relation::kAbove:
      return without_sign(OpKind::kGreater32);
    case Relation::kLess:
      return with_sign(kSignedLess);
    case Relation::kNotLess:
      return with_sign(kSignedGreaterEqual);
    case Relation::kLessOrEqual:
      return with_sign(kSignedLessEqual);
    case Relation::kGreater:
      return with_sign(kSignedGreater);
  }
  PLCXX_UNREACHABLE();
}

ValueId Conditions::HoldsOfFlags(Relation relation) {
  const auto less = [&] { return Pure(OpKind::kBitXor, {flags_.Value(kSf), flags_.Value(kOf)}); };
  switch (relation) {
    case Relation::kEqual:
      return flags_.Value(kZf);
    case Relation::kNotEqual:
      return builder_.Not(flags_.Value(kZf));
    case Relation::kBelow:
      return flags_.Value(kCf);
    case Relation::kNotBelow:
      return builder_.Not(flags_.Value(kCf));
    case Relation::kBelowOrEqual:
      return Pure(OpKind::kBitOr, {flags_.Value(kCf), flags_.Value(kZf)});
    case Relation::kAbove:
      return builder_.Not(HoldsOfFlags(Relation::kBelowOrEqual));
    case Relation::kLess:
      return less();
    case Relation::kNotLess:
      return builder_.Not(less());
    case Relation::kLessOrEqual:
      return Pure(OpKind::kBitOr, {flags_.Value(kZf), less()});
    case Relation::kGreater:
      return builder_.Not(HoldsOfFlags(Relation::kLessOrEqual));
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::technol
