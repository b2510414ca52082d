// Bits that several instructions want to decide.

#include <algorithm>
#include <map>
#include <set>

#include "transpiler/dialects/prostep/warnings.h"

namespace plcxx::prostep {
namespace {

/// One '=' of the bit.
struct Coil {
  ModuleId module;
  uint32_t number = 0;  // in its module
};
using CoilSet = std::set<uint32_t>;  // indices of coils, in the order of the text

/// Which coils of one bit can be executed in one pass.
struct CoilChecker {
  const Program& program;
  const Paths& paths;
  const std::vector<Coil>& coils;
  std::map<uint32_t, CoilSet> below = {};         // by ModuleId: what its execution can reach
  std::map<uint32_t, uint32_t> first_other = {};  // by coil: the first earlier one that meets it

  void Meet(const CoilSet& a, const CoilSet& b) {
    for (const uint32_t x : a) {
      for (const uint32_t y : b) {
        if (x == y) continue;
        const auto [found, is_new] = first_other.try_emplace(std::max(x, y), std::min(x, y));
        if (!is_new) found->second = std::min(found->second, std::min(x, y));
      }
    }
  }

  /// The coils that are reached from the module, and which of them meet in it.
  const CoilSet& Visit(ModuleId id) {
    const auto [found, is_new] = below.try_emplace(id.index);
    if (!is_new) return found->second;
    const ModulePaths& module = paths[id.index];
    std::vector<std::pair<uint32_t, CoilSet>> places;  // number in the module, and what is reached there
    for (uint32_t i = 0; i < coils.size(); ++i) {
      if (coils[i].module == id && module.IsReached(coils[i].number)) places.push_back({coils[i].number, {i}});
    }
    for (const uint32_t i : module.calls()) {
      if (const CoilSet& inside = Visit(module.At(i).module); !inside.empty()) places.push_back({i, inside});
    }
    CoilSet all;
    for (size_t a = 0; a < places.size(); ++a) {
      all.insert(places[a].second.begin(), places[a].second.end());
      for (size_t b = a + 1; b < places.size(); ++b) {
        const uint32_t x = places[a].first, y = places[b].first;
        if (module.Leads(x, y) || module.Leads(y, x)) Meet(places[a].second, places[b].second);
      }
    }
    return below[id.index] = std::move(all);
  }

  void Pass(uint32_t first, uint32_t last) {
    CoilSet before;
    for (uint32_t number = first; number <= last; ++number) {
      if (!program.module_of[number].valid()) continue;
      const CoilSet& here = Visit(program.module_of[number]);
      Meet(before, here);
      before.insert(here.begin(), here.end());
    }
  }
};

uint32_t KeyOf(const Operand& operand) {
  return static_cast<uint32_t>(operand.space()) << 16 | uint32_t{operand.number} << 3 | operand.bit;
}

}  // namespace

void CheckCoils(const Program& program, const Paths& paths, diag::Engine& diagnostics) {
  std::map<uint32_t, std::vector<Coil>> assigned;
  std::map<uint32_t, source::Range> first_set, first_assigned;
  for (uint32_t m = 0; m < paths.size(); ++m) {
    for (uint32_t i = 0; i < paths[m].size(); ++i) {
      const Instruction& instruction = paths[m].At(i);
      const Operand& operand = instruction.operand;
      if (instruction.op == Op::kAssign) {
        first_assigned.try_emplace(KeyOf(operand), instruction.range);
        if (operand.space() == Space::kO || operand.space() == Space::kF) {
          assigned[KeyOf(operand)].push_back({ModuleId(m), i});
        }
      } else if (instruction.op == Op::kSet || instruction.op == Op::kReset) {
        first_set.try_emplace(KeyOf(operand), instruction.range);
      }
    }
  }
  const auto at = [&](const Coil& coil) -> const Instruction& { return paths[coil.module.index].At(coil.number); };
  const auto text_of = [&](uint32_t key) {
    Operand operand{.bit = static_cast<uint8_t>(key & 7), .number = static_cast<uint16_t>(key >> 3 & 0x1FFF)};
    operand.kind = ClassByName(Name(static_cast<Space>(key >> 16)));
    return ToText(operand);
  };
  for (const auto& [key, coils] : assigned) {
    if (coils.size() < 2) continue;
    CoilChecker checker{program, paths, coils};
    for (uint32_t i = 0; i < program.modules.size(); ++i) checker.Visit(ModuleId(i));
    checker.Pass(1, kFirstLoopModule - 1);
    checker.Pass(kFirstLoopModule, kFirstSubroutine - 1);
    for (const auto& [coil, other] : checker.first_other) {
      diagnostics.Report(at(coils[coil]).range, diag::ProstepDoubleCoil, text_of(key))
          .notes.push_back({at(coils[other]).range, "assigned here, too"});
    }
  }
  for (const auto& [key, assignment] : first_assigned) {
    const auto set = first_set.find(key);
    if (set == first_set.end()) continue;
    const bool set_is_later = set->second.begin > assignment.begin;
    diagnostics.Report(set_is_later ? set->second : assignment, diag::ProstepAssignedAndSet, text_of(key))
        .notes.push_back(
            {set_is_later ? assignment : set->second, set_is_later ? "assigned here" : "set or reset here"});
  }
}

}  // namespace plcxx::prostep
