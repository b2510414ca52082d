// FM 15 to FM 18: bytes and words at a computed address (specification 6.9, D40).

#include "transpiler/dialects/prostep/lowering_internal.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::ValueId;

Lowering::Reach Lowering::ReachOf(const Instruction& instruction, uint32_t bytes) {
  const Operand &base = tree_.Argument(instruction, 0), &displacement = tree_.Argument(instruction, 1);
  const uint32_t last = BytesOf(base.space()) - bytes;
  Reach reach;
  if (displacement.shape() == Shape::kConstant) {
    reach.constant = base.number + static_cast<int16_t>(displacement.value);
    if (*reach.constant < 0 || *reach.constant > static_cast<int32_t>(last)) reach.outside = builder_.Bit(1);
    return reach;
  }
  const bool byte = displacement.shape() == Shape::kByte;
  const ValueId value = ReadData(displacement);
  const ValueId wide = builder_.Pure(byte ? OpKind::kWiden8To32 : OpKind::kSignExtend16To32, {value});
  reach.address = Moved(wide, base.number);
  // Without a sign: what is below 0 is above everything else.
  if (!byte || base.number + 0xFFu > last) {
    reach.outside = builder_.Pure(OpKind::kGreater32, {reach.address, Number(last)});
  } else if (facts_.on()) {
    const ValueId inside = builder_.Pure(OpKind::kLessEqual32, {reach.address, Number(last)});
    facts_.Check(ir::FactKind::kIndex, inside, reach.address);
  }
  return reach;
}

void Lowering::ReadIndirect(const Instruction& instruction, ir::Type type) {
  const Space space = tree_.Argument(instruction, 0).space();
  const Reach reach = ReachOf(instruction, ir::Bytes(type));
  const auto set = [&](ValueId value) {
    if (type == ir::Type::kI8) {
      SetLowByte(value);
    } else {
      ax_->Set(value);
    }
  };
  if (reach.constant) {
    if (!reach.outside.valid()) return set(LoadAt(space, static_cast<uint32_t>(*reach.constant), type));
    set(builder_.Constant(type, 0));
    return CallFault(Fault::kIndex);
  }
  set(LoadIndexed(space, reach.address, type));
  if (reach.outside.valid()) builder_.When(reach.outside, [&] { CallFault(Fault::kIndex); });
}

void Lowering::WriteIndirect(const Instruction& instruction, ir::Type type) {
  const Space space = tree_.Argument(instruction, 0).space();
  const Reach reach = ReachOf(instruction, ir::Bytes(type));
  const ValueId value = type == ir::Type::kI8 ? LowByte() : ax_->Get();
  if (reach.constant) {
    if (!reach.outside.valid()) return StoreAt(space, static_cast<uint32_t>(*reach.constant), type, value);
    return CallFault(Fault::kIndex);
  }
  StoreIndexed(space, reach.address, type, value);
  if (reach.outside.valid()) builder_.When(reach.outside, [&] { CallFault(Fault::kIndex); });
}

}  // namespace plcxx::prostep
