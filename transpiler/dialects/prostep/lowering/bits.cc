#include "transpiler/dialects/prostep/lowering/bits.h"

#include "transpiler/dialects/common/logic_stack.h"
#include "transpiler/dialects/prostep/lowering/cells.h"
#include "transpiler/dialects/prostep/lowering/instances.h"
#include "transpiler/dialects/prostep/lowering/logic.h"
#include "transpiler/dialects/prostep/lowering/operands.h"
#include "transpiler/support/check.h"

namespace plcxx::prostep {

using dialects::Inverted;
using dialects::Join;
using ir::OpKind;
using ir::ValueId;

ValueId Bits::Read(const Operand& operand) {
  switch (operand.shape()) {
    case Shape::kCounter:
      return Pure(OpKind::kNotEqual16, {builder_.Load(instances_.ValueOf(operand.number)), Word(0)});
    case Shape::kTimer:
      return builder_.Load(instances_.OutputOf(operand.number));
    case Shape::kBit:
      break;
    case Shape::kByte:
    case Shape::kWord:
    case Shape::kDouble:
    case Shape::kConstant:
    case Shape::kModule:
    case Shape::kFunction:
      PLCXX_UNREACHABLE();
  }
  if (operand.space() != Space::kP) return builder_.Load(cells_.Bit(operand));
  return Pure(OpKind::kTestBit8, {operands_.ReadPort(operand.number), Byte(operand.bit)});
}

void Bits::Assign(const Operand& target) {
  const ValueId value = logic_.Value();
  const ir::PlaceId place = cells_.Bit(target);
  builder_.Store(place, value);
  if (target.space() == Space::kP) operands_.SendLatch(target.number);
}

void Bits::WritePort(const Operand& target, uint64_t value) {
  const ir::PlaceId place = cells_.Bit(target);
  builder_.When(logic_.Value(), [&] {
    builder_.Store(place, builder_.Bit(value));
    operands_.SendLatch(target.number);
  });
}

void Bits::Set(const Operand& target) {
  if (target.space() == Space::kP) return WritePort(target, 1);
  const ir::PlaceId place = cells_.Bit(target);
  const ValueId before = builder_.Load(place);
  builder_.Store(place, dialects::Joined(builder_, Join::kOr, before, logic_.Value()));
}

void Bits::Reset(const Operand& target) {
  if (target.space() == Space::kP) return WritePort(target, 0);
  const ir::PlaceId place = cells_.Bit(target);
  const ValueId before = builder_.Load(place);
  builder_.Store(place, dialects::Joined(builder_, Join::kAnd, before, Inverted(builder_, logic_.Value())));
}

}  // namespace plcxx::prostep
