// Flags: computed where somebody reads them, and conditions of jumps (specification 6.9).
//
// A difference is remembered as what it compares, so that the jump behind it becomes a comparison.

#include "transpiler/dialects/technol/lowering/internal.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::ValueId;

namespace {

struct SignedRow {
  OpKind less, less_equal, greater, greater_equal;
};
constexpr SignedRow kSigned8 = {OpKind::kSignedLess8, OpKind::kSignedLessEqual8, OpKind::kSignedGreater8,
                                OpKind::kSignedGreaterEqual8};
constexpr SignedRow kSigned16 = {OpKind::kSignedLess16, OpKind::kSignedLessEqual16, OpKind::kSignedGreater16,
                                 OpKind::kSignedGreaterEqual16};
constexpr SignedRow kSigned32 = {OpKind::kSignedLess32, OpKind::kSignedLessEqual32, OpKind::kSignedGreater32,
                                 OpKind::kSignedGreaterEqual32};

}  // namespace

ValueId Lowering::Sign(ValueId value, uint32_t width) {
  if (width == 8) return builder_.Pure(OpKind::kSignBit8, {value});
  return builder_.Pure(OpKind::kTestBit32, {builder_.ToWidth(value, 32), builder_.Number(width - 1)});
}

ValueId Lowering::IsZero(ValueId value, uint32_t width) {
  return builder_.Pure(width == 8    ? OpKind::kEqual8
                       : width == 16 ? OpKind::kEqual16
                                     : OpKind::kEqual32,
                       {value, builder_.Constant(0, width)});
}

void Lowering::ResultFlags(ValueId result, uint32_t width) {
  Flag(kZf, [&] { return IsZero(result, width); });
  Flag(kSf, [&] { return Sign(result, width); });
}

/// Where somebody looks at an undefined flag all the same (a count of 0 in CL keeps it), it is 0 (D41).
void Lowering::UndefineFlags(Resources flags) {
  for (uint32_t i = 0; i < kFlagCount; ++i) {
    const Resources flag = kCf << i;
    if ((flags & flag) != 0) Flag(flag, [&] { return builder_.Bit(0); });
  }
}

ValueId Lowering::FlagValue(Resources flag) { return registers_.Flag(flag).Get(); }

ValueId Lowering::Condition(Op op) {
  const bool known = compared_.left.valid();
  const SignedRow& row = compared_.width == 8 ? kSigned8 : compared_.width == 16 ? kSigned16 : kSigned32;
  const auto compare = [&](OpKind kind) { return builder_.Pure(kind, {compared_.left, compared_.right}); };
  const auto unsigned_compare = [&](OpKind kind) {
    return builder_.Pure(kind, {builder_.ToWidth(compared_.left, 32), builder_.ToWidth(compared_.right, 32)});
  };
  const auto less = [&] {
    return known ? compare(row.less) : builder_.Pure(OpKind::kBitXor, {FlagValue(kSf), FlagValue(kOf)});
  };
  const auto less_equal = [&] {
    if (known) return compare(row.less_equal);
    return builder_.Pure(OpKind::kBitOr,
                         {FlagValue(kZf), builder_.Pure(OpKind::kBitXor, {FlagValue(kSf), FlagValue(kOf)})});
  };
  const auto below_equal = [&] {
    if (known) return unsigned_compare(OpKind::kLessEqual32);
    return builder_.Pure(OpKind::kBitOr, {FlagValue(kCf), FlagValue(kZf)});
  };
  switch (op) {
    case Op::kJe:
      return known ? unsigned_compare(OpKind::kEqual32) : FlagValue(kZf);
    case Op::kJne:
      return known ? unsigned_compare(OpKind::kNotEqual32) : builder_.Not(FlagValue(kZf));
    case Op::kJc:
      return known ? unsigned_compare(OpKind::kLess32) : FlagValue(kCf);
    case Op::kJnc:
      return known ? unsigned_compare(OpKind::kGreaterEqual32) : builder_.Not(FlagValue(kCf));
    case Op::kJa:
      return known ? unsigned_compare(OpKind::kGreater32) : builder_.Not(below_equal());
    case Op::kJbe:
      return below_equal();
    case Op::kJg:
      return known ? compare(row.greater) : builder_.Not(less_equal());
    case Op::kJle:
      return less_equal();
    case Op::kJge:
      return known ? compare(row.greater_equal) : builder_.Not(less());
    case Op::kJl:
      return less();
    case Op::kJs:
      return FlagValue(kSf);
    case Op::kJns:
      return builder_.Not(FlagValue(kSf));
    case Op::kJo:
      return FlagValue(kOf);
    case Op::kJno:
      return builder_.Not(FlagValue(kOf));
    default:
      PLCXX_UNREACHABLE();
  }
}

}  // namespace plcxx::technol
