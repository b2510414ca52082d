#include "transpiler/prove/diff/match.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "transpiler/ir/accesses.h"
#include "transpiler/ir/op.h"
#include "transpiler/prove/diff/one_sided.h"
#include "transpiler/prove/machine/requests.h"
#include "transpiler/prove/machine/sets.h"
#include "transpiler/prove/machine/transition.h"
#include "transpiler/symbolic/execute/summary.h"
#include "transpiler/symbolic/meaning/meaning.h"

namespace plcxx::prove::diff {
namespace {

constexpr bool IsInteger(ir::Type type) { return ir::Type::kI8 <= type && type <= ir::Type::kI64; }

/// The variables of a version, by the cells that they are in.
class VariableNames {
 public:
  explicit VariableNames(const machine::Version& version) : by_cell_(version.cells.count) {
    const ir::Program& program = *version.program;
    const auto add = [&](const std::string& name, const ir::Place& place) {
      if (name.empty() || place.is_field() || !execute::IsInside(program, place)) return;
      all_.insert(name);
      for (const execute::CellId cell : execute::CellsOf(program, version.cells, place)) {
        std::vector<std::string>& names = by_cell_[cell.index];
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
      }
    };
    for (const ir::Place& place : program.places) add(place.name, place);
    for (const ir::Symbol& symbol : program.symbols) {
      if (!symbol.indices.empty()) continue;
      add(symbol.name, {.type = symbol.type, .space = symbol.space, .offset = symbol.offset, .bit = symbol.bit});
    }
  }

  bool Has(const std::string& name) const { return all_.contains(name); }
  const std::vector<std::string>& Of(execute::CellId cell) const { return by_cell_[cell.index]; }

 private:
  std::set<std::string> all_;
  std::vector<std::vector<std::string>> by_cell_;
};

class Matcher {
 public:
  Matcher(const machine::Version& old_version, const machine::Version& new_version)
      : old_(old_version),
        new_(new_version),
        match_{.new_of_old = std::vector<execute::CellId>(old_version.cells.count),
               .old_of_new = std::vector<execute::CellId>(new_version.cells.count),
               .starts_otherwise = {}} {}

  void Places(const ir::Place& one, const ir::Place& other);
  void InputsAndOutputs();
  void InternalByName();
  void SymbolsByName();
  void ByAddress();
  void RetentiveByAddress();
  void Instances();
  void HostFunctions();
  Match Take() { return std::move(match_); }

 private:
  bool IsFree(execute::CellId one, execute::CellId other) const {
    return !match_.new_of_old[one.index].valid() && !match_.old_of_new[other.index].valid();
  }
  void Pair(execute::CellId one, execute::CellId other) {
    if (!IsFree(one, other)) return;
    match_.new_of_old[one.index] = other;
    match_.old_of_new[other.index] = one;
  }
  void Instance(ir::StateId one, ir::StateId other);
  template <class Accept>
  void Spaces(Accept&& accept);

