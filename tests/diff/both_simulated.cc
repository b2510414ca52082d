#include "tests/diff/both_simulated.h"

#include <array>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "transpiler/prove/diff/match.h"
#include "transpiler/review/diff/items.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/sim/clock.h"
#include "transpiler/sim/simulator.h"
#include "transpiler/symbolic/execute/execute.h"

namespace plcxx::review::diff {
namespace {

using execute::Cell;
using execute::CellId;
using execute::CellKind;
using execute::HostRole;
using prove::machine::Version;
using terms::Random;

/// A number that depends on all that came before.
uint64_t Mixed(uint64_t hash, uint64_t value) {
  hash = (hash ^ value) * 0x9E3779B97F4A7C15;
  return hash ^ (hash >> 29);
}

/// Whose answers a program gets: those of the dialect's simulated control, which look at all the state; or a function's
/// own, which depend on the seed and on all calls before but reports of faults, of the regular exchange and of these on
/// that function's calls alone.
enum class Answers : uint8_t { kOfControl, kOfCalls };

class Machine {
 public:
  Machine(const DiffSide& side, Answers answers, uint64_t seed)
      : program_(side.compilation.program),
        roles_(execute::MakeCells(program_, execute::ExchangeCalls::kApart).roles),
        answers_alone_(roles_.size()),
        simulator_(program_),
        control_(program_, *side.compilation.dialect, simulator_,
                 answers == Answers::kOfControl
                     ? side.compilation.dialect->make_stub(program_, side.compilation.options)
                     : std::unique_ptr<dialects::ControlStub>()),
        clock_(program_, {&simulator_}) {
    for (const ir::Call& call : program_.calls) {
      if (call.exchange && call.host.valid()) answers_alone_[call.host.index] = true;
    }
    for (const ir::HostFunction& function : program_.host_functions) {
      Asked& asked = functions_.emplace_back();
      for (const char c : function.name) asked.name = Mixed(asked.name, static_cast<unsigned char>(c));
    }
    if (answers == Answers::kOfCalls) {
      simulator_.AnswerHostCalls([this, seed](ir::HostFunctionId id, std::span<const uint64_t> arguments) {
        return Answer(id, arguments, seed);
      });
    }
    clock_.before_period = [this](uint32_t now_ms) { control_.BeforePeriod(now_ms); };
    clock_.after_period = [this](uint32_t now_ms) { control_.AfterPeriod(now_ms); };
    clock_.PowerOn();
    control_.PowerOn();
  }

  /// From now on it is kept what functions that are no exchange find at these places when they are called.
  void Watch(std::vector<ir::Place> places) {
    watched_ = std::move(places);
    for (uint32_t f = 0; f < functions_.size(); ++f) {
      Asked& asked = functions_[f];
      const ir::HostAccess access = program_.host_functions[ir::HostFunctionId(f)].access;
      for (uint32_t i = 0; roles_[f] != HostRole::kExchange && i < watched_.size(); ++i) {
        const ir::Place& place = watched_[i];
        if (!place.is_field() && execute::HostSees(access, program_.spaces[place.space])) asked.sees.push_back(i);
      }
      if (!asked.sees.empty()) asked.seen.resize(watched_.size());
    }
  }
  /// By watched place: all that a function has found there, as one number; nothing of a function that sees nothing.
  std::vector<uint64_t> SeenBy(const std::string& name) const {
    for (uint32_t f = 0; f < functions_.size(); ++f) {
      if (program_.host_functions[ir::HostFunctionId(f)].name == name) return functions_[f].seen;
    }
    return {};
  }

  /// Some controls keep memory without power only where the program has asked for it.
  void AskToKeep() {
    const ir::PlaceId asked = program_.schedule.retain_at_power_off;
    if (asked.valid()) Set(program_.places[asked], 1);
  }
  void PowerCycle() {
    control_.PowerOff();
    clock_.PowerCycle();
    control_.PowerOn();
  }
  void Set(const ir::Place& place, uint64_t value) {
    if (simulator_.Read(place) == value) return;
    dialects::Location location;
    location.place = place;
    control_.Set(location, value);
  }
  uint64_t Read(const ir::Place& place) { return simulator_.Read(place); }
  void SendText(const std::string& text) { simulator_.SendText(text); }
  sim::Clock& clock() { return clock_; }

  /// By function: all its calls so far; of all that are no exchange, in their order, under no name.
  const std::map<std::string, uint64_t>& Calls() {
    for (const sim::HostEvent& event : simulator_.TakeEvents()) {
      if (event.exchange) continue;
      Asked& own = functions_[event.function.index];
      if (own.calls == nullptr) own.calls = &calls_[program_.host_functions[event.function].name];
      uint64_t& calls = *own.calls;
      for (const uint64_t argument : event.arguments) calls = Mixed(calls, argument);
      calls = Mixed(calls, 1);
      if (roles_[event.function.index] != HostRole::kExchange) *in_order_ = Mixed(Mixed(*in_order_, own.name), calls);
    }
    return calls_;
  }

