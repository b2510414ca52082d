// Inline assembler: moves, sums, logic, jumps (specification 6.9). Values are what the registers hold; a flag is
// computed where somebody reads it.

#include "transpiler/dialects/technol/lowering/internal.h"

namespace plcxx::technol {

using ir::OpKind;
using ir::Type;
using ir::ValueId;

namespace {

constexpr ByWidth kAdd = {OpKind::kAdd8, OpKind::kAdd16, OpKind::kAdd32};
constexpr ByWidth kSub = {OpKind::kSub8, OpKind::kSub16, OpKind::kSub32};
constexpr ByWidth kAnd = {OpKind::kAnd8, OpKind::kAnd16, OpKind::kAnd32};
constexpr ByWidth kOr = {OpKind::kOr8, OpKind::kOr16, OpKind::kOr32};
constexpr ByWidth kXor = {OpKind::kXor8, OpKind::kXor16, OpKind::kXor32};
constexpr ByWidth kNot = {OpKind::kNot8, OpKind::kNot16, OpKind::kNot32};
constexpr ByWidth kCarry = {OpKind::kCarryOfAdd8, OpKind::kCarryOfAdd16, OpKind::kCarryOfAdd32};
constexpr ByWidth kBorrow = {OpKind::kBorrowOfSub8, OpKind::kBorrowOfSub16, OpKind::kBorrowOfSub32};
constexpr ByWidth kAddOverflow = {OpKind::kOverflowOfAdd8, OpKind::kOverflowOfAdd16, OpKind::kOverflowOfAdd32};
constexpr ByWidth kSubOverflow = {OpKind::kOverflowOfSub8, OpKind::kOverflowOfSub16, OpKind::kOverflowOfSub32};

uint32_t StackBase(uint32_t level) { return level * kStackWords; }

}  // namespace

void Lowering::Assemble(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::kMov: {
      const Operand& target = tree_.OperandOf(instruction, 0);
      return Write(target, ReadAs(tree_.OperandOf(instruction, 1), target.width));
    }
    case Op::kAdd:
    case Op::kAdc:
    case Op::kSub:
    case Op::kSbb:
    case Op::kCmp:
      return AddOrSubtract(instruction);
    case Op::kAsmAnd:
    case Op::kAsmOr:
    case Op::kAsmXor:
    case Op::kTest:
      return Logic(instruction);
    case Op::kInc:
    case Op::kDec:
      return Increment(instruction);
    case Op::kNeg:
      return Negate(instruction);
    case Op::kNot: {
      const Operand& target = tree_.OperandOf(instruction, 0);
      const Reach reach = ReachOfTarget(target);
      return WriteAt(target, reach, builder_.Pure(kNot.At(target.width), {ReadAt(target, reach)}));
    }
    case Op::kShl:
    case Op::kShr:
    case Op::kSar:
      return Shift(instruction);
    case Op::kRol:
    case Op::kRor:
      return Rotate(instruction);
    case Op::kRcl:
    case Op::kRcr:
      return RotateWithCarry(instruction);
    case Op::kMul:
    case Op::kImul:
      return MultiplyRegister(instruction);
    case Op::kDiv:
    case Op::kIdiv:
      return DivideRegister(instruction);
    case Op::kPush:
      return Push(instruction);
    case Op::kPop:
      return Pop(instruction);
    case Op::kMovzx:
    case Op::kMovsx:
      return Extend(instruction);
    case Op::kXchg:
      return Exchange(instruction);
    case Op::kCbw:
      return registers_.Write(Register::kAx, builder_.Pure(OpKind::kSignExtend8To16, {registers_.Read(Register::kAl)}));
    case Op::kCwd: {
      const ValueId wide = builder_.SignedTo32(registers_.Read(Register::kAx));
      return registers_.Write(Register::kDx, builder_.Pure(OpKind::kHighHalf32, {wide}));
    }
    case Op::kCwde:
      return registers_.Write(Register::kEax, builder_.SignedTo32(registers_.Read(Register::kAx)));
    case Op::kCdq: {
      const ValueId low = registers_.Read(Register::kEax);
      return registers_.Write(Register::kEdx,
                              builder_.Pure(OpKind::kArithmeticShiftRight32, {low, builder_.Number(31)}));
    }
    case Op::kDaa:
    case Op::kDas:
      return Decimal(instruction);
    case Op::kAam:
    case Op::kAad:
      return Unpack(instruction);
    case Op::kClc:
      return Flag(kCf, [&] { return builder_.Bit(0); });
    case Op::kStc:
      return Flag(kCf, [&] { return builder_.Bit(1); });
    case Op::kCmc: {
      const ValueId carry = FlagValue(kCf);
      return Flag(kCf, [&] { return builder_.Not(carry); });
    }
    case Op::kNop:
      return;
    case Op::kJmp:
      registers_.Spill();
      return Jump(TargetOf(instruction), {});
    case Op::kLoop:
    case Op::kJcxz:
      return LoopJump(instruction);
    case Op::kJe:
    case Op::kJne:
    case Op::kJc:
    case Op::kJnc:
    case Op::kJa:
    case Op::kJbe:
    case Op::kJg:
    case Op::kJge:
    case Op::kJl:
    case Op::kJle:
    case Op::kJs:
    case Op::kJns:
    case Op::kJo:
    case Op::kJno: {
      const ValueId condition = Condition(instruction.op);
      registers_.Spill();
      return Jump(TargetOf(instruction), condition);
    }
    // TECHNOL's own instructions, and marks
#define TECHNOL_ASSEMBLER(...)
#define TECHNOL_INSTRUCTION(Key, ...) case Op::k##Key:
#include "transpiler/dialects/technol/machine.def"
    case Op::kMechanismBegin:
    case Op::kMechanismEnd:
    case Op::kModuleEnd:
    case Op::kAreaEnd:
    case Op::kUnknown:
      PLCXX_UNREACHABLE();
  }
}

