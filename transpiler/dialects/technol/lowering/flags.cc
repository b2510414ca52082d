#include "transpiler/dialects/technol/lowering/flags.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::ValueId;

ValueId Flags::SignOf(ValueId value, uint32_t width) {
  if (width == 8) return Pure(OpKind::kSignBit8, {value});
  return Pure(OpKind::kTestBit32, {builder_.ToWidth(value, 32), builder_.Number(width - 1)});
}

ValueId Flags::IsZero(ValueId value, uint32_t width) {
  constexpr ByWidth kEqual = {OpKind::kEqual8, OpKind::kEqual16, OpKind::kEqual32};
  return Pure(kEqual.At(width), {value, builder_.Constant(0, width)});
}

void Flags::SetResult(ValueId result, uint32_t width) {
  Set(kZf, [&] { return IsZero(result, width); });
  Set(kSf, [&] { return SignOf(result, width); });
}

void Flags::Undefine(Resources flags) {
  for (uint32_t i = 0; i < kFlagCount; ++i) {
    const Resources flag = kCf << i;
    if ((flags & flag) != 0) Set(flag, [&] { return builder_.Bit(0); });
  }
}

}  // namespace plcxx::technol
