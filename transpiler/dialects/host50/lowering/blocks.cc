#include "transpiler/dialects/host50/lowering/blocks.h"

#include "transpiler/dialects/host50/lowering/cells.h"
#include "transpiler/dialects/host50/lowering/numbers.h"
#include "transpiler/dialects/host50/lowering/routines.h"

namespace plcxx::host50 {
namespace {

using ir::OpKind;
using ir::ValueId;

struct Arithmetic {
  Op op;
  Type type;
  OpKind kind;
};
constexpr Arithmetic kArithmetic[] = {
    {Op::kAddw, Type::kInteger, OpKind::kAdd32},
    {Op::kSubw, Type::kInteger, OpKind::kSub32},
    {Op::kMulw, Type::kInteger, OpKind::kMul32},
    {Op::kDivw, Type::kInteger, OpKind::kQuotientOrDividend32},
    {Op::kWand, Type::kInteger, OpKind::kAnd32},
    {Op::kWor, Type::kInteger, OpKind::kOr32},
    {Op::kWxor, Type::kInteger, OpKind::kXor32},
    {Op::kAddf, Type::kFloat, OpKind::kAddF32},
    {Op::kSubf, Type::kFloat, OpKind::kSubF32},
    {Op::kMulf, Type::kFloat, OpKind::kMulF32},
    {Op::kDivf, Type::kFloat, OpKind::kQuotientOrDividendF32},
};

Address BitOf(Address first, uint32_t index) {
  first.number = static_cast<uint16_t>(first.number + index);
  return first;
}

}  // namespace

void Blocks::Calculate(const Instruction& instruction) {
  for (const Arithmetic& row : kArithmetic) {
    if (row.op != instruction.op) continue;
    const ValueId a = numbers_.Of(OperandOf(instruction, 0), row.type);
    const ValueId b = numbers_.Of(OperandOf(instruction, 1), row.type);
    return cells_.Store(OperandOf(instruction, 2).address, builder_.Pure(row.kind, {a, b}));
  }
  PLCXX_UNREACHABLE();
}

void Blocks::Negate(const Instruction& instruction) {
  const Address& place = OperandOf(instruction, 0).address;
  const ValueId value = cells_.Load(place);
  if (TypeOf(place) == Type::kFloat) return cells_.Store(place, builder_.Pure(OpKind::kNegateF32, {value}));
  cells_.Store(place, builder_.Pure(OpKind::kSub32, {builder_.Constant(ir::Type::kI32, 0), value}));
}

/// MOV, FTOW, WTOF: the types say what is converted.
void Blocks::Move(const Instruction& instruction) {
  const Address& target = OperandOf(instruction, 1).address;
  cells_.Store(target, numbers_.Of(OperandOf(instruction, 0), TypeOf(target)));
}

void Blocks::BitsToWord(const Instruction& instruction) {
  const Address& first = OperandOf(instruction, 0).address;
  const Address& target = OperandOf(instruction, 1).address;
  const uint32_t count = OperandOf(instruction, 2).bits;
  ValueId word;
  if (settings_.btow == BtowOption::kKeep && count < kMostBits) {
    const ValueId above = builder_.Constant(ir::Type::kI32, 0xFFFFFFFFU << count, 16);
    word = builder_.Pure(OpKind::kAnd32, {cells_.Load(target), above});
  }
  for (uint32_t i = 0; i < count; ++i) {
    const ValueId bit = cells_.Load(BitOf(first, i));
    const ValueId placed = builder_.Pure(OpKind::kBitAt32, {bit, builder_.Constant(ir::Type::kI32, i)});
    word = word.valid() ? builder_.Pure(OpKind::kOr32, {word, placed}) : placed;
  }
  cells_.Store(target, word);
}

void Blocks::WordToBits(const Instruction& instruction) {
  const ValueId word = numbers_.Of(OperandOf(instruction, 0), Type::kInteger);
  const Address& first = OperandOf(instruction, 1).address;
  for (uint32_t i = 0; i < OperandOf(instruction, 2).bits; ++i) {
    cells_.Store(BitOf(first, i), builder_.Pure(OpKind::kTestBit32, {word, builder_.Constant(ir::Type::kI32, i)}));
  }
}

void Blocks::Assign(const Instruction& instruction) {
  const Address& target = OperandOf(instruction, 0).address;
  cells_.Store(target, numbers_.Evaluate(OperandOf(instruction, 1).expr, TypeOf(target)));
}

void Blocks::Act(const Instruction& instruction) {
  builder_.SetRange(instruction.range);
  switch (instruction.op) {
    case Op::kSet:
    case Op::kRst:
      return cells_.Store(OperandOf(instruction, 0).address, builder_.Bit(instruction.op == Op::kSet ? 1 : 0));
    case Op::kAddw:
    case Op::kSubw:
    case Op::kMulw:
    case Op::kDivw:
    case Op::kWand:
    case Op::kWor:
    case Op::kWxor:
    case Op::kAddf:
    case Op::kSubf:
    case Op::kMulf:
    case Op::kDivf:
      return Calculate(instruction);
    case Op::kNeg:
      return Negate(instruction);
    case Op::kMov:
    case Op::kFtow:
    case Op::kWtof:
      return Move(instruction);
    case Op::kBtow:
      return BitsToWord(instruction);
    case Op::kWtob:
      return WordToBits(instruction);
    case Op::kOprt:
      return Assign(instruction);
    case Op::kCall:
      builder_.CallRoutine(routines_.Of(OperandOf(instruction, 0).section), {});
      return;
    case Op::kLd:
    case Op::kLdi:
    case Op::kLdp:
    case Op::kLdf:
    case Op::kAnd:
    case Op::kAndi:
    case Op::kAndp:
    case Op::kAndf:
    case Op::kOr:
    case Op::kOri:
    case Op::kOrp:
    case Op::kOrf:
    case Op::kAnb:
    case Op::kOrb:
    case Op::kMps:
    case Op::kMrd:
    case Op::kMpp:
    case Op::kOut:
    case Op::kOuti:
    case Op::kRung:
    case Op::kRemark:
    case Op::kLbl:
    case Op::kHome:
    case Op::kPosa:
    case Op::kPosm:
    case Op::kVelp:
    case Op::kVeln:
    case Op::kEq:
    case Op::kNe:
    case Op::kGt:
    case Op::kGe:
    case Op::kLt:
    case Op::kLe:
    case Op::kComp:
    case Op::kCnud:
    case Op::kRot:
    case Op::kTon:
    case Op::kTof:
    case Op::kTp:
      break;
  }
  PLCXX_UNREACHABLE();  // these do not ask whether to act
}

}  // namespace plcxx::host50
