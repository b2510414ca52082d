#include "transpiler/dialects/@name@/machine/machine.h"

namespace plcxx::@name@ {
namespace {

// By Instruction.
constexpr std::string_view kNames[] = {
    "unsupported",
#define PLCXX_@NAME@_INSTRUCTION(Kind, Word) Word,
#include "transpiler/dialects/@name@/machine/machine.def"
#undef PLCXX_@NAME@_INSTRUCTION
};

}  // namespace

Instruction InstructionByWord(std::string_view word) {
  uint8_t index = 0;
  for (const std::string_view name : kNames) {
    if (index > 0 && name == word) return static_cast<Instruction>(index);
    ++index;
  }
  return Instruction::kUnsupported;
}

std::string_view Name(Instruction instruction) { return kNames[static_cast<uint8_t>(instruction)]; }

}  // namespace plcxx::@name@
