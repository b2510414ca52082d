#include "transpiler/dialects/technol/lowering/operands.h"

#include "transpiler/dialects/technol/lowering/cell_places.h"
#include "transpiler/dialects/technol/lowering/exits.h"
#include "transpiler/dialects/technol/lowering/faults.h"
#include "transpiler/dialects/technol/lowering/mechanism_places.h"
#include "transpiler/support/check.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

namespace {

/// The values that an i32, read as signed, can have.
struct Bounds32 {
  int64_t low = -0x80000000LL, high = 0x7FFFFFFFLL;
};

/// As far as the instruction that made the value shows it.
Bounds32 BoundsOf(const ir::Program& program, ValueId value) {
  const ir::Inst& inst = program[value];
  const auto of = [&](uint32_t operand) { return BoundsOf(program, ValueId(operand)); };
  if (inst.op == OpKind::kConst) {
    const auto bits = static_cast<int64_t>(ir::ConstantValue(inst));
    return bits > 0x7FFFFFFF ? Bounds32{bits - 0x100000000, bits - 0x100000000} : Bounds32{bits, bits};
  }
  if (inst.op == OpKind::kWiden8To16 || inst.op == OpKind::kWiden8To32) return {0, 0xFF};
  if (inst.op == OpKind::kSignExtend16To32) {
    const Bounds32 narrow = of(inst.a);
    return narrow.high <= 0x7FFF ? narrow : Bounds32{};  // no area has room for every word
  }
  if (inst.op == OpKind::kAnd16) {
    const Bounds32 right = of(inst.b);
    return right.low >= 0 ? Bounds32{0, right.high} : Bounds32{};
  }
  return {};
}

}  // namespace

ir::PlaceId Operands::PlaceOf(const Operand& operand) {
  if (operand.is_activation_bit()) return mechanisms_.Activation(operand.mechanism);
  if (operand.kind == OperandKind::kAutomaticTimer) return mechanisms_.Timer(frame_.routine->unit, operand.timer);
  return cells_.Of(operand);
}

ValueId Operands::IndexOf(const Address& address) {
  const ValueId index = registers_.Read(address.index);
  if (Info(address.index).width != 16) return index;
  const auto known = builder_.KnownValue(index);
  return known ? builder_.Number(*known > 0x7FFF ? *known | 0xFFFF0000U : *known)
               : Pure(OpKind::kSignExtend16To32, {index});
}

void Operands::CheckInside(ValueId at, uint32_t bytes, uint32_t area_bytes) {
  // Without a sign: what is below 0 is above everything else.
  const ValueId outside =
      bytes > area_bytes ? builder_.Bit(1) : Pure(OpKind::kGreater32, {at, builder_.Number(area_bytes - bytes)});
  builder_.When(outside, [&] {
    faults_.Report(Fault::kBounds);
    if (settings_.bounds == Bounds::kTrap) exits_.LeaveAll();
  });
}

Operands::Reach Operands::ReachOf(const Operand& operand) {
  const Address& address = operand.address;
  if (operand.kind != OperandKind::kMemory || address.index == Register::kNone) return {PlaceOf(operand), {}};
  const uint32_t size = BytesOf(tree_, address.area), bytes = operand.width / 8U;
  const auto offset = static_cast<uint64_t>(address.offset);
  const auto from_area = [&](ValueId index) { return Pure(OpKind::kAdd32, {index, builder_.Number(offset)}); };
  ValueId index = IndexOf(address);
  const bool at_base = address.offset >= 0 && address.offset < size;
  const Bounds32 bounds = BoundsOf(program_, index);
  const bool inside = bounds.low + address.offset >= 0 && bounds.high + address.offset + bytes <= size;
  if (!inside) {
    const ValueId at = offset == 0 ? index : from_area(index);
    CheckInside(at, bytes, size);
    if (!at_base) index = at;
  } else {
    if (facts_.on()) {
      const ValueId at = from_area(index);
      facts_.Check(ir::FactKind::kIndex, Pure(OpKind::kLessEqual32, {at, builder_.Number(size - bytes)}), at);
    }
    if (!at_base) index = from_area(index);
  }
  return {cells_.Indexed(operand, at_base ? static_cast<uint32_t>(address.offset) : 0), index};
}

Operands::Reach Operands::ReachOfTarget(const Operand& operand) {
  return operand.kind == OperandKind::kMemory ? ReachOf(operand) : Reach{};
}

ValueId Operands::Read(const Operand& operand) {
  switch (operand.kind) {
    case OperandKind::kRegister:
      return registers_.Read(operand.reg);
    case OperandKind::kConstant: {
      const std::string_view text = sources_.Text(operand.range);
      const bool hexadecimal = !text.empty() && (text.back() == 'h' || text.back() == 'H');
      return builder_.Constant(static_cast<uint64_t>(operand.value), operand.width, hexadecimal ? 16 : 10);
    }
    case OperandKind::kMemory: {
      const Reach reach = ReachOf(operand);
      return builder_.Load(reach.place, reach.index);
    }
    case OperandKind::kError:
    case OperandKind::kBit:
    case OperandKind::kLabel:
    case OperandKind::kMechanism:
    case OperandKind::kAutomaticTimer:
      break;
  }
  PLCXX_UNREACHABLE();
}

ValueId Operands::ReadAs(const Operand& operand, uint32_t width) {
  if (operand.kind == OperandKind::kConstant) {
    Operand wide = operand;
    wide.width = static_cast<uint8_t>(width);
    return Read(wide);
  }
  return builder_.ToWidth(Read(operand), width);
}

void Operands::Write(const Operand& operand, ValueId value) {
  if (operand.kind == OperandKind::kRegister) return registers_.Write(operand.reg, value);
  const Reach reach = ReachOf(operand);
  builder_.Store(reach.place, value, reach.index);
}

ValueId Operands::ReadAt(const Operand& operand, const Reach& reach) {
  return reach.place.valid() ? builder_.Load(reach.place, reach.index) : registers_.Read(operand.reg);
}

void Operands::WriteAt(const Operand& operand, const Reach& reach, ValueId value) {
  if (!reach.place.valid()) return registers_.Write(operand.reg, value);
  builder_.Store(reach.place, value, reach.index);
}

}  // namespace plcxx::technol
