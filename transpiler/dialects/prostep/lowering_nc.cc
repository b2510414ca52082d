// FM 41 to FM 54: variables of the NC, through the host (specification 6.9, 8.1).

#include "transpiler/dialects/prostep/lowering_internal.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::ValueId;

void Lowering::NcRead(const Instruction& instruction, ir::Type type) {
  const ValueId index = Value16(tree_.Argument(instruction, 0)), offset = Value16(tree_.Argument(instruction, 1));
  const ir::PlaceId answer = PlaceOf(ScalarPlace::kNcValue);
  const ValueId given = host_(HostCall::kNcRead, {Number(ir::Bytes(type)), index, offset}, answer);
  builder_.Choose(
      given,
      [&] {
        ValueId value = builder_.Load(answer);
        if (type != ir::Type::kI32) value = builder_.Pure(OpKind::kLowHalf32, {value});
        if (type == ir::Type::kI8) value = builder_.Pure(OpKind::kLowByte16, {value});
        StoreField(tree_.Argument(instruction, 2), type, value);
      },
      [&] { CallFault(Fault::kNcAccess); });
}

void Lowering::NcWrite(const Instruction& instruction, ir::Type type) {
  ValueId value = LoadField(tree_.Argument(instruction, 0), type);
  if (type == ir::Type::kI8) value = builder_.Pure(OpKind::kWiden8To32, {value});
  if (type == ir::Type::kI16) value = builder_.Pure(OpKind::kWiden16To32, {value});
  const ValueId index = Value16(tree_.Argument(instruction, 1)), offset = Value16(tree_.Argument(instruction, 2));
  const ValueId taken = host_(HostCall::kNcWrite, {Number(ir::Bytes(type)), index, offset, value});
  builder_.When(dialects::Inverted(builder_, taken), [&] { CallFault(Fault::kNcAccess); });
}

}  // namespace plcxx::prostep
