#include "transpiler/dialects/classicladder/syntax/syntax.h"

namespace plcxx::classicladder {

std::vector<uint32_t> ChainOf(const Program& program, const Section& section) {
  std::vector<uint32_t> chain;
  uint32_t at = section.first_rung;
  // A rung that comes again would never reach the last one.
  while (chain.size() <= program.rungs.size()) {
    const auto rung = program.rungs.find(at);
    if (rung == program.rungs.end()) break;
    chain.push_back(at);
    if (at == section.last_rung || rung->second.next < 0) break;
    at = static_cast<uint32_t>(rung->second.next);
  }
  return chain;
}

const Section* SubroutineOf(const Program& program, uint32_t number) {
  for (const auto& [index, section] : program.sections) {
    if (section.subroutine >= 0 && static_cast<uint32_t>(section.subroutine) == number) return &section;
  }
  return nullptr;
}

}  // namespace plcxx::classicladder
