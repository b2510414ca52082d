#include "transpiler/report/cross_reference.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/zones.h"

namespace plcxx::report {
namespace {

using Stretches = std::vector<std::pair<uint64_t, uint64_t>>;

/// Ascending, without overlaps.
void Merge(Stretches& stretches) {
  std::ranges::sort(stretches);
  size_t kept = 0;
  for (const auto& stretch : stretches) {
    if (kept > 0 && stretch.first <= stretches[kept - 1].second) {
      stretches[kept - 1].second = std::max(stretches[kept - 1].second, stretch.second);
    } else {
      stretches[kept++] = stretch;
    }
  }
  stretches.resize(kept);
}

bool Covers(const Stretches& merged, uint64_t first, uint64_t last) {
  const auto behind = std::ranges::upper_bound(merged, last - 1, {}, &std::pair<uint64_t, uint64_t>::first);
  return behind != merged.begin() && std::prev(behind)->second > first;
}

/// Bits of the space: of an indexed place, all that an index can reach.
std::pair<uint64_t, uint64_t> BitsOf(const ir::Place& place) {
  if (place.indexed) return {uint64_t{place.low} * 8, std::max<uint64_t>(place.high, place.low + 1) * 8};
  const uint64_t byte = uint64_t{place.offset} * 8;
  if (place.type == ir::Type::kBit) return {byte + (place.bit & 7), byte + (place.bit & 7) + 1};
  return {byte, byte + uint64_t{ir::Bytes(place.type)} * 8};
}

class Collector {
 public:
  explicit Collector(const ProgramInput& input) : input_(input), program_(*input.program) {
    result_.of_place.assign(program_.places.size(), kNoSignal);
    result_.of_state.assign(program_.states.size(), kNoSignal);
    result_.used.resize(program_.spaces.size());
    read_.resize(Owners());
    written_.resize(Owners());
  }

  CrossReference Run() {
    Parts();
    for (uint32_t i = 0; i < program_.routines.size(); ++i) {
      const ir::Routine& routine = program_.routines[ir::RoutineId(i)];
      routine_ = ir::RoutineId(i);
      for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) Region(region, {});
    }
    Document();
    Sort();
    Overlaps();
    return std::move(result_);
  }

 private:
  /// (owner, first, last, type, bits): spaces, then instances.
  using Key = std::tuple<uint32_t, uint64_t, uint64_t, uint8_t>;

  uint32_t Owners() const { return program_.spaces.size() + program_.states.size(); }
  uint32_t OwnerOf(const ir::Place& place) const {
    return place.is_field() ? program_.spaces.size() + place.state.index : place.space.index;
  }
  void Parts();
  void Region(ir::RegionId region, ir::StatementId statement);
  void Inst(const ir::Inst& inst, ir::StatementId statement);
  void Note(uint32_t signal, ir::StatementId statement, Use use);
  uint32_t SignalOf(const ir::Place& place);
  uint32_t SignalOf(ir::PlaceId place);
  uint32_t SignalOf(ir::StateId state);
  void Document();
  void Sort();
  void Overlaps();

  const ProgramInput& input_;
  const ir::Program& program_;
  CrossReference result_;
  std::map<Key, uint32_t> by_bits_;
  std::vector<Stretches> read_, written_;  // by owner
  std::vector<uint32_t> owner_;            // by signal
  ir::RoutineId routine_;
};

void Collector::Parts() {
  const uint32_t count = program_.routines.size();
  std::vector<std::vector<uint32_t>> calls(count);
  std::vector<uint32_t> last_caller(count, count);
  for (uint32_t i = 0; i < count; ++i) {
    const ir::Routine& routine = program_.routines[ir::RoutineId(i)];
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      ir::ForEachInst(program_, region, [&](ir::InstId id) {
        if (program_[id].op != ir::OpKind::kCall) return;
        const uint32_t callee = program_.calls[ir::CallId(program_[id].payload)].routine.index;
        if (std::exchange(last_caller[callee], i) != i) calls[i].push_back(callee);
      });
    }
  }
  result_.parts.resize(count);
  for (uint32_t root = 0; root < count; ++root) {
    const ir::Routine& routine = program_.routines[ir::RoutineId(root)];
    if (routine.kind == ir::RoutineKind::kSubroutine) continue;
    std::vector<bool> seen(count);
    std::vector<uint32_t> open = {root};
    while (!open.empty()) {
      const uint32_t at = open.back();
      open.pop_back();
      if (seen[at]) continue;
      seen[at] = true;
      if (at != root && program_.routines[ir::RoutineId(at)].kind != ir::RoutineKind::kSubroutine) continue;
      result_.parts[at] += (result_.parts[at].empty() ? "" : ", ") + routine.name;
      open.insert(open.end(), calls[at].begin(), calls[at].end());
    }
  }
}

