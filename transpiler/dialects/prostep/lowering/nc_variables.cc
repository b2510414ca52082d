#include "transpiler/dialects/prostep/lowering/nc_variables.h"

#include "transpiler/dialects/common/logic_stack.h"
#include "transpiler/dialects/prostep/lowering/cells.h"
#include "transpiler/dialects/prostep/lowering/faults.h"
#include "transpiler/dialects/prostep/lowering/operands.h"
#include "transpiler/dialects/prostep/lowering/scalars.h"

namespace plcxx::prostep {

using ir::OpKind;
using ir::ValueId;

void NcVariables::Read(const Instruction& instruction, ir::Type type) {
  const ValueId index = operands_.Value16(Argument(instruction, 0)),
                offset = operands_.Value16(Argument(instruction, 1));
  const ir::PlaceId answer = scalars_.Of(ScalarPlace::kNcValue);
  const ValueId given = host_(HostCall::kNcRead, {Number(ir::Bytes(type)), index, offset}, answer);
  builder_.Choose(
      given,
      [&] {
        ValueId value = builder_.Load(answer);
        if (type != ir::Type::kI32) value = Pure(OpKind::kLowHalf32, {value});
        if (type == ir::Type::kI8) value = Pure(OpKind::kLowByte16, {value});
        cells_.StoreField(Argument(instruction, 2), type, value);
      },
      [&] { faults_.Report(Fault::kNcAccess); });
}

void NcVariables::Write(const Instruction& instruction, ir::Type type) {
  ValueId value = cells_.LoadField(Argument(instruction, 0), type);
  if (type == ir::Type::kI8) value = Pure(OpKind::kWiden8To32, {value});
  if (type == ir::Type::kI16) value = Pure(OpKind::kWiden16To32, {value});
  const ValueId index = operands_.Value16(Argument(instruction, 1)),
                offset = operands_.Value16(Argument(instruction, 2));
  const ValueId taken = host_(HostCall::kNcWrite, {Number(ir::Bytes(type)), index, offset, value});
  faults_.ReportWhen(dialects::Inverted(builder_, taken), Fault::kNcAccess);
}

}  // namespace plcxx::prostep
