// Blocks without Q: arithmetic, conversions, bit fields, calls, jumps (6.3, 6.4, 6.7).

#include "transpiler/dialects/host50/lowering_internal.h"

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

void Lowering::Calculate(const Instruction& instruction) {
  for (const Arithmetic& row : kArithmetic) {
    if (row.op != instruction.op) continue;
    const ValueId a = Number(OperandOf(tree_, instruction, 0), row.type);
    const ValueId b = Number(OperandOf(tree_, instruction, 1), row.type);
    return Store(OperandOf(tree_, instruction, 2).address, builder_.Pure(row.kind, {a, b}));
  }
  PLCXX_UNREACHABLE();
}

void Lowering::Negate(const Instruction& instruction) {
  const Address& place = OperandOf(tree_, instruction, 0).address;
  const ValueId value = Load(place);
  if (TypeOf(place) == Type::kFloat) return Store(place, builder_.Pure(OpKind::kNegateF32, {value}));
  Store(place, builder_.Pure(OpKind::kSub32, {builder_.Constant(ir::Type::kI32, 0), value}));
}

/// MOV, FTOW, WTOF: the types say what is converted.
void Lowering::Move(const Instruction& instruction) {
  const Address& target = OperandOf(tree_, instruction, 1).address;
  Store(target, Number(OperandOf(tree_, instruction, 0), TypeOf(target)));
}

void Lowering::BitsToWord(const Instruction& instruction) {
  const Address& first = OperandOf(tree_, instruction, 0).address;
  const Address& target = OperandOf(tree_, instruction, 1).address;
  const uint32_t count = OperandOf(tree_, instruction, 2).bits;
  ValueId word;
  if (settings_.btow == BtowOption::kKeep && count < kMostBits) {
    const ValueId above = builder_.Constant(ir::Type::kI32, 0xFFFFFFFFU << count, 16);
    word = builder_.Pure(OpKind::kAnd32, {Load(target), above});
  }
  for (uint32_t i = 0; i < count; ++i) {
    const ValueId bit = Load(BitOf(first, i));
    const ValueId placed = builder_.Pure(OpKind::kBitAt32, {bit, builder_.Constant(ir::Type::kI32, i)});
    word = word.valid() ? builder_.Pure(OpKind::kOr32, {word, placed}) : placed;
  }
  Store(target, word);
}

void Lowering::WordToBits(const Instruction& instruction) {
  const ValueId word = Number(OperandOf(tree_, instruction, 0), Type::kInteger);
  const Address& first = OperandOf(tree_, instruction, 1).address;
  for (uint32_t i = 0; i < OperandOf(tree_, instruction, 2).bits; ++i) {
    Store(BitOf(first, i), builder_.Pure(OpKind::kTestBit32, {word, builder_.Constant(ir::Type::kI32, i)}));
  }
}

void Lowering::Assign(const Instruction& instruction) {
  const Address& target = OperandOf(tree_, instruction, 0).address;
  Store(target, Evaluate(OperandOf(tree_, instruction, 1).expr, TypeOf(target)));
}

/// A subroutine's refusals are its own matter: it returns, and its caller goes on.
void Lowering::Jump(const Instruction& instruction) {
  open_if_.then = {};
  ValueId condition = TakeInput(instruction.input);
  builder_.SetRange(instruction.range);
  if (IsConstant(condition, 1)) condition = {};
  const NetworkId target = OperandOf(tree_, instruction, 0).network;
  if (target > now_.network) return builder_.Jump(target.index, condition);
  now_.end_is_used = true;
  const ir::RegionId refused = builder_.RegionOf([this] {
    CallFault(Fault::kJumpLoop);
    builder_.Jump(now_.end_label);
  });
  builder_.JumpBack(target.index, condition, now_.jumps_left, refused);
}

void Lowering::CallFault(Fault fault) {
  const Section& section = tree_.sections[now_.section];
  constexpr uint32_t kFastNumber = 0xFFFFFFFE, kSlowNumber = 0xFFFFFFFF;  // -2 and -1
  const uint32_t number = section.kind == SectionKind::kFast   ? kFastNumber
                          : section.kind == SectionKind::kSlow ? kSlowNumber
                                                               : section.number;
  const ValueId code = builder_.Constant(ir::Type::kI8, static_cast<uint64_t>(fault));
  const ValueId where = builder_.Constant(ir::Type::kI32, number);
  host_(HostCall::kFault, {code, where, builder_.Constant(ir::Type::kI32, tree_.networks[now_.network].number)});
}

/// What the block does; its condition holds.
void Lowering::Act(const Instruction& instruction) {
  builder_.SetRange(instruction.range);
  switch (instruction.op) {
    case Op::kSet:
    case Op::kRst:
      return Store(OperandOf(tree_, instruction, 0).address, builder_.Bit(instruction.op == Op::kSet ? 1 : 0));
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
      builder_.CallRoutine(routines_[OperandOf(tree_, instruction, 0).section.index], {});
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