 private:
  sim::HostAnswer Answer(ir::HostFunctionId id, std::span<const uint64_t> arguments, uint64_t seed) {
    const ir::HostFunction& function = program_.host_functions[id];
    Asked& own = functions_[id.index];
    for (const uint32_t i : own.sees) own.seen[i] = Mixed(own.seen[i], simulator_.Read(watched_[i]) + 1);
    const bool is_in_order = roles_[id.index] == HostRole::kAction && !answers_alone_[id.index];
    uint64_t& asked = is_in_order ? asked_in_order_ : own.asked;
    asked = Mixed(asked, seed);
    for (const uint64_t argument : arguments) asked = Mixed(asked, argument);
    asked = Mixed(asked, own.name);
    const auto fitting = [](ir::Type type, uint64_t value) {
      if (type == ir::Type::kNone) return uint64_t{0};
      const uint32_t bits = type == ir::Type::kBit ? 1 : 8 * ir::Bytes(type);
      return bits >= 64 ? value : value & ((uint64_t{1} << bits) - 1);
    };
    sim::HostAnswer answer;
    answer.result = fitting(function.result, asked >> 7);
    const bool second = !function.out.name.empty() && (asked >> 5 & 3) != 0;
    if (second) answer.out = fitting(function.out.type, asked >> 11);
    return answer;
  }

