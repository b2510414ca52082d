#include "transpiler/dialects/prostep/lowering/indirect_access.h"

#include "transpiler/dialects/prostep/lowering/cells.h"
#include "transpiler/dialects/prostep/lowering/faults.h"
#include "transpiler/dialects/prostep/lowering/indexed_cells.h"
#include "transpiler/dialects/prostep/lowering/operands.h"
#include "transpiler/dialects/prostep/lowering/registers.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::ValueId;

IndirectAccess::Reach IndirectAccess::ReachOf(const Instruction& instruction, uint32_t bytes) {
  const Operand &base = Argument(instruction, 0), &displacement = Argument(instruction, 1);
  const uint32_t last = BytesOf(base.space()) - bytes;
  Reach reach;
  if (displacement.shape() == Shape::kConstant) {
    reach.constant = base.number + static_cast<int16_t>(displacement.value);
    if (*reach.constant < 0 || *reach.constant > static_cast<int32_t>(last)) reach.outside = builder_.Bit(1);
    return reach;
  }
  const bool byte = displacement.shape() == Shape::kByte;
  const ValueId value = operands_.Read(displacement);
  const ValueId wide = Pure(byte ? OpKind::kWiden8To32 : OpKind::kSignExtend16To32, {value});
  reach.address = indexed_.Moved(wide, base.number);
  // Without a sign: what is below 0 is above everything else.
  if (!byte || base.number + 0xFFu > last) {
    reach.outside = Pure(OpKind::kGreater32, {reach.address, Number(last)});
  } else if (facts_.on()) {
    const ValueId inside = Pure(OpKind::kLessEqual32, {reach.address, Number(last)});
    facts_.Check(ir::FactKind::kIndex, inside, reach.address);
  }
  return reach;
}

void IndirectAccess::Read(const Instruction& instruction, ir::Type type) {
  const Space space = Argument(instruction, 0).space();
  const Reach reach = ReachOf(instruction, ir::Bytes(type));
  const auto set = [&](ValueId value) {
    if (type == ir::Type::kI8) {
      registers_.SetLowByte(value);
    } else {
      registers_.ax().Set(value);
    }
  };
  if (reach.constant) {
    if (!reach.outside.valid()) return set(cells_.Load(space, static_cast<uint32_t>(*reach.constant), type));
    set(builder_.Constant(type, 0));
    return faults_.Report(Fault::kIndex);
  }
  set(indexed_.Load(space, reach.address, type));
  if (reach.outside.valid()) faults_.ReportWhen(reach.outside, Fault::kIndex);
}

void IndirectAccess::Write(const Instruction& instruction, ir::Type type) {
  const Space space = Argument(instruction, 0).space();
  const Reach reach = ReachOf(instruction, ir::Bytes(type));
  const ValueId value = type == ir::Type::kI8 ? registers_.LowByte() : registers_.ax().Get();
  if (reach.constant) {
    if (!reach.outside.valid()) return cells_.Store(space, static_cast<uint32_t>(*reach.constant), type, value);
    return faults_.Report(Fault::kIndex);
  }
  indexed_.Store(space, reach.address, type, value);
  if (reach.outside.valid()) faults_.ReportWhen(reach.outside, Fault::kIndex);
}

}  // namespace plcxx::prostep
