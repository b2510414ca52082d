// What the instructions of a program read and write, operand by operand.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/dialects/host50/syntax/syntax.h"

namespace plcxx::host50 {

struct Access {
  enum class Kind : uint8_t { kRead, kWrite };
  Kind kind{};
  InstructionId instruction;
  Address address;    // of a field its first bit
  uint32_t bits = 1;  // of the field of BTOW or WTOB; else 1
  source::Range range;
};

/// In source order. An operand that is read and written (NEG) is there twice. Timers and counters named by their blocks
/// are not; the signals that axis blocks write are not (lowering/axes.h).
std::vector<Access> AccessesOf(const Program& program);

}  // namespace plcxx::host50