uint32_t Collector::SignalOf(const ir::Place& place) {
  const auto [first, last] = BitsOf(place);
  // Fields are told apart by their numbers, memory by its bits.
  const Key key = place.is_field() ? Key{OwnerOf(place), place.field, place.field + 1u, 0}
                                   : Key{OwnerOf(place), first, last, static_cast<uint8_t>(place.indexed)};
  const auto [found, is_new] = by_bits_.emplace(key, static_cast<uint32_t>(result_.signals.size()));
  if (!is_new) return found->second;
  Signal signal;
  signal.name = place.name;
  if (place.address != place.name) signal.address = place.address;
  signal.type = ir::Name(place.type);
  if (place.indexed) signal.type += "[]";
  signal.first = std::get<1>(key);
  signal.last = std::get<2>(key);
  if (place.is_field()) {
    signal.state = place.state;
  } else {
    const ir::Space& space = program_.spaces[place.space];
    signal.space = place.space;
    signal.lifetime = space.lifetime;
    signal.direction = ir::DirectionOf(space, static_cast<uint32_t>(signal.first / 8), signal.first % 8);
  }
  owner_.push_back(OwnerOf(place));
  result_.signals.push_back(std::move(signal));
  return found->second;
}

uint32_t Collector::SignalOf(ir::PlaceId place) {
  uint32_t& known = result_.of_place[place.index];
  if (known == kNoSignal) known = SignalOf(program_.places[place]);
  return known;
}

uint32_t Collector::SignalOf(ir::StateId state) {
  uint32_t& known = result_.of_state[state.index];
  if (known != kNoSignal) return known;
  known = static_cast<uint32_t>(result_.signals.size());
  const ir::StateInstance& instance = program_.states[state];
  Signal signal;
  signal.name = instance.name;
  signal.type = ir::Info(instance.kind).text;
  signal.state = state;
  signal.last = ir::Info(instance.kind).fields.size();
  owner_.push_back(program_.spaces.size() + state.index);
  result_.signals.push_back(std::move(signal));
  return known;
}

void Collector::Note(uint32_t index, ir::StatementId statement, Use use) {
  Signal& signal = result_.signals[index];
  std::vector<Stretches>& side = use == Use::kRead ? read_ : written_;
  side[owner_[index]].emplace_back(signal.first, signal.last);
  if (use == Use::kStep) read_[owner_[index]].emplace_back(signal.first, signal.last);
  if (!signal.occurrences.empty()) {
    const Occurrence& before = signal.occurrences.back();
    if (before.statement == statement && before.routine == routine_ && before.use == use) return;
  }
  signal.occurrences.push_back({statement, routine_, use});
}

void Collector::Inst(const ir::Inst& inst, ir::StatementId statement) {
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kLoad:
      Note(SignalOf(ir::PlaceId(inst.payload)), statement, Use::kRead);
      break;
    case ir::Shape::kStore:
      Note(SignalOf(ir::PlaceId(inst.payload)), statement, Use::kWrite);
      break;
    case ir::Shape::kStep:
      Note(SignalOf(ir::StateId(inst.payload)), statement, Use::kStep);
      break;
    case ir::Shape::kText:
      Note(SignalOf(ir::StateId(inst.payload)), statement, Use::kStep);
      Note(SignalOf(ir::StateId(inst.a)), statement, Use::kRead);
      break;
    case ir::Shape::kLoop:
      if (program_.loops[ir::LoopId(inst.payload)].budget.valid()) {
        Note(SignalOf(program_.loops[ir::LoopId(inst.payload)].budget), statement, Use::kRead);
      }
      break;
    case ir::Shape::kHostCall:
      if (program_.calls[ir::CallId(inst.payload)].out.valid()) {
        Note(SignalOf(program_.calls[ir::CallId(inst.payload)].out), statement, Use::kWrite);
      }
      break;
    case ir::Shape::kPure:
    case ir::Shape::kConst:
    case ir::Shape::kStatement:
    case ir::Shape::kIf:
    case ir::Shape::kSwitch:
    case ir::Shape::kBlock:
    case ir::Shape::kExit:
    case ir::Shape::kRepeat:
    case ir::Shape::kCall:
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      break;
  }
}

