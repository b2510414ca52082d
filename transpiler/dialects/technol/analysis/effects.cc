#include "transpiler/dialects/technol/analysis/effects.h"

#include <algorithm>

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

/// How TECHNOL's own instructions use their operand and DR.
enum class DrUse : uint8_t {
  kNone,
  kDelay,           // a timer's cell and a time
  kLoadsDr,         // LOD
  kStoresDr,        // STO
  kComputes,        // DR and the operand in their width (6.1)
  kMultipliesByte,  // the low 8 bits of DR
  kMultipliesWord,  // the low 16 bits
  kDividesByte,     // the low 16 bits; the rest is in DX
  kDividesWord,
  kRotates,   // DR by a count
  kConverts,  // DR alone
  kCompares   // DR with the operand; the result is RLO
};

struct EffectRow {
  DrUse use;
  Resources reads, writes, undefines;
};

EffectRow RowOf(Op op) {
  // As the rows name them.
  const Resources kAl = PartsOf(Register::kAl), kAx = PartsOf(Register::kAx), kEax = PartsOf(Register::kEax);
  const Resources kCx = PartsOf(Register::kCx), kDx = PartsOf(Register::kDx), kEdx = PartsOf(Register::kEdx);
  switch (op) {
#define TECHNOL_INSTRUCTION(Key, Text, FormKey, AccessKey, EvidenceKey, PurityKey, Use, Reads, Writes, Undefines) \
  case Op::k##Key:                                                                                                \
    return {DrUse::k##Use, Reads, Writes, Undefines};
#include "transpiler/dialects/technol/machine/machine.def"
    case Op::kMechanismBegin:
    case Op::kMechanismEnd:
    case Op::kModuleEnd:
    case Op::kAreaEnd:
      return {DrUse::kNone, 0, 0, kFlags};
    case Op::kUnknown:
      return {DrUse::kNone, 0, kAllResources, 0};
  }
  PLCXX_UNREACHABLE();
}

/// The flags after a shift or rotation.
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
  const auto operand = [&](uint32_t index) -> const Operand& { return program.OperandOf(instruction, index); };
  const auto take_first = [&] {
    const Operand& first = operand(0);
    effects.reads |= IndexOf(first);
    if (first.kind != OperandKind::kRegister) return;
    if (info.first != Access::kWrite) effects.reads |= PartsOf(first.reg);
    if (info.first != Access::kRead) effects.writes |= PartsOf(first.reg);
  };
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
      return;
    }
    case Form::kNone:
    case Form::kBit:
    case Form::kWriteBit:
    case Form::kFlag:
    case Form::kJump:
    case Form::kCall:
    case Form::kWaitLimit:
    case Form::kDelay:
    case Form::kMechanism:
    case Form::kData:
    case Form::kNarrowData:
    case Form::kWideData:
    case Form::kStore:
    case Form::kRotation:
    case Form::kError:
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

bool ReadsRlo(Op op) { return (RowOf(op).reads & kRlo) != 0; }

bool ReadsDr(Op op) {
  const DrUse use = RowOf(op).use;
  return use != DrUse::kNone && use != DrUse::kDelay && use != DrUse::kLoadsDr;
}

bool ComparesDr(Op op) { return RowOf(op).use == DrUse::kCompares; }

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
  const EffectRow row = RowOf(instruction.faulty ? Op::kUnknown : instruction.op);
  Effects effects{.reads = row.reads, .writes = row.writes, .undefines = row.undefines, .may_keep = 0};
  if (instruction.faulty || instruction.op == Op::kUnknown) return effects;
  if (Info(instruction.op).assembler) {
    AssemblerEffects(program, instruction, effects);
    return effects;
  }
  const auto operand = [&](uint32_t index) -> const Operand& { return program.OperandOf(instruction, index); };
  switch (row.use) {
    case DrUse::kNone:
      break;
    case DrUse::kDelay:
      effects.reads |= IndexOf(operand(0)) | ReadsOf(operand(1));
      break;
    case DrUse::kLoadsDr:
      effects.reads |= ReadsOf(operand(0));
      effects.writes |= kWholeDr;
      break;
    case DrUse::kStoresDr:
      effects.reads |= IndexOf(operand(0)) | PartsOfDr(std::min(uint32_t{operand(0).width}, width));
      break;
    case DrUse::kComputes:
    case DrUse::kRotates:
      effects.reads |= ReadsOf(operand(0)) | PartsOfDr(width);
      effects.writes |= kWholeDr;
      break;
    case DrUse::kMultipliesByte:
      effects.reads |= ReadsOf(operand(0)) | PartsOfDr(8);
      effects.writes |= kWholeDr;
      break;
    case DrUse::kMultipliesWord:
      effects.reads |= ReadsOf(operand(0)) | PartsOfDr(16);
      effects.writes |= kWholeDr;
      break;
    case DrUse::kDividesByte:
    case DrUse::kDividesWord:
      effects.reads |= ReadsOf(operand(0)) | PartsOfDr(row.use == DrUse::kDividesByte ? 16 : width);
      effects.writes |= kWholeDr | PartsOf(Register::kDx);
      break;
    case DrUse::kConverts:
      effects.reads |= PartsOfDr(width);
      effects.writes |= kWholeDr;
      break;
    case DrUse::kCompares:
      effects.reads |= ReadsOf(operand(0)) | PartsOfDr(width);
      break;
  }
  return effects;
}

uint32_t WidthBehind(const Program& program, const Instruction& instruction, uint32_t width) {
  if (instruction.op == Op::kUnknown) return width;
  const auto operand = [&] { return uint32_t{program.OperandOf(instruction, 0).width}; };
  switch (RowOf(instruction.op).use) {
    case DrUse::kLoadsDr:
      return OperationWidth(16, operand());
    case DrUse::kComputes:
      return OperationWidth(width, operand());
    case DrUse::kMultipliesByte:
    case DrUse::kDividesByte:
      return 16;
    case DrUse::kMultipliesWord:
    case DrUse::kDividesWord:
      return 32;
    case DrUse::kNone:
    case DrUse::kDelay:
    case DrUse::kStoresDr:
    case DrUse::kRotates:
    case DrUse::kConverts:
    case DrUse::kCompares:
      break;
  }
  if (!Info(instruction.op).assembler) return width;
  const Resources dr = EffectsOf(program, instruction, width).writes & kWholeDr;
  return dr == 0 ? width : dr == kWholeDr ? 32 : 16;
}

}  // namespace plcxx::technol
