// Bits that several instructions want to decide.

#include <algorithm>
#include <map>
#include <vector>

#include "transpiler/dialects/prostep/analysis/warnings.h"

namespace plcxx::prostep {
namespace {

/// One '=' of the bit.
struct Coil {
  ModuleId module;
  uint32_t number = 0;  // in its module
};
using CoilSet = std::vector<uint32_t>;  // indices of coils, ascending: in the order of the text

/// An instruction under which coils are reached: a coil itself, or the call of a module that has some.
struct CoilPlace {
  uint32_t number = 0;  // in the module
  CoilSet coils;
};

/// That the coil can be executed in a pass in which a place is reached, because of another place.
struct Meeting {
  uint32_t coil = 0;
  uint32_t place = 0;  // index of that other one
  bool operator==(const Meeting&) const = default;
};

/// The least coils that meet a place, ascending. All but the first two that are told apart from each coil and each
/// place change no message: a coil is reported with the first other one alone.
class Meetings {
 public:
  /// In ascending order of coils; false: it changes nothing, here or further on.
  bool Add(Meeting meeting) {
    if (std::ranges::find(list_, meeting) != list_.end() || IsComplete()) return false;
    list_.push_back(meeting);
    return true;
  }

  /// The least coil that is another one, in another place; none: size of uint32_t's range.
  uint32_t First(uint32_t coil, uint32_t place) const {
    for (const Meeting& each : list_) {
      if (each.coil != coil && each.place != place) return each.coil;
    }
    return UINT32_MAX;
  }

 private:
  /// Has every place, left out, two different coils still?
  bool IsComplete() const {
    const auto suffices_without = [&](uint32_t place) {
      const auto counts = [place](const Meeting& each) { return each.place != place; };
      const auto one = std::ranges::find_if(list_, counts);
      return one != list_.end() && std::find_if(one, list_.end(), [&](const Meeting& each) {
                                     return counts(each) && each.coil != one->coil;
                                   }) != list_.end();
    };
    return !list_.empty() &&
           std::ranges::all_of(list_, [&](const Meeting& each) { return suffices_without(each.place); });
  }

  std::vector<Meeting> list_;
};

/// Which places of a module are executed in one run of it. The cost is that of the module, whatever the number of
/// places: the coils spread along the paths in ascending order, and an instruction hands on only the first few that
/// come to it.
class MeetingsOfModule {
 public:
  MeetingsOfModule(const ModulePaths& module, const std::vector<CoilPlace>& places) : module_(module), places_(places) {
    for (uint32_t i = 0; i < places.size(); ++i) {
      const CoilSet& coils = places[i].coils;
      for (size_t k = 0; k < std::min<size_t>(2, coils.size()); ++k) sources_.push_back({coils[k], i});
    }
    std::ranges::sort(sources_, {}, &Meeting::coil);
    const bool all_meet = module.IsStraight(places.front().number, places.back().number);
    if (all_meet) {
      for (const Meeting& source : sources_) all_.Add(source);
      return;
    }
    first_ = module.jumps_back() ? 0 : places.front().number;
    last_ = module.jumps_back() ? module.size() : places.back().number;
    Spread(forward_, [&](uint32_t number, const auto& visit) { module_.VisitNext(number, visit); });
    // Without calls the coils are in the order of the places.
    if (!module.jumps_back() && module.calls().empty()) return;
    std::vector<std::vector<uint32_t>> before(last_ - first_ + 1);
    for (uint32_t i = first_; i <= last_; ++i) {
      module.VisitNext(i, [&](uint32_t next) {
        if (next >= first_ && next <= last_) before[next - first_].push_back(i);
      });
    }
    Spread(backward_, [&](uint32_t number, const auto& visit) {
      for (const uint32_t each : before[number - first_]) visit(each);
    });
  }

  /// The first coil of another place that the coil of this place meets.
  uint32_t First(uint32_t coil, uint32_t place) const {
    if (forward_.empty()) return all_.First(coil, place);
    const uint32_t at = places_[place].number - first_;
    const uint32_t earlier = forward_[at].First(coil, place);
    return backward_.empty() ? earlier : std::min(earlier, backward_[at].First(coil, place));
  }

 private:
  void Spread(std::vector<Meetings>& reached, const auto& visit_next) {
    reached.resize(last_ - first_ + 1);
    std::vector<uint32_t> open;
    for (const Meeting& source : sources_) {
      const uint32_t own = places_[source.place].number;
      const auto meet = [&](uint32_t number) {
        if (number < first_ || number > last_ || number == own) return;
        if (reached[number - first_].Add(source)) open.push_back(number);
      };
      visit_next(own, meet);
      while (!open.empty()) {
        const uint32_t number = open.back();
        open.pop_back();
        visit_next(number, meet);
      }
    }
  }

