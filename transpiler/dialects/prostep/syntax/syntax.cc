#include "transpiler/dialects/prostep/syntax/syntax.h"

namespace plcxx::prostep {

std::string ToText(const Operand& operand) {
  if (!operand.exists()) return "?";
  std::string text = std::string(Name(operand.kind)) + " ";
  if (operand.shape() == Shape::kConstant) return text + std::to_string(operand.value);
  text += std::to_string(operand.number);
  if (operand.shape() == Shape::kBit) text += "." + std::to_string(operand.bit);
  return text;
}

std::array<uint8_t, kFirstKeptByte> InitialData(const Program& program) {
  std::array<uint8_t, kFirstKeptByte> bytes{};
  for (const DataDeclaration& declared : program.data) {
    for (uint32_t i = 0; i < declared.bytes; ++i) {
      bytes[declared.address + i] = static_cast<uint8_t>(declared.value >> (8 * i));
    }
  }
  return bytes;
}

}  // namespace plcxx::prostep