void Lowering::AddOrSubtract(const Instruction& instruction) {
  const Operand& target = tree_.OperandOf(instruction, 0);
  const uint32_t width = target.width;
  const bool adds = instruction.op == Op::kAdd || instruction.op == Op::kAdc;
  const bool carries = instruction.op == Op::kAdc || instruction.op == Op::kSbb;
  if (IsClearing(tree_, instruction)) {
    registers_.Write(target.reg, builder_.Constant(0, width));
    UndefineFlags(kFlags & ~kZf);  // 0 is what SUB r,r leaves in them
    return Flag(kZf, [&] { return builder_.Bit(1); });
  }
  const Reach reach = ReachOfTarget(target);
  const ValueId left = ReadAt(target, reach);
  const ValueId right = ReadAs(tree_.OperandOf(instruction, 1), width);
  const ByWidth& row = adds ? kAdd : kSub;
  ValueId result = builder_.Pure(row.At(width), {left, right});
  if (carries) {
    const ValueId carry = builder_.Pure(OpKind::kWiden1To32, {FlagValue(kCf)});
    result = builder_.Pure(row.At(width), {result, builder_.ToWidth(carry, width)});
  }
  if (instruction.op != Op::kCmp) WriteAt(target, reach, result);
  Flag(kCf, [&] {
    if (carries) return builder_.Pure((adds ? kCarry : kBorrow).At(width), {left, right, result});
    if (adds) return builder_.Pure(OpKind::kLess32, {builder_.ToWidth(result, 32), builder_.ToWidth(left, 32)});
    return builder_.Pure(OpKind::kLess32, {builder_.ToWidth(left, 32), builder_.ToWidth(right, 32)});
  });
  Flag(kOf, [&] { return builder_.Pure((adds ? kAddOverflow : kSubOverflow).At(width), {left, right, result}); });
  Flag(kAf, [&] {
    return builder_.Pure(OpKind::kHalfCarry8,
                         {builder_.ToWidth(left, 8), builder_.ToWidth(right, 8), builder_.ToWidth(result, 8)});
  });
  ResultFlags(result, width);
  if (!adds && !carries) compared_ = {.left = left, .right = right, .width = width};
}

void Lowering::Logic(const Instruction& instruction) {
  const Operand& target = tree_.OperandOf(instruction, 0);
  const uint32_t width = target.width;
  ValueId result;
  if (IsClearing(tree_, instruction)) {
    result = builder_.Constant(0, width);
    registers_.Write(target.reg, result);
  } else {
    const Reach reach = ReachOfTarget(target);
    const ValueId left = ReadAt(target, reach);
    const ValueId right = ReadAs(tree_.OperandOf(instruction, 1), width);
    const ByWidth& row = instruction.op == Op::kAsmOr ? kOr : instruction.op == Op::kAsmXor ? kXor : kAnd;
    // TEST AX,AX and OR AX,AX ask for the value as it is.
    const bool same = left == right && instruction.op != Op::kAsmXor;
    result = same ? left : builder_.Pure(row.At(width), {left, right});
    if (instruction.op != Op::kTest && !same) WriteAt(target, reach, result);
  }
  UndefineFlags(kCf | kOf);  // both are 0
  ResultFlags(result, width);
  compared_ = {.left = result, .right = builder_.Constant(0, width), .width = width};
}