  const ModulePaths& module_;
  const std::vector<CoilPlace>& places_;
  std::vector<Meeting> sources_;
  Meetings all_;
  uint32_t first_ = 0, last_ = 0;             // instructions that are looked at
  std::vector<Meetings> forward_, backward_;  // by instruction from first_ on: what leads to it, and where it leads to
};

/// Which coils of one bit can be executed in one pass.
struct CoilChecker {
  const Program& program;
  const Paths& paths;
  const std::vector<Coil>& coils;
  std::map<uint32_t, CoilSet> below = {};  // by ModuleId: what its execution can reach
  std::vector<uint32_t> first_other = std::vector<uint32_t>(coils.size(), UINT32_MAX);  // the first one that meets it

  void Meet(uint32_t coil, uint32_t other) { first_other[coil] = std::min(first_other[coil], other); }

  /// The coils that are reached from the module, and which of them meet in it.
  const CoilSet& Visit(ModuleId id) {
    const auto [found, is_new] = below.try_emplace(id.index);
    if (!is_new) return found->second;
    const ModulePaths& module = paths[id.index];
    std::vector<CoilPlace> places;
    // The coils are in the order of the text: a module's are beside each other.
    const auto own = std::ranges::equal_range(coils, id.index, {}, [](const Coil& coil) { return coil.module.index; });
    for (const Coil& coil : own) {
      if (module.IsReached(coil.number)) places.push_back({coil.number, {static_cast<uint32_t>(&coil - coils.data())}});
    }
    for (const auto& [callee, numbers] : module.calls()) {
      const CoilSet inside = Visit(callee);
      if (inside.empty()) continue;
      // More than two coils are the same for all calls of a module: they are in its own set.
      const CoilSet least(inside.begin(), inside.begin() + std::min<ptrdiff_t>(2, std::ssize(inside)));
      for (const uint32_t number : numbers) places.push_back({number, least});
    }
    std::ranges::sort(places, {}, &CoilPlace::number);
    std::map<uint32_t, std::vector<uint32_t>> sites;  // by ModuleId of those with coils: indices of places
    for (uint32_t i = 0; i < places.size(); ++i) {
      const ModuleId callee = module.At(places[i].number).module;
      if (callee.valid()) sites[callee.index].push_back(i);
    }
    CoilSet all;
    if (places.size() > 1) {
      const MeetingsOfModule meetings(module, places);
      for (uint32_t i = 0; i < places.size(); ++i) {
        if (!module.At(places[i].number).module.valid())
          Meet(places[i].coils[0], meetings.First(places[i].coils[0], i));
      }
      for (const auto& [callee, indices] : sites) MeetCalled(below[callee], indices, meetings);
    }
    for (const CoilPlace& place : places) {
      if (!module.At(place.number).module.valid()) all.push_back(place.coils[0]);
    }
    for (const auto& [callee, indices] : sites) all.insert(all.end(), below[callee].begin(), below[callee].end());
    std::ranges::sort(all);
    all.erase(std::ranges::unique(all).begin(), all.end());
    return below[id.index] = std::move(all);
  }

  /// What the coils of a module meet where it is called. All but the least two meet the same ones.
  void MeetCalled(const CoilSet& called, const std::vector<uint32_t>& sites, const MeetingsOfModule& meetings) {
    uint32_t any = UINT32_MAX;
    for (const uint32_t place : sites) any = std::min(any, meetings.First(UINT32_MAX, place));
    for (const uint32_t coil : called) {
      if (coil != any) {
        Meet(coil, any);
        continue;
      }
      for (const uint32_t place : sites) Meet(coil, meetings.First(coil, place));
    }
  }

  void Pass(uint32_t first, uint32_t last) {
    CoilSet before;
    const auto meet = [this](const CoilSet& set, const CoilSet& others) {
      if (others.empty()) return;
      for (const uint32_t coil : set) {
        if (coil != others[0]) {
          Meet(coil, others[0]);
        } else if (others.size() > 1) {
          Meet(coil, others[1]);
        }
      }
    };
    for (uint32_t number = first; number <= last; ++number) {
      if (!program.module_of[number].valid()) continue;
      const CoilSet& here = Visit(program.module_of[number]);
      if (here.empty()) continue;
      meet(before, here);
      meet(here, before);
      CoilSet both;
      std::ranges::set_union(before, here, std::back_inserter(both));
      before = std::move(both);
    }
  }
};

uint32_t KeyOfOperand(const Operand& operand) {
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
        first_assigned.try_emplace(KeyOfOperand(operand), instruction.range);
        if (operand.space() == Space::kO || operand.space() == Space::kF) {
          assigned[KeyOfOperand(operand)].push_back({ModuleId(m), i});
        }
      } else if (instruction.op == Op::kSet || instruction.op == Op::kReset) {
        first_set.try_emplace(KeyOfOperand(operand), instruction.range);
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
    for (uint32_t coil = 0; coil < coils.size(); ++coil) {
      const uint32_t other = checker.first_other[coil];
      if (other >= coil) continue;  // a pair is one message, at its later coil
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
