#include "transpiler/dialects/host50/analysis/resources.h"

#include <algorithm>
#include <set>
#include <utility>

#include "transpiler/dialects/host50/analysis/accesses.h"

namespace plcxx::host50 {
namespace {

class Counter {
 public:
  Counter() {
#define HOST50_RESOURCE(Name, ...) uses_.push_back({.resource = Resource::k##Name});
#include "transpiler/dialects/host50/machine/machine.def"
  }

  void Add(Resource resource, source::Range range) {
    if (resource == Resource::kNone) return;
    ResourceUse& use = uses_[static_cast<size_t>(resource)];
    if (++use.used == Available(resource) + 1) use.surplus = range;
  }

  /// The first use of an address.
  void AddAddress(const Address& address, source::Range range) {
    if (addresses_.emplace(address.area, address.number).second) Add(Info(address.area).resource, range);
  }

  std::vector<ResourceUse> Take() { return std::move(uses_); }

 private:
  std::vector<ResourceUse> uses_;
  std::set<std::pair<Area, uint16_t>> addresses_;
};

/// What blocks name as theirs, too: timers and counters.
std::vector<Access> UsesOf(const Program& program) {
  std::vector<Access> uses = AccessesOf(program);
  for (uint32_t i = 0; i < program.instructions.size(); ++i) {
    const Instruction& instruction = program.instructions[InstructionId(i)];
    if (instruction.operands.count == 0) continue;
    const Operand& operand = program.operands[instruction.operands.first];
    const bool instance = operand.role == OperandRole::kTimer || operand.role == OperandRole::kCounter;
    if (!instance || operand.kind != OperandKind::kAddress) continue;
    uses.push_back({.instruction = InstructionId(i), .address = operand.address, .range = operand.range});
  }
  std::ranges::stable_sort(uses, {}, [](const Access& access) { return access.range.begin; });
  return uses;
}

}  // namespace

std::vector<ResourceUse> ResourcesOf(const Program& program) {
  Counter counter;
  for (const Section& section : program.sections) {
    if (section.kind != SectionKind::kNone) counter.Add(Resource::kPrograms, section.range);
  }
  for (const Network& network : program.networks) counter.Add(Resource::kNetworks, network.range);
  for (const Symbol& symbol : program.symbols) {
    if (!symbol.predefined) counter.Add(Resource::kSymbols, symbol.range);
  }
  for (const Access& use : UsesOf(program)) {
    for (uint32_t bit = 0; bit < use.bits; ++bit) {
      Address address = use.address;
      address.number = static_cast<uint16_t>(address.number + bit);
      counter.AddAddress(address, use.range);
    }
  }
  std::vector<const Instruction*> instructions;
  for (const Instruction& instruction : program.instructions) {
    if (!instruction.unknown) instructions.push_back(&instruction);
  }
  std::ranges::stable_sort(instructions, {}, [](const Instruction* i) { return i->range.begin; });
  for (const Instruction* instruction : instructions) counter.Add(Info(instruction->op).resource, instruction->range);
  return counter.Take();
}

}  // namespace plcxx::host50