void Lowering::Increment(const Instruction& instruction) {
  const Operand& target = tree_.OperandOf(instruction, 0);
  const uint32_t width = target.width;
  const bool up = instruction.op == Op::kInc;
  const Reach reach = ReachOfTarget(target);
  const ValueId left = ReadAt(target, reach);
  const ValueId one = builder_.Constant(1, width);
  const ValueId result = builder_.Pure((up ? kAdd : kSub).At(width), {left, one});
  WriteAt(target, reach, result);
  Flag(kOf, [&] { return builder_.Pure((up ? kAddOverflow : kSubOverflow).At(width), {left, one, result}); });
  Flag(kAf, [&] {
    return builder_.Pure(OpKind::kHalfCarry8,
                         {builder_.ToWidth(left, 8), builder_.Byte(1), builder_.ToWidth(result, 8)});
  });
  ResultFlags(result, width);
}

void Lowering::Negate(const Instruction& instruction) {
  const Operand& target = tree_.OperandOf(instruction, 0);
  const uint32_t width = target.width;
  const Reach reach = ReachOfTarget(target);
  const ValueId value = ReadAt(target, reach);
  const ValueId zero = builder_.Constant(0, width);
  const ValueId result = builder_.Pure(kSub.At(width), {zero, value});
  WriteAt(target, reach, result);
  Flag(kCf, [&] { return builder_.Not(IsZero(value, width)); });
  Flag(kOf, [&] { return builder_.Pure(kSubOverflow.At(width), {zero, value, result}); });
  Flag(kAf, [&] {
    return builder_.Pure(OpKind::kHalfCarry8,
                         {builder_.Byte(0), builder_.ToWidth(value, 8), builder_.ToWidth(result, 8)});
  });
  ResultFlags(result, width);
}

void Lowering::Exchange(const Instruction& instruction) {
  const Operand &first = tree_.OperandOf(instruction, 0), &second = tree_.OperandOf(instruction, 1);
  const bool first_is_memory = first.kind == OperandKind::kMemory;
  const Operand &memory = first_is_memory ? first : second, &reg = first_is_memory ? second : first;
  if (memory.kind == OperandKind::kMemory) {
    const Reach reach = ReachOf(memory);
    const ValueId value = builder_.Load(reach.place, reach.index);
    builder_.Store(reach.place, Read(reg), reach.index);
    return Write(reg, value);
  }
  const ValueId left = Read(first), right = Read(second);
  Write(first, right);
  Write(second, left);
}

void Lowering::Extend(const Instruction& instruction) {
  const Operand &target = tree_.OperandOf(instruction, 0), &source = tree_.OperandOf(instruction, 1);
  const ValueId value = Read(source);
  if (instruction.op == Op::kMovzx) return Write(target, builder_.ToWidth(value, target.width));
  if (source.width == 8 && target.width == 16) return Write(target, builder_.Pure(OpKind::kSignExtend8To16, {value}));
  Write(target, builder_.SignedTo32(value));
}

/// Each depth of the stack is a local of its own; subprograms use those behind their callers'.
void Lowering::Push(const Instruction& instruction) {
  const Operand& reg = tree_.OperandOf(instruction, 0);
  const uint32_t slot = StackBase(body_->level) + flow_.PushesBefore(now_);
  const bool wide = reg.width == 32;
  builder_.Store(Local("pushed" + std::to_string(slot) + (wide ? "_wide" : ""), wide ? Type::kI32 : Type::kI16),
                 Read(reg));
}

void Lowering::Pop(const Instruction& instruction) {
  const Operand& reg = tree_.OperandOf(instruction, 0);
  const uint32_t slot = StackBase(body_->level) + flow_.PushesBefore(now_) - 1;
  const bool wide = reg.width == 32;
  Write(reg,
        builder_.Load(Local("pushed" + std::to_string(slot) + (wide ? "_wide" : ""), wide ? Type::kI32 : Type::kI16)));
}

void Lowering::LoopJump(const Instruction& instruction) {
  ValueId count = registers_.Read(Register::kCx);
  OpKind test = OpKind::kEqual16;
  if (instruction.op == Op::kLoop) {
    count = builder_.Pure(OpKind::kSub16, {count, builder_.Constant(1, 16)});
    registers_.Write(Register::kCx, count);
    test = OpKind::kNotEqual16;
  }
  const ValueId condition = builder_.Pure(test, {count, builder_.Constant(0, 16)});
  registers_.Spill();
  Jump(TargetOf(instruction), condition);
}

}  // namespace plcxx::technol