  const machine::Version& old_;
  const machine::Version& new_;
  Match match_;
};

void Matcher::Places(const ir::Place& one, const ir::Place& other) {
  if (one.is_field() != other.is_field()) return;
  if (one.is_field()) {
    // A timer or counter moves as a whole.
    if (old_.program->states[one.state].kind == new_.program->states[other.state].kind)
      Instance(one.state, other.state);
    return;
  }
  // Of integers of two widths those digits are the same that both have; a number and a floating-point one share none.
  const bool alike = one.type == other.type || (IsInteger(one.type) && IsInteger(other.type));
  if (!alike || !execute::IsInside(*old_.program, one) || !execute::IsInside(*new_.program, other)) return;
  const std::vector<execute::CellId> from = execute::CellsOf(*old_.program, old_.cells, one);
  const std::vector<execute::CellId> to = execute::CellsOf(*new_.program, new_.cells, other);
  for (size_t i = 0; i < std::min(from.size(), to.size()); ++i) {
    if (!IsFree(from[i], to[i])) return;
  }
  for (size_t i = 0; i < std::min(from.size(), to.size()); ++i) Pair(from[i], to[i]);
}

const std::string& MemoryOf(const ir::Space& space) { return space.part_of.empty() ? space.name : space.part_of; }

/// Bits of two spaces of one memory that are the same to the control.
struct SameBits {
  uint32_t old_begin = 0, new_begin = 0, count = 0;
};

std::vector<SameBits> SameBitsOf(const ir::Space& one, const ir::Space& other) {
  if (!one.zones_are_arrays || !other.zones_are_arrays) {
    const uint32_t begin = std::max(one.part_begin, other.part_begin);
    const uint32_t end = std::min(one.part_begin + one.bytes, other.part_begin + other.bytes);
    if (begin >= end) return {};
    return {{8 * (begin - one.part_begin), 8 * (begin - other.part_begin), 8 * (end - begin)}};
  }
  std::vector<SameBits> same;
  const auto add = [&](size_t i, size_t j) {
    const ir::Zone &from = one.zones[i], &to = other.zones[j];
    same.push_back({from.begin, to.begin, std::min(from.end - from.begin, to.end - to.begin)});
  };
  // Every such space has inputs, and outputs behind them; memory may be missing in front, and an array behind.
  const auto inputs_of = [](const ir::Space& space) {
    return static_cast<size_t>(std::ranges::find(space.zones, ir::Direction::kInput, &ir::Zone::direction) -
                               space.zones.begin());
  };
  const size_t i = inputs_of(one), j = inputs_of(other), behind = 2;
  if (i + behind > one.zones.size() || j + behind > other.zones.size()) return same;
  for (size_t before = 1; before <= std::min(i, j); ++before) add(i - before, j - before);
  for (size_t k = 0; k < behind; ++k) add(i + k, j + k);
  const size_t rest = std::min(one.zones.size() - i, other.zones.size() - j) - behind;
  for (size_t back = 1; back <= rest; ++back) add(one.zones.size() - back, other.zones.size() - back);
  return same;
}

template <class Accept>
void Matcher::Spaces(Accept&& accept) {
  for (uint32_t i = 0; i < old_.program->spaces.size(); ++i) {
    const ir::Space& space = old_.program->spaces[ir::SpaceId(i)];
    if (space.lifetime == ir::Lifetime::kRoutine) continue;
    for (uint32_t j = 0; j < new_.program->spaces.size(); ++j) {
      const ir::Space& other = new_.program->spaces[ir::SpaceId(j)];
      if (MemoryOf(other) != MemoryOf(space) || other.lifetime == ir::Lifetime::kRoutine) continue;
      for (const SameBits& bits : SameBitsOf(space, other)) {
        for (uint32_t bit = 0; bit < bits.count; ++bit) {
          const execute::CellId one(old_.cells.spaces[i] + bits.old_begin + bit),
              same(new_.cells.spaces[j] + bits.new_begin + bit);
          if (accept(one, same)) Pair(one, same);
        }
      }
    }
  }
}

void Matcher::InputsAndOutputs() {
  Spaces([this](execute::CellId one, execute::CellId other) {
    return machine::DirectionOf(old_, one) != ir::Direction::kInternal ||
           machine::DirectionOf(new_, other) != ir::Direction::kInternal;
  });
}

/// What has a name that the other version knows as well is there, whatever stands at its old address now.
void Matcher::ByAddress() {
  const VariableNames old_names(old_), new_names(new_);
  Spaces([&](execute::CellId one, execute::CellId other) {
    const auto all_are_common = [](const VariableNames& from, execute::CellId cell, const VariableNames& to,
                                   execute::CellId same) {
      return std::ranges::all_of(from.Of(cell), [&](const std::string& name) {
        return !to.Has(name) || std::ranges::find(to.Of(same), name) != to.Of(same).end();
      });
    };
    return all_are_common(old_names, one, new_names, other) && all_are_common(new_names, other, old_names, one);
  });
}

/// The control keeps an address: what had a name there that stands elsewhere now is kept as before, or no more.
void Matcher::RetentiveByAddress() {
  Spaces([this](execute::CellId one, execute::CellId other) {
    return machine::IsRetentive(old_, one) && machine::IsRetentive(new_, other);
  });
}

void Matcher::InternalByName() {
  std::map<std::string, const ir::Place*> by_name;
  const auto is_candidate = [](const machine::Version& version, const ir::Place& place) {
    return !place.is_field() && !place.name.empty() && execute::IsInside(*version.program, place) &&
           version.program->spaces[place.space].lifetime != ir::Lifetime::kRoutine;
  };
  for (const ir::Place& place : new_.program->places) {
    if (is_candidate(new_, place)) by_name.emplace(place.name, &place);
  }
  for (const ir::Place& place : old_.program->places) {
    if (!is_candidate(old_, place)) continue;
    const auto found = by_name.find(place.name);
    if (found == by_name.end()) continue;
    // Also in another space: an option moves a word into the memory that is kept.
    Places(place, *found->second);
  }
}

/// Arrays and structures, of which the program touches elements that it computes.
void Matcher::SymbolsByName() {
  std::map<std::string, const ir::Symbol*> by_name;
  for (const ir::Symbol& symbol : new_.program->symbols) by_name.emplace(symbol.name, &symbol);
  for (const ir::Symbol& symbol : old_.program->symbols) {
    const auto found = by_name.find(symbol.name);
    if (found == by_name.end()) continue;
    const ir::Symbol& other = *found->second;
    const bool alike = symbol.indices.size() == other.indices.size() &&
                       old_.program->spaces[symbol.space].name == new_.program->spaces[other.space].name &&
                       old_.program->spaces[symbol.space].lifetime != ir::Lifetime::kRoutine;
    if (!alike) continue;
    const auto pair_elements = [&](const auto& self, size_t index, uint32_t from, uint32_t to) -> void {
      if (index == symbol.indices.size()) {
        Places({.type = symbol.type, .space = symbol.space, .offset = from, .bit = symbol.bit},
               {.type = other.type, .space = other.space, .offset = to, .bit = other.bit});
        return;
      }
      const ir::Symbol::Index &one = symbol.indices[index], &same = other.indices[index];
      for (uint32_t i = 0; i < std::min(one.count, same.count); ++i) {
        self(self, index + 1, from + i * one.stride, to + i * same.stride);
      }
    };
    pair_elements(pair_elements, 0, symbol.offset, other.offset);
  }
}

void Matcher::Instance(ir::StateId one, ir::StateId other) {
  const uint32_t from = old_.cells.states[one.index], to = new_.cells.states[other.index];
  for (uint32_t i = 0; i < meaning::FieldTerms(old_.program->states[one].kind); ++i)
    Pair(execute::CellId(from + i), execute::CellId(to + i));
}

void Matcher::Instances() {
  std::map<std::pair<ir::StateKind, std::string>, ir::StateId> by_name;
  for (uint32_t i = 0; i < new_.program->states.size(); ++i) {
    const ir::StateInstance& state = new_.program->states[ir::StateId(i)];
    by_name.emplace(std::pair(state.kind, state.name), ir::StateId(i));
  }
  std::map<ir::StateKind, std::vector<ir::StateId>> rest;
  for (uint32_t i = 0; i < old_.program->states.size(); ++i) {
    const ir::StateInstance& state = old_.program->states[ir::StateId(i)];
    if (match_.new_of_old[old_.cells.states[i]].valid()) continue;  // by --map
    const auto found = by_name.find(std::pair(state.kind, state.name));
    if (found == by_name.end() || match_.old_of_new[new_.cells.states[found->second.index]].valid()) {
      rest[state.kind].emplace_back(i);
    } else {
      Instance(ir::StateId(i), found->second);
    }
  }
  std::map<ir::StateKind, size_t> next;
  for (uint32_t i = 0; i < new_.program->states.size(); ++i) {
    const ir::StateKind kind = new_.program->states[ir::StateId(i)].kind;
    if (match_.old_of_new[new_.cells.states[i]].valid()) continue;
    if (next[kind] < rest[kind].size()) Instance(rest[kind][next[kind]++], ir::StateId(i));
  }
}

void Matcher::HostFunctions() {
  for (uint32_t i = 0; i < old_.program->host_functions.size(); ++i) {
    for (uint32_t j = 0; j < new_.program->host_functions.size(); ++j) {
      if (old_.program->host_functions[ir::HostFunctionId(i)].name ==
          new_.program->host_functions[ir::HostFunctionId(j)].name) {
        Pair(execute::CellId(old_.cells.calls + i), execute::CellId(new_.cells.calls + j));
      }
    }
  }
  Pair(old_.cells.OfOrder(), new_.cells.OfOrder());
  Pair(old_.cells.OfActions(), new_.cells.OfActions());
}

std::vector<bool> CellsThatStartOtherwise(const machine::Version& old_version, const machine::Version& new_version,
                                          const Match& match) {
  const ir::Program& program = *old_version.program;
  std::vector<bool> starts_otherwise(old_version.cells.count);
  for (const ir::Place& place : program.places) {
    if (place.is_field() || place.indexed || place.type == ir::Type::kBit || !execute::IsInside(program, place))
      continue;
    const std::vector<execute::CellId> cells = execute::CellsOf(program, old_version.cells, place);
    const bool differs = std::ranges::any_of(cells, [&](execute::CellId old_cell) {
      const execute::CellId new_cell = match.new_of_old[old_cell.index];
      return new_cell.valid() &&
             machine::PowerOnValue(old_version, old_cell) != machine::PowerOnValue(new_version, new_cell);
    });
    for (const execute::CellId cell : cells)
      if (differs) starts_otherwise[cell.index] = true;
  }
  return starts_otherwise;
}

}  // namespace

Match MatchCells(const machine::Version& old_version, const machine::Version& new_version,
                 const std::vector<std::pair<ir::Place, ir::Place>>& same) {
  Matcher matcher(old_version, new_version);
  for (const auto& [one, other] : same) matcher.Places(one, other);  // before everything that plcxx guesses
  matcher.InputsAndOutputs();
  matcher.InternalByName();
  matcher.SymbolsByName();
  matcher.ByAddress();
  matcher.RetentiveByAddress();
  matcher.Instances();
  matcher.HostFunctions();
  Match match = matcher.Take();
  match.starts_otherwise = CellsThatStartOtherwise(old_version, new_version, match);
  return match;
}

bool IsInputPair(const machine::Version& old_version, const machine::Version& new_version,
                 const machine::Uses& old_uses, const machine::Uses& new_uses, const Match& match,
                 execute::CellId old_cell) {
  const execute::Cell cell = execute::CellAt(*old_version.program, old_version.cells, old_cell);
  if (cell.kind != execute::CellKind::kBit) return false;
  if (machine::WhatControlWrites(old_version, old_cell) == execute::ControlWrite::kValues) return true;
  const execute::CellId new_cell = match.new_of_old[old_cell.index];
  if (new_cell.valid() && machine::WhatControlWrites(new_version, new_cell) == execute::ControlWrite::kValues)
    return true;
  const bool old_sets = old_uses.sets[old_cell.index];
  const bool new_sets = new_cell.valid() ? new_uses.sets[new_cell.index] : old_sets;
  // What either version calls constant keeps there the value that it has at power-on.
  const bool may_be_set = machine::MayBeSetByHost(old_version, old_cell) &&
                          (!new_cell.valid() || machine::MayBeSetByHost(new_version, new_cell));
  if (!may_be_set || (old_sets && new_sets)) return false;
  // What one version alone uses, and writes, is how it does something: no host of the other one knows of it.
  const bool old_uses_it = old_uses.writes[old_cell.index] || old_uses.reads[old_cell.index];
  const bool new_uses_it = new_cell.valid() ? new_uses.writes[new_cell.index] || new_uses.reads[new_cell.index]
                                            : old_uses.writes[old_cell.index];
  return !((old_sets || new_sets) && old_uses_it != new_uses_it && IsPrivate(old_version, old_cell));
}

namespace {

/// The short loops that can be unknown functions, by what they do.
std::map<std::string, std::set<ir::InstId>> ShortLoopsOf(const machine::Version& version) {
  const ir::Program& program = *version.program;
  std::map<std::string, std::set<ir::InstId>> loops;
  for (uint32_t r = 0; r < program.regions.size(); ++r) {
    for (const ir::InstId id : program.regions[ir::RegionId(r)].insts) {
      if (program[id].op != ir::OpKind::kLoop) continue;
      const ir::Loop& loop = program.loops[ir::LoopId(program[id].payload)];
      if (!execute::IsShort(program, loop, machine::kMostUnrolled)) continue;
      execute::LoopSummary summary = execute::SummarizeLoop(program, version.cells, id);
      if (!summary.opaque) loops[std::move(summary.text)].insert(id);
    }
  }
  return loops;
}

}  // namespace

void ShareLoops(machine::Version& old_version, machine::Version& new_version) {
  const std::map<std::string, std::set<ir::InstId>> old_loops = ShortLoopsOf(old_version),
                                                    new_loops = ShortLoopsOf(new_version);
  for (const auto& [text, loops] : old_loops) {
    const auto same = new_loops.find(text);
    if (same == new_loops.end()) continue;
    old_version.shared_loops.insert(loops.begin(), loops.end());
    new_version.shared_loops.insert(same->second.begin(), same->second.end());
  }
}

bool MayBeKept(const machine::Version& old_version, const machine::Version& new_version, const Match& match,
               execute::CellId old_cell) {
  if (!old_cell.valid() || match.starts_otherwise[old_cell.index]) return false;
  const execute::CellId new_cell = match.new_of_old[old_cell.index];
  return new_cell.valid() && old_version.program->schedule.retention && new_version.program->schedule.retention &&
         machine::IsRetentive(old_version, old_cell) && machine::IsRetentive(new_version, new_cell);
}

std::vector<execute::CellId> MatchedRequests(const machine::Version& old_version, const machine::Version& new_version,
                                             const Match& match) {
  const std::vector<bool> old_cells = machine::RequestCells(old_version),
                          new_cells = machine::RequestCells(new_version);
  std::vector<execute::CellId> requests;
  for (uint32_t i = 0; i < old_cells.size(); ++i) {
    const execute::CellId new_cell = match.new_of_old[i];
    if (old_cells[i] && new_cell.valid() && new_cells[new_cell.index]) requests.emplace_back(i);
  }
  return requests;
}

}  // namespace plcxx::prove::diff