void Collector::Region(ir::RegionId region, ir::StatementId statement) {
  if (!region.valid()) return;
  for (const ir::InstId id : program_.regions[region].insts) {
    const ir::Inst& inst = program_[id];
    if (inst.op == ir::OpKind::kStatement) statement = ir::StatementId(inst.payload);
    Inst(inst, statement);
    if (ir::Info(inst.op).effect == ir::Effect::kControl) {
      for (const ir::RegionId owned : ir::OwnedRegions(program_, inst)) Region(owned, statement);
    }
  }
}

/// Meanings and names from the dialect's table; what has a name of the program's own but no use becomes a signal, too.
void Collector::Document() {
  for (size_t i = 0; i < program_.documentation.size() && i < input_.documented.size(); ++i) {
    const ir::Documentation& known = program_.documentation[i];
    const std::optional<ir::Place>& place = input_.documented[i];
    if (!place) continue;
    const auto [first, last] = BitsOf(*place);
    const Key key = place->is_field() ? Key{OwnerOf(*place), place->field, place->field + 1u, 0}
                                      : Key{OwnerOf(*place), first, last, static_cast<uint8_t>(place->indexed)};
    const bool is_used = by_bits_.contains(key);
    if (!is_used && known.symbols.empty()) continue;
    Signal& signal = result_.signals[SignalOf(*place)];
    if (!is_used) signal.documented_only = true;
    if (!is_used && !known.symbols.empty()) signal.name = known.symbols;
    if (known.address != signal.name) signal.address = known.address;
    for (std::string text : {known.predefined, known.help, known.meaning}) {
      std::ranges::replace(text, '\n', ' ');  // a row of a table has one line
      if (!text.empty() && signal.words.find(text) == std::string::npos)
        signal.words += (signal.words.empty() ? "" : "; ") + text;
    }
    if (!known.symbols.empty() && known.symbols != signal.name) {
      signal.words += (signal.words.empty() ? "" : "; ") + ("also " + known.symbols);
    }
  }
}

void Collector::Sort() {
  std::vector<uint32_t> order(result_.signals.size()), place_of(order.size());
  for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [this](uint32_t i) {
    const Signal& signal = result_.signals[i];
    return std::tuple(owner_[i], signal.first, ~signal.last);
  });
  std::vector<Signal> sorted;
  std::vector<uint32_t> owners;
  for (uint32_t i = 0; i < order.size(); ++i) {
    place_of[order[i]] = i;
    sorted.push_back(std::move(result_.signals[order[i]]));
    owners.push_back(owner_[order[i]]);
  }
  result_.signals = std::move(sorted);
  owner_ = std::move(owners);
  for (std::vector<uint32_t>* table : {&result_.of_place, &result_.of_state}) {
    for (uint32_t& index : *table) {
      if (index != kNoSignal) index = place_of[index];
    }
  }
}

void Collector::Overlaps() {
  for (std::vector<Stretches>* side : {&read_, &written_}) std::ranges::for_each(*side, Merge);
  std::vector<Signal>& signals = result_.signals;
  for (uint32_t i = 0; i < signals.size(); ++i) {
    signals[i].read = Covers(read_[owner_[i]], signals[i].first, signals[i].last);
    signals[i].written = Covers(written_[owner_[i]], signals[i].first, signals[i].last);
    for (uint32_t j = i + 1; j < signals.size() && owner_[j] == owner_[i] && signals[j].first < signals[i].last; ++j) {
      if (signals[i].overlaps.size() < kMostOverlaps) signals[i].overlaps.push_back(j);
      if (signals[j].overlaps.size() < kMostOverlaps) signals[j].overlaps.push_back(i);
      if (signals[i].overlaps.size() >= kMostOverlaps && signals[j].overlaps.size() >= kMostOverlaps) break;
    }
  }
  for (uint32_t i = 0; i < program_.spaces.size(); ++i) {
    Stretches& used = result_.used[i];
    used = read_[i];
    used.insert(used.end(), written_[i].begin(), written_[i].end());
    Merge(used);
  }
}

}  // namespace

CrossReference MakeCrossReference(const ProgramInput& input) { return Collector(input).Run(); }

std::vector<ir::StatementId> Writers(const Signal& signal) {
  std::vector<ir::StatementId> writers;
  std::unordered_set<uint32_t> seen;
  for (const Occurrence& occurrence : signal.occurrences) {
    if (occurrence.use == Use::kRead || !seen.insert(occurrence.statement.index).second) continue;
    writers.push_back(occurrence.statement);
  }
  return writers;
}

}  // namespace plcxx::report
