// What an instruction does to RLO, flags and registers (specification 5.6, 6.2 to 6.9): for the analyses of paths and
// for the lowering.
#pragma once

#include <cstdint>

#include "transpiler/dialects/technol/syntax/syntax.h"

namespace plcxx::technol {

/// A set of resources: RLO, the five flags, and of each register its low byte, the byte above and the upper half.
using Resources = uint32_t;
constexpr Resources kRlo = 1u << 0, kCf = 1u << 1, kZf = 1u << 2, kSf = 1u << 3, kOf = 1u << 4, kAf = 1u << 5;
constexpr Resources kFlags = kCf | kZf | kSf | kOf | kAf;
constexpr Resources kAllResources = (1u << 24) - 1;
constexpr uint32_t kFlagCount = 5, kWholeRegisters = 6;

/// 0 for EAX and its parts to 5 for EDI.
inline uint32_t WholeIndex(Register reg) {
  return static_cast<uint32_t>(Info(reg).whole) - static_cast<uint32_t>(Register::kEax);
}
/// The bytes of a register.
Resources PartsOf(Register reg);
/// The low `width` bits of DR.
Resources PartsOfDr(uint32_t width);
/// "RLO", "DR", "AX", "flag CF": the first of the set, as messages name it.
const char* NameOf(Resources resources);

struct Effects {
  Resources reads = 0;
  Resources writes = 0;     // on every path
  Resources undefines = 0;  // flags that hold nothing usable afterwards
  Resources may_keep = 0;   // flags that a count of 0 in CL keeps: written, but not in any case
};

/// `width`: of DR before the instruction, 16 or 32. A faulty instruction reads nothing and writes everything.
Effects EffectsOf(const Program& program, const Instruction& instruction, uint32_t width);
/// The width of DR after the instruction, which has no fault (6.1).
uint32_t WidthBehind(const Program& program, const Instruction& instruction, uint32_t width);
/// W(x) of 6.1: the width in which an operand of this width meets DR.
constexpr uint32_t OperationWidth(uint32_t width, uint32_t operand) { return width > 16 || operand > 16 ? 32 : 16; }

/// Does it store into memory, or do anything else that a wait must not repeat (6.7)?
bool IsPure(const Program& program, const Instruction& instruction);
/// Of TECHNOL's own instructions: goes on with the RLO, or with DR, that the one before has left.
bool ReadsRlo(Op op);
bool ReadsDr(Op op);
/// EQ to GE: sets the RLO from DR.
bool ComparesDr(Op op);
/// EX, EX0, EX1, TEX0, TEX1, TIM.
bool IsWait(Op op);
/// Goes to its label, or may: JUM to JCXZ; TEX0 and TEX1 are waits.
bool IsJump(Op op);
/// JUM, JMP.
bool IsUnconditionalJump(Op op);
/// XOR r,r and SUB r,r load r with 0.
bool IsClearing(const Program& program, const Instruction& instruction);

}  // namespace plcxx::technol
