#include "transpiler/passes/enter_switches.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "transpiler/ir/builder.h"

namespace plcxx::passes {
namespace {

using ir::Inst;
using ir::InstId;
using ir::OpKind;
using ir::RegionId;

/// A switch at the beginning of nested blocks, each of which begins with the next one.
struct Entry {
  InstId choice;
  std::vector<InstId> blocks;  // the innermost one first
};

struct Enterer {
  ir::Program& program;
  std::vector<uint32_t> exits;  // by InstId of a block: how many Exits name it

  std::optional<Entry> EntryAt(InstId id) const;
  /// The block that the case leaves, and nothing else; or none.
  InstId Leaves(const ir::SwitchCase& choice) const;
  size_t CountOnlyLeftHere(const Entry& entry) const;
  std::vector<InstId> TakeRest(RegionId region, size_t from);
  void Rebuild(RegionId region, size_t at, const Entry& entry, size_t count);
  void Visit(RegionId region);
};

std::optional<Entry> Enterer::EntryAt(InstId id) const {
  Entry entry;
  while (program[id].op == OpKind::kBlock) {
    entry.blocks.push_back(id);
    const std::vector<InstId>& insts = program.regions[RegionId(program[id].a)].insts;
    if (insts.empty()) return std::nullopt;
    id = insts.front();
  }
  if (program[id].op != OpKind::kSwitch) return std::nullopt;
  std::ranges::reverse(entry.blocks);
  entry.choice = id;
  return entry;
}

InstId Enterer::Leaves(const ir::SwitchCase& choice) const {
  const std::vector<InstId>& insts = program.regions[choice.region].insts;
  if (insts.size() != 1 || choice.falls_through) return {};
  const Inst& inst = program[insts.front()];
  return inst.op == OpKind::kExit && !ir::ValueId(inst.a).valid() ? InstId(inst.payload) : InstId();
}

/// How many of the innermost blocks nothing but the switch leaves; 0 when a case does something else.
size_t Enterer::CountOnlyLeftHere(const Entry& entry) const {
  std::vector<uint32_t> left(entry.blocks.size());
  for (const ir::SwitchCase& choice : program.switches[ir::SwitchId(program[entry.choice].payload)].cases) {
    if (choice.values.empty()) {
      if (!program.regions[choice.region].insts.empty()) return 0;
      continue;
    }
    const InstId block = Leaves(choice);
    if (!block.valid()) return 0;
    const auto found = std::ranges::find(entry.blocks, block);
    if (found != entry.blocks.end()) ++left[static_cast<size_t>(found - entry.blocks.begin())];
  }
  size_t count = 0;
  while (count < left.size() && left[count] > 0 && left[count] == exits[entry.blocks[count].index]) ++count;
  return count;
}

std::vector<InstId> Enterer::TakeRest(RegionId region, size_t from) {
  std::vector<InstId>& insts = program.regions[region].insts;
  std::vector<InstId> rest(insts.begin() + static_cast<ptrdiff_t>(from), insts.end());
  insts.resize(from);
  return rest;
}

/// The `count` innermost blocks become cases; the outermost of them, or the switch, stands at `at` of the region.
void Enterer::Rebuild(RegionId region, size_t at, const Entry& entry, size_t count) {
  std::vector<ir::SwitchCase> cases;
  for (size_t i = 0; i <= count; ++i) {
    std::vector<InstId> rest = i < count ? TakeRest(RegionId(program[entry.blocks[i]].a), 1) : TakeRest(region, at + 1);
    const RegionId body = program.regions.Add({.insts = std::move(rest)});
    cases.push_back({.values = {}, .region = body, .falls_through = i < count});
  }
  ir::Switch& choice = program.switches[ir::SwitchId(program[entry.choice].payload)];
  std::vector<ir::SwitchCase> others;
  for (ir::SwitchCase& old : choice.cases) {
    if (old.values.empty()) continue;  // does nothing: what stands behind the switch is the new default
    const auto found = std::ranges::find(entry.blocks, Leaves(old));
    const auto index = static_cast<size_t>(found - entry.blocks.begin());
    if (index >= count) {
      others.push_back(std::move(old));
      continue;
    }
    std::vector<uint64_t>& values = cases[index + 1].values;
    values.insert(values.end(), old.values.begin(), old.values.end());
    ir::Forget(program[program.regions[old.region].insts.front()]);
    program.regions[old.region].insts.clear();
  }
  std::ranges::move(others, std::back_inserter(cases));
  choice.cases = std::move(cases);
  for (size_t i = 0; i < count; ++i) ir::Forget(program[entry.blocks[i]]);
  program.regions[region].insts[at] = entry.choice;
}

void Enterer::Visit(RegionId region) {
  for (size_t at = 0; at < program.regions[region].insts.size(); ++at) {
    const InstId id = program.regions[region].insts[at];
    if (program[id].op == OpKind::kStatement) return;
    const std::optional<Entry> entry = EntryAt(id);
    if (!entry) continue;
    const size_t count = CountOnlyLeftHere(*entry);
    if (count == 0) return;
    const bool whole = count == entry->blocks.size();
    Rebuild(whole ? region : RegionId(program[entry->blocks[count]].a), whole ? at : 0, *entry, count);
    return;
  }
}

}  // namespace

void EnterSwitches(ir::Program& program) {
  Enterer enterer{.program = program, .exits = std::vector<uint32_t>(program.insts.size())};
  for (const Inst& inst : program.insts) {
    if (inst.op == OpKind::kExit) ++enterer.exits[inst.payload];
  }
  for (const ir::Routine& routine : program.routines) {
    if (routine.body.valid()) enterer.Visit(routine.body);
  }
}

}  // namespace plcxx::passes