  const ir::Program& program_;
  std::vector<HostRole> roles_;
  std::vector<bool> answers_alone_;  // by HostFunctionId: called by the regular exchange, too
  sim::Simulator simulator_;
  scenarios::ScenarioControl control_;
  sim::Clock clock_;
  /// A function of the host.
  struct Asked {
    uint64_t name = 0, asked = 0;
    std::vector<uint32_t> sees;  // indices of watched_
    std::vector<uint64_t> seen;  // see SeenBy
    uint64_t* calls = nullptr;   // of calls_; a program may call millions of times
  };
  std::vector<Asked> functions_;  // by HostFunctionId
  uint64_t asked_in_order_ = 0;
  std::map<std::string, uint64_t> calls_;
  uint64_t* in_order_ = &calls_[""];
  std::vector<ir::Place> watched_;
};

/// A cell as a place that an engine reads.
std::optional<ir::Place> PlaceOf(const Version& version, CellId id) {
  const Cell cell = execute::CellAt(*version.program, version.cells, id);
  ir::Place place;
  switch (cell.kind) {
    case CellKind::kCalls:
      return std::nullopt;
    case CellKind::kField: {
      const ir::FieldInfo& field = ir::Info(version.program->states[cell.state].kind).fields[cell.field];
      if (field.count != 1) return std::nullopt;
      place.type = field.type;
      place.state = cell.state;
      place.field = cell.field;
      return place;
    }
    case CellKind::kBit:
      if (version.program->spaces[cell.space].lifetime == ir::Lifetime::kRoutine) return std::nullopt;
      place.type = ir::Type::kBit;
      place.space = cell.space;
      place.offset = cell.offset;
      place.bit = cell.bit;
      return place;
  }
  return std::nullopt;
}

struct Compared {
  std::string name;
  ir::Place old_place, new_place;
};

/// What the comparison says to be equal, and what the machine sets.
struct Locations {
  std::vector<Compared> equal, inputs;
  std::vector<Compared> requests;  // what the control takes back when it likes
  std::vector<Compared> kept;      // what may be anything when power comes for the first time
  std::set<std::string> equal_calls;
};

Locations LocationsOf(const DiffSide& old_side, const DiffSide& new_side, const Diff& diff,
                      const DiffOptions& options) {
  const Version old_version = prove::machine::MakeVersion(old_side.compilation.program),
                new_version = prove::machine::MakeVersion(new_side.compilation.program);
  std::vector<std::pair<ir::Place, ir::Place>> same;
  for (const auto& [old_name, new_name] : options.same) {
    const auto one = old_side.compilation.dialect->locate(ir::NameIndex(old_side.compilation.program), old_name);
    const auto other = new_side.compilation.dialect->locate(ir::NameIndex(new_side.compilation.program), new_name);
    if (one && other) same.emplace_back(one->place, other->place);
  }
  const prove::diff::Match match = prove::diff::MatchCells(old_version, new_version, same);
  const prove::machine::Uses old_uses = prove::machine::UsesOf(old_version),
                             new_uses = prove::machine::UsesOf(new_version);
  const CellWords old_words(old_version, old_side.compilation), new_words(new_version, new_side.compilation);
  std::set<std::string> listed;
  for (const DiffItem& item : diff.items) {
    listed.insert(item.name);
    // What is seen between two slices is one item.
    if (item.kind == ItemKind::kSchedule) listed.insert(item.through.begin(), item.through.end());
  }
  const auto is_named = [&diff](const std::string& name) {
    return std::ranges::any_of(std::array{&diff.old_only, &diff.new_only, &diff.of_slices},
                               [&name](const auto* names) { return std::ranges::find(*names, name) != names->end(); });
  };
  Locations locations;
  for (uint32_t i = 0; i < old_version.cells.count; ++i) {
    const CellId old_cell(i), new_cell = match.new_of_old[i];
    if (!new_cell.valid() || !prove::machine::IsState(old_version, old_cell) ||
        !prove::machine::IsState(new_version, new_cell))
      continue;
    const bool old_used = old_uses.reads[i] || old_uses.writes[i];
    const bool new_used = new_uses.reads[new_cell.index] || new_uses.writes[new_cell.index];
    if (!old_used && !new_used) continue;
    const std::string name = old_words.WordOf(old_cell).name;
    const bool is_listed = listed.contains(name) || listed.contains(new_words.WordOf(new_cell).name);
    const Cell cell = execute::CellAt(*old_version.program, old_version.cells, old_cell);
    if (cell.kind == CellKind::kCalls) {
      const bool any_calls = std::ranges::any_of(diff.items, [](const DiffItem& item) {
        return item.kind == ItemKind::kCalls;  // the order follows from them
      });
      if (!is_listed && cell.host.valid())
        locations.equal_calls.insert(old_version.program->host_functions[cell.host].name);
      if (!cell.host.valid() && !any_calls) locations.equal_calls.insert("");
      continue;
    }
    const std::optional<ir::Place> old_place = PlaceOf(old_version, old_cell),
                                   new_place = PlaceOf(new_version, new_cell);
    if (!old_place || !new_place) continue;
    if (prove::diff::MayBeKept(old_version, new_version, match, old_cell))
      locations.kept.push_back({name, *old_place, *new_place});
    if (prove::diff::IsInputPair(old_version, new_version, old_uses, new_uses, match, old_cell)) {
      locations.inputs.push_back({name, *old_place, *new_place});
    }
    if (!is_listed && (old_uses.writes[i] || new_uses.writes[new_cell.index])) {
      // A flag that one version alone has is not compared, and the verdict names it.
      if (!is_named(name) && !is_named(new_words.WordOf(new_cell).name))
        locations.equal.push_back({name, *old_place, *new_place});
    }
  }
  for (const CellId request : prove::diff::MatchedRequests(old_version, new_version, match)) {
    const std::optional<ir::Place> old_place = PlaceOf(old_version, request),
                                   new_place = PlaceOf(new_version, match.new_of_old[request.index]);
    if (old_place && new_place) locations.requests.push_back({old_words.WordOf(request).name, *old_place, *new_place});
  }
  return locations;
}

/// What an operator may send, where either version waits for a text.
std::vector<std::string> TextsOf(const DiffSide& old_side, const DiffSide& new_side) {
  std::vector<std::string> texts;
  for (const ir::Program* const program : {&old_side.compilation.program, &new_side.compilation.program}) {
    if (!program->text_inbox.valid()) continue;
    for (uint32_t i = 0; i < program->texts.size(); ++i) texts.push_back(program->texts[ir::TextId(i)]);
  }
  return texts;
}

}  // namespace

std::optional<std::string> SeenToDiffer(const DiffSide& old_side, const DiffSide& new_side, const Diff& diff,
                                        const DiffOptions& options, SimulatedRuns runs, Random& random) {
  const Locations locations = LocationsOf(old_side, new_side, diff, options);
  const ir::Schedule& schedule = old_side.compilation.program.schedule;
  const bool has_fast = schedule.fast_only.valid() && schedule.fast_only != schedule.period;
  // Where parts are counted otherwise, as many of them are not as many periods.
  const auto is_alike = [&](ir::PlaceId counter) {
    if (!counter.valid()) return true;
    const ir::Place& place = old_side.compilation.program.places[counter];
    return std::ranges::any_of(locations.equal, [&place](const Compared& equal) {
      return equal.old_place.space == place.space && equal.old_place.offset == place.offset;
    });
  };
  const bool slow_is_alike = is_alike(schedule.slow_done), fast_is_alike = is_alike(schedule.fast_done);
  const std::vector<std::string> texts = TextsOf(old_side, new_side);
  for (int run = 0; run < runs.runs; ++run) {
    // The simulated control answers what it sees, so it goes with programs that are equal in everything.
    const Answers answers = diff.items.empty() && run % 2 == 0 ? Answers::kOfControl : Answers::kOfCalls;
    const uint64_t seed = random.Next();
    Machine old_machine(old_side, answers, seed), new_machine(new_side, answers, seed);
    std::vector<ir::Place> old_places, new_places;
    for (const Compared& equal : locations.equal) {
      old_places.push_back(equal.old_place);
      new_places.push_back(equal.new_place);
    }
    old_machine.Watch(std::move(old_places));
    new_machine.Watch(std::move(new_places));
    if (!locations.kept.empty() && run % 4 == 3) {
      for (const Compared& kept : locations.kept) {
        const uint64_t value = random.OneIn(3) ? 1 : 0;
        old_machine.Set(kept.old_place, value);
        new_machine.Set(kept.new_place, value);
      }
      for (Machine* machine : {&old_machine, &new_machine}) {
        machine->AskToKeep();
        machine->PowerCycle();
      }
    }
    const uint64_t one_in = uint64_t{1} << (random.Next() % 6), ones = 1 + random.Next() % 3;
    // Of a short period that is many.
    const uint64_t most_waited_ms = std::max<uint64_t>(8'000, uint64_t{1'000} * schedule.period_ms);
    uint64_t waited_ms = 0;
    for (int step = 1; step <= runs.steps; ++step) {
      // Bits at random; now and then whole bytes are what people write: small numbers, limits of a type.
      constexpr std::array<uint8_t, 12> kUsual = {0, 1, 2, 3, 5, 9, 0x10, 0x64, 0x7F, 0x80, 0x99, 0xFF};
      const bool bytes = random.OneIn(3);
      uint64_t usual = 0, byte = ~uint64_t{0};
      for (const Compared& input : locations.inputs) {
        const ir::Place& place = input.old_place;
        if (const uint64_t here = uint64_t{place.space.index} << 32 | place.offset; here != byte) {
          byte = here;
          usual = random.OneIn(one_in) || step == 1 ? kUsual[(random.Next() >> 9) % kUsual.size()] : 0x100;
        }
        if (bytes && usual == 0x100) continue;
        if (!bytes && step != 1 && !random.OneIn(one_in)) continue;
        const uint64_t value = bytes ? usual >> place.bit & 1 : random.Next() % 4 < ones ? 1 : 0;
        old_machine.Set(place, value);
        new_machine.Set(input.new_place, value);
      }
      for (const Compared& request : locations.requests) {
        if (!random.OneIn(4 * one_in)) continue;
        old_machine.Set(request.old_place, 0);
        new_machine.Set(request.new_place, 0);
      }
      if (!texts.empty() && random.OneIn(one_in + 1)) {
        const std::string& text = texts[random.Next() % texts.size()];
        old_machine.SendText(text);
        new_machine.SendText(text);
      }
      const uint64_t what = random.Next() % 32, length = 1 + random.Next() % 40;
      for (Machine* machine : {&old_machine, &new_machine}) {
        sim::Clock& clock = machine->clock();
        if (what == 0) {
          machine->PowerCycle();
        } else if (what < 8) {
          clock.RunMs(schedule.period_ms * length);
        } else if (what < 11 && waited_ms < most_waited_ms) {
          clock.RunMs(137 * length);
        } else if (what < 14 && has_fast && fast_is_alike) {
          clock.RunFast(1);
        } else if (slow_is_alike) {
          clock.RunSlow(1);
        } else {
          clock.RunMs(schedule.period_ms);
        }
      }
      if (8 <= what && what < 11) waited_ms += 137 * length;
      const std::string when = " after step " + std::to_string(step) + " of run " + std::to_string(run + 1);
      for (const Compared& equal : locations.equal) {
        const uint64_t one = old_machine.Read(equal.old_place), other = new_machine.Read(equal.new_place);
        if (one == other) continue;
        return equal.name + " is " + std::to_string(one) + " and " + std::to_string(other) + when;
      }
      const auto& old_calls = old_machine.Calls();
      const auto& new_calls = new_machine.Calls();
      for (const std::string& name : locations.equal_calls) {
        const auto calls_of = [&name](const std::map<std::string, uint64_t>& calls) {
          const auto at = calls.find(name);
          return at == calls.end() ? 0 : at->second;
        };
        if (calls_of(old_calls) != calls_of(new_calls)) return "other calls of " + name + when;
        const std::vector<uint64_t> old_seen = old_machine.SeenBy(name), new_seen = new_machine.SeenBy(name);
        if (old_seen.size() != new_seen.size() || old_seen.empty()) continue;
        for (size_t i = 0; i < locations.equal.size(); ++i) {
          if (old_seen[i] != new_seen[i]) return name + " sees another value of " + locations.equal[i].name + when;
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace plcxx::review::diff
