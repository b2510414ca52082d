// What the control has: its instructions (machine.def), later its memory and signals. Data, no code.
#pragma once

#include <cstdint>
#include <string_view>

namespace plcxx::@name@ {

enum class Instruction : uint8_t {
  kUnsupported,  // a word without a row
#define PLCXX_@NAME@_INSTRUCTION(Kind, Word) k##Kind,
#include "transpiler/dialects/@name@/machine/machine.def"
#undef PLCXX_@NAME@_INSTRUCTION
};

/// kUnsupported where machine.def has no row for the word.
Instruction InstructionByWord(std::string_view word);
/// As the source writes it; "unsupported".
std::string_view Name(Instruction instruction);

}  // namespace plcxx::@name@
