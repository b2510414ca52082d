#include "transpiler/dialects/host50/syntax/syntax.h"

#include <algorithm>

namespace plcxx::host50 {

SectionId FindSection(const Program& program, SectionKind kind) {
  for (uint32_t i = 0; i < program.sections.size(); ++i) {
    if (program.sections[SectionId(i)].kind == kind) return SectionId(i);
  }
  return {};
}

uint32_t WeightOf(const Program& program, NetworkId network) {
  const Span& span = program.networks[network].instructions;
  uint32_t weight = 0;
  for (uint32_t i = 0; i < span.count; ++i) {
    const RungEffect effect = Info(program.instructions[InstructionId(span.first + i)].op).effect;
    if (effect != RungEffect::kNothing && effect != RungEffect::kClose) ++weight;
  }
  return std::max(weight, 1u);
}

std::string ToText(const Address& address) {
  std::string text = "%" + std::string(Info(address.area).name) + std::to_string(address.number);
  switch (address.attribute) {
    case Attribute::kNone:
      return text;
    case Attribute::kQ:
      return text + ".Q";
    case Attribute::kV:
      return text + ".V";
    case Attribute::kP:
      return text + ".P";
  }
  PLCXX_UNREACHABLE();
}

std::string SubroutineName(uint32_t number) { return "SR" + std::to_string(number); }

}  // namespace plcxx::host50
