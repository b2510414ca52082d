// Which memory an instruction reads and writes, as far as its text tells (specification 5.1, 6).
//
// In: a tree without errors. Out: one entry for each operand and each field of a functional module. Timers, counters
// and the registers are no memory.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/dialects/prostep/syntax/syntax.h"

namespace plcxx::prostep {

struct MemoryAccess {
  Space space = Space::kNone;
  uint32_t first = 0;  // byte
  uint32_t bytes = 0;
  uint8_t bits = 0xFF;  // of one byte
  Access access = Access::kNone;
  bool indirect = false;  // FM 15-18: somewhere in the whole space
  source::Range range;    // the operand
};

/// In the order in which the operands stand. Nothing for functional modules that a constant disables (6.9).
std::vector<MemoryAccess> AccessesOf(const Program& program, const Instruction& instruction);

/// Can it write byte `byte` of `space`, bits of `bits`? Indirect writes can.
bool MayWrite(const MemoryAccess& access, Space space, uint32_t byte, uint8_t bits);

/// Does a constant in one of its operands make the functional module do nothing but S = 1?
bool IsDisabled(const Program& program, const Instruction& instruction);

}  // namespace plcxx::prostep
