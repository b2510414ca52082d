#include "transpiler/dialects/technol/effects.h"

#include "transpiler/support/check.h"

namespace plcxx::technol {
namespace {

constexpr uint32_t kFirstRegisterBit = 6;

Resources IndexOf(const Operand& operand) {
  const bool memory = operand.kind == OperandKind::kMemory;
  return memory && operand.address.index != Register::kNone ? PartsOf(operand.address.index) : 0;
}

/// What computing the operand's value reads.
Resources ReadsOf(const Operand& operand) {
  return operand.kind == OperandKind::kRegister ? PartsOf(operand.reg) : IndexOf(operand);
}

Resources FlagsReadBy(Op op) {
  switch (op) {
    case Op::kJe:
    case Op::kJne:
      return kZf;
    case Op::kJc:
    case Op::kJnc:
      return kCf;
    case Op::kJa:
    case Op::kJbe:
      return kCf | kZf;
    case Op::kJg:
    case Op::kJle:
      return kZf | kSf | kOf;
    case Op::kJge:
    case Op::kJl:
      return kSf | kOf;
    case Op::kJs:
    case Op::kJns:
      return kSf;
    case Op::kJo:
    case Op::kJno:
      return kOf;
    case Op::kAdc:
    case Op::kSbb:
    case Op::kRcl:
    case Op::kRcr:
    case Op::kCmc:
      return kCf;
    case Op::kDaa:
    case Op::kDas:
      return kCf | kAf;
    default:  // all others read none
      return 0;
  }
}

/// The flags behind a shift or rotation.
void ShiftFlags(const Instruction& instruction, const Operand& count, Effects& effects) {
  const bool rotates = instruction.op == Op::kRol || instruction.op == Op::kRor || instruction.op == Op::kRcl ||
                       instruction.op == Op::kRcr;
  const Resources set = rotates ? kCf : kCf | kZf | kSf;
  if (count.kind != OperandKind::kConstant) {
    effects.reads |= PartsOf(Register::kCl);
    effects.writes |= set;
    effects.may_keep = set;
    effects.undefines = rotates ? kOf : kOf | kAf;
    return;
  }
  const auto bits = static_cast<uint32_t>(count.value) & 31U;
  effects.writes |= set;
  if (!rotates) effects.undefines |= kAf;
  (bits == 1 ? effects.writes : effects.undefines) |= kOf;
}

/// Of the assembler instructions; jumps and those without operands included.
void AssemblerEffects(const Program& program, const Instruction& instruction, Effects& effects) {
  const InstructionInfo& info = Info(instruction.op);
  effects.reads |= FlagsReadBy(instruction.op);
  const auto operand = [&](uint32_t index) -> const Operand& { return program.OperandOf(instruction, index); };
  const auto take_first = [&] {
    const Operand& first = operand(0);
    effects.reads |= IndexOf(first);
    if (first.kind != OperandKind::kRegister) return;
    if (info.first != Access::kWrite) effects.reads |= PartsOf(first.reg);
    if (info.first != Access::kRead) effects.writes |= PartsOf(first.reg);
  };
  constexpr Resources kArithmetic = kFlags;
  switch (info.form) {
    case Form::kTwo:
      if (IsClearing(program, instruction)) {
        effects.writes |= PartsOf(operand(0).reg);
      } else {
        take_first();
        effects.reads |= ReadsOf(operand(1));
      }
      break;
    case Form::kOne:
      take_first();
      break;
    case Form::kShift:
      if (operand(1).kind == OperandKind::kConstant && (operand(1).value & 31) == 0) {
        effects.reads = 0;
        return;
      }
      take_first();
      return ShiftFlags(instruction, operand(1), effects);
    case Form::kExchange:
      for (const uint32_t index : {0U, 1U}) {
        effects.reads |= ReadsOf(operand(index));
        if (operand(index).kind == OperandKind::kRegister) effects.writes |= PartsOf(operand(index).reg);
      }
      return;
    case Form::kExtend:
      effects.writes |= PartsOf(operand(0).reg);
      effects.reads |= ReadsOf(operand(1));
      return;
    case Form::kStack:
      (instruction.op == Op::kPush ? effects.reads : effects.writes) |= PartsOf(operand(0).reg);
      return;
    case Form::kMultiply: {
      effects.reads |= ReadsOf(operand(0));
      const bool divides = instruction.op == Op::kDiv || instruction.op == Op::kIdiv;
      const uint32_t width = operand(0).width;
      const Register low = width == 8 ? Register::kAl : width == 16 ? Register::kAx : Register::kEax;
      const Register high = width == 8 ? Register::kAh : width == 16 ? Register::kDx : Register::kEdx;
      effects.reads |= PartsOf(low) | (divides ? PartsOf(high) : 0);
      effects.writes |= PartsOf(low) | PartsOf(high);
      if (divides) {
        effects.undefines |= kFlags;
      } else {
        effects.writes |= kCf | kOf;
        effects.undefines |= kFlags & ~(kCf | kOf);
      }
      return;
    }
    default:
      break;
  }
  switch (instruction.op) {
    case Op::kAdd:
    case Op::kAdc:
    case Op::kSub:
    case Op::kSbb:
    case Op::kCmp:
    case Op::kNeg:
      effects.writes |= kArithmetic;
      return;
    case Op::kInc:
    case Op::kDec:
      effects.writes |= kArithmetic & ~kCf;
      return;
    case Op::kAsmAnd:
    case Op::kAsmOr:
    case Op::kAsmXor:
    case Op::kTest:
      effects.writes |= kArithmetic & ~kAf;
      effects.undefines |= kAf;
      return;
    case Op::kCbw:
      effects.reads |= PartsOf(Register::kAl);
      effects.writes |= PartsOf(Register::kAx);
      return;
    case Op::kCwd:
      effects.reads |= PartsOf(Register::kAx);
      effects.writes |= PartsOf(Register::kDx);
      return;
    case Op::kCwde:
      effects.reads |= PartsOf(Register::kAx);
      effects.writes |= PartsOf(Register::kEax);
      return;
    case Op::kCdq:
      effects.reads |= PartsOf(Register::kEax);
      effects.writes |= PartsOf(Register::kEdx);
      return;
    case Op::kDaa:
    case Op::kDas:
      effects.reads |= PartsOf(Register::kAl);
      effects.writes |= PartsOf(Register::kAl) | (kFlags & ~kOf);
      effects.undefines |= kOf;
      return;
    case Op::kAam:
    case Op::kAad:
      effects.reads |= instruction.op == Op::kAam ? PartsOf(Register::kAl) : PartsOf(Register::kAx);
      effects.writes |= PartsOf(Register::kAx) | kZf | kSf;
      effects.undefines |= kCf | kOf | kAf;
      return;
    case Op::kClc:
    case Op::kStc:
    case Op::kCmc:
      effects.writes |= kCf;
      return;
    case Op::kLoop:
      effects.reads |= PartsOf(Register::kCx);
      effects.writes |= PartsOf(Register::kCx);
      return;
    case Op::kJcxz:
      effects.reads |= PartsOf(Register::kCx);
      return;
    default:  // moves and jumps leave the flags alone
      return;
  }
}

/// A set DR: all 32 bits.
constexpr Resources kWholeDr = 7u << (kFirstRegisterBit + 3 * 2);

}  // namespace

Resources PartsOf(Register reg) {
  const RegisterInfo& info = Info(reg);
  const uint32_t first = kFirstRegisterBit + 3 * WholeIndex(reg);
  if (info.width == 8) return 1u << (first + (info.shift == 0 ? 0 : 1));
  return (info.width == 16 ? 3u : 7u) << first;
}

Resources PartsOfDr(uint32_t width) {
  return width == 8 ? PartsOf(Register::kCl) : width == 16 ? PartsOf(Register::kCx) : PartsOf(Register::kEcx);
}

const char* NameOf(Resources resources) {
  static constexpr const char* kNames[] = {"RLO", "CF", "ZF", "SF", "OF", "AF"};
  static constexpr const char* kRegisters[kWholeRegisters][4] = {{"AL", "AH", "AX", "EAX"}, {"BL", "BH", "BX", "EBX"},
                                                                 {"DR", "DR", "DR", "DR"},  {"DL", "DH", "DX", "EDX"},
                                                                 {"SI", "SI", "SI", "ESI"}, {"DI", "DI", "DI", "EDI"}};
  for (uint32_t bit = 0; bit < kFirstRegisterBit; ++bit) {
    if ((resources >> bit & 1) != 0) return kNames[bit];
  }
  for (uint32_t reg = 0; reg < kWholeRegisters; ++reg) {
    const uint32_t parts = resources >> (kFirstRegisterBit + 3 * reg) & 7;
    if (parts == 0) continue;
    if ((parts & 4) != 0) return kRegisters[reg][3];
    return kRegisters[reg][parts - 1];
  }
  return "";
}

bool IsWait(Op op) {
  return op == Op::kEx || op == Op::kEx0 || op == Op::kEx1 || op == Op::kTex0 || op == Op::kTex1 || op == Op::kTim;
}

bool IsJump(Op op) { return Info(op).form == Form::kJump; }

bool IsUnconditionalJump(Op op) { return op == Op::kJum || op == Op::kJmp; }

bool IsClearing(const Program& program, const Instruction& instruction) {
  if (instruction.op != Op::kAsmXor && instruction.op != Op::kSub) return false;
  const Operand &first = program.OperandOf(instruction, 0), &second = program.OperandOf(instruction, 1);
  return first.kind == OperandKind::kRegister && second.kind == OperandKind::kRegister && first.reg == second.reg;
}

bool IsPure(const Program& program, const Instruction& instruction) {
  const InstructionInfo& info = Info(instruction.op);
  if (info.purity != Purity::kPure) return false;
  if (!info.assembler) return true;
  const uint32_t written = info.form == Form::kExchange ? 2 : info.first == Access::kRead ? 0 : 1;
  for (uint32_t i = 0; i < written && i < instruction.operands.count; ++i) {
    if (program.OperandOf(instruction, i).kind == OperandKind::kMemory) return false;
  }
  return true;
}

Effects EffectsOf(const Program& program, const Instruction& instruction, uint32_t width) {
  Effects effects;
  if (instruction.faulty || instruction.op == Op::kUnknown) {
    effects.writes = kAllResources;
    return effects;
  }
  if (Info(instruction.op).assembler) {
    AssemblerEffects(program, instruction, effects);
    return effects;
  }
  // CALL and RET hand the flags on (6.4).
  if (instruction.op != Op::kCall && instruction.op != Op::kRet) effects.undefines = kFlags;
  const auto operand = [&](uint32_t index) -> const Operand& { return program.OperandOf(instruction, index); };
  const auto reads_data = [&](uint32_t dr) {
    effects.reads |= ReadsOf(operand(0)) | PartsOfDr(dr);
    effects.writes |= kWholeDr;
  };
  switch (instruction.op) {
    case Op::kLdr:
      effects.writes |= kRlo;
      break;
    case Op::kLa:
    case Op::kLo:
    case Op::kLx:
      effects.reads |= kRlo;
      effects.writes |= kRlo;
      break;
    case Op::kWr:
    case Op::kFl1:
    case Op::kFl0:
    case Op::kJl1:
    case Op::kJl0:
    case Op::kEx0:
    case Op::kEx1:
      effects.reads |= kRlo;
      break;
    case Op::kTex0:
    case Op::kTex1:
      effects.reads |= kRlo | IndexOf(operand(0)) | ReadsOf(operand(1));
      break;
    case Op::kTim:
      effects.reads |= IndexOf(operand(0)) | ReadsOf(operand(1));
      break;
    case Op::kLod:
      effects.reads |= ReadsOf(operand(0));
      effects.writes |= kWholeDr;
      break;
    case Op::kSto:
      effects.reads |= IndexOf(operand(0)) | PartsOfDr(operand(0).width < width ? operand(0).width : width);
      break;
    case Op::kAd:
    case Op::kSu:
    case Op::kAnd:
    case Op::kOr:
    case Op::kXor:
      reads_data(width);
      break;
    case Op::kMulb:
      reads_data(8);
      break;
    case Op::kMulw:
      reads_data(16);
      break;
    case Op::kDivb:
    case Op::kDivw:
      reads_data(instruction.op == Op::kDivb ? 16 : width);
      effects.writes |= PartsOf(Register::kDx);
      break;
    case Op::kRl:
    case Op::kRr:
      reads_data(width);
      break;
    case Op::kBcd:
    case Op::kBin:
      effects.reads |= PartsOfDr(width);
      effects.writes |= kWholeDr;
      break;
    case Op::kEq:
    case Op::kNe:
    case Op::kLt:
    case Op::kLe:
    case Op::kGt:
    case Op::kGe:
      effects.reads |= ReadsOf(operand(0)) | PartsOfDr(width);
      effects.writes |= kRlo;
      break;
    default:  // nothing but its operand in memory
      break;
  }
  return effects;
}

uint32_t WidthBehind(const Program& program, const Instruction& instruction, uint32_t width) {
  if (instruction.faulty || instruction.op == Op::kUnknown) return width;
  const auto operand = [&] { return uint32_t{program.OperandOf(instruction, 0).width}; };
  switch (instruction.op) {
    case Op::kLod:
      return OperationWidth(16, operand());
    case Op::kAd:
    case Op::kSu:
    case Op::kAnd:
    case Op::kOr:
    case Op::kXor:
      return OperationWidth(width, operand());
    case Op::kMulb:
    case Op::kDivb:
      return 16;
    case Op::kMulw:
    case Op::kDivw:
      return 32;
    default:
      break;
  }
  if (!Info(instruction.op).assembler) return width;
  const Resources dr = EffectsOf(program, instruction, width).writes & kWholeDr;
  return dr == 0 ? width : dr == kWholeDr ? 32 : 16;
}

}  // namespace plcxx::technol
