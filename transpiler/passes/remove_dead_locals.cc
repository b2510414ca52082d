#include "transpiler/passes/remove_dead_locals.h"

#include <algorithm>
#include <map>
#include <ranges>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"

namespace plcxx::passes {
namespace {

using ir::Inst;
using ir::InstId;
using ir::OpKind;
using ir::RegionId;

constexpr uint32_t kUntracked = ~0u;

/// A set of locals, in words: each branch copies and joins sets of all locals that the routine may meet. The shared
/// ones come first: of two sets of different size these are what both have.
class Live {
 public:
  explicit Live(uint32_t locals) : words_((locals + kBits - 1) / kBits) {}
  static Live All(uint32_t locals) {
    Live all(locals);
    all.words_.assign(all.words_.size(), ~uint64_t{0});
    return all;
  }
  bool Has(uint32_t local) const { return (words_[local / kBits] >> local % kBits & 1) != 0; }
  void Add(uint32_t local) { words_[local / kBits] |= uint64_t{1} << local % kBits; }
  void Remove(uint32_t local) { words_[local / kBits] &= ~(uint64_t{1} << local % kBits); }
  void Join(const Live& other) {
    const size_t common = std::min(words_.size(), other.words_.size());
    for (size_t i = 0; i < common; ++i) words_[i] |= other.words_[i];
  }
  void Intersect(const Live& other) {
    const size_t common = std::min(words_.size(), other.words_.size());
    for (size_t i = 0; i < common; ++i) words_[i] &= other.words_[i];
  }
  /// The first of them, as many as `Live(locals)` has room for.
  Live First(uint32_t locals) const {
    Live first(locals);
    first.Join(*this);
    return first;
  }
  bool operator==(const Live&) const = default;

  static constexpr uint32_t kBits = 64;

 private:
  std::vector<uint64_t> words_;
};

/// What a subroutine does to its caller's locals: of those that are shared.
struct Summary {
  Live reads;   // before it writes them
  Live passes;  // those that it may leave as they are
  Live after;   // those that some caller reads after a call
};

struct Analysis {
  ir::Program& program;
  std::vector<uint32_t> local_of;             // by PlaceId; kUntracked: not a local, or one that overlaps another
  uint32_t locals = 0;                        // that the routine may meet
  uint32_t shared = 0;                        // of these, by whole words of a set
  std::vector<uint32_t> own = {};             // how many more, by RoutineId
  bool alone = false;                         // calls are passed over
  std::vector<Summary> summaries;             // by RoutineId
  std::unordered_map<uint32_t, Live> behind;  // by InstId of an open block or loop: live where an Exit leads
  std::unordered_map<uint32_t, Live> head;    // by InstId of a loop: live where a Repeat leads, as far as is known
  bool collects = false;                      // what callers read after calls
  bool removes = false;
  std::vector<bool> dead = {};  // by InstId

  void FindLocals();
  void Divide();
  template <class Visit>
  void ForEachTouched(ir::RoutineId id, Visit&& visit) const;
  std::vector<ir::RoutineId> CalleesFirst() const;
  Live Routine(ir::RoutineId id, Live after);
  void Region(RegionId region, Live& live);
  void Instruction(InstId id, Live& live);
  void Read(ir::PlaceId place, Live& live) const;
  void Store(InstId id, Live& live);
  void Call(const Inst& inst, Live& live);
  void Switch(const Inst& inst, Live& live);
  void Loop(InstId id, Live& live);
  void Repeat(const Inst& inst, Live& live);
  void Sweep();
};

/// Places that are the same bytes are one local; places that overlap in another way are left alone.
void Analysis::FindLocals() {
  using Key = std::tuple<decltype(ir::Place::offset), decltype(ir::Place::bit), ir::Type>;
  local_of.assign(program.places.size(), kUntracked);
  std::vector<std::vector<uint32_t>> by_space(program.spaces.size());
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    const ir::Place& place = program.places[ir::PlaceId(i)];
    if (place.is_field() || program.spaces[place.space].lifetime != ir::Lifetime::kRoutine) continue;
    by_space[place.space.index].push_back(i);
  }
  // Parameters and results are read and written by calls; they are not this pass's business.
  std::vector<bool> fixed(program.places.size());
  for (const ir::Routine& routine : program.routines) {
    for (const ir::PlaceId place : routine.parameter_places) fixed[place.index] = true;
    if (routine.result_place.valid()) fixed[routine.result_place.index] = true;
  }
  for (const std::vector<uint32_t>& places : by_space) {
    if (std::ranges::any_of(places, [&](uint32_t i) { return program.places[ir::PlaceId(i)].indexed; })) continue;
    const auto key_of = [&](uint32_t i) {
      const ir::Place& place = program.places[ir::PlaceId(i)];
      return Key(place.offset, place.bit, place.type);
    };
    std::map<Key, bool> apart;  // by what one local would be
    for (const uint32_t i : places) apart.try_emplace(key_of(i), true).first->second &= !fixed[i];
    for (auto one = apart.begin(); one != apart.end(); ++one) {
      const auto& [offset, bit, type] = one->first;
      // What begins after this one cannot overlap it, nor can what follows.
      for (auto other = std::next(one); other != apart.end(); ++other) {
        const auto& [other_offset, other_bit, other_type] = other->first;
        if (other_offset >= offset + ir::Bytes(type)) break;
        if (type == ir::Type::kBit && other_type == ir::Type::kBit && bit != other_bit) continue;
        one->second = other->second = false;
      }
    }
    std::map<Key, uint32_t> numbers;
    for (const uint32_t i : places) {
      if (!apart[key_of(i)]) continue;
      const auto [number, added] = numbers.emplace(key_of(i), locals);
      if (added) ++locals;
      local_of[i] = number->second;
    }
  }
}

/// visit(local) for each access in the routine.
template <class Visit>
void Analysis::ForEachTouched(ir::RoutineId id, Visit&& visit) const {
  const auto touch = [&](uint32_t place) {
    if (place < local_of.size() && local_of[place] != kUntracked) visit(local_of[place]);
  };
  const ir::Routine& routine = program.routines[id];
  for (const RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
    if (!region.valid()) continue;
    ir::ForEachInst(program, region, [&](InstId at) {
      const Inst& inst = program[at];
      const ir::Shape shape = ir::Info(inst.op).shape;
      if (shape == ir::Shape::kLoad || shape == ir::Shape::kStore) touch(inst.payload);
      if (shape == ir::Shape::kLoop) touch(program.loops[ir::LoopId(inst.payload)].budget.index);
    });
  }
}

/// Most locals are of one routine alone, which writes them before it reads them: no caller and no callee sees anything
/// of them. They are in the sets of this routine only, and those of all routines have the same numbers.
void Analysis::Divide() {
  constexpr uint32_t kNobody = ~0u, kSeveral = ~0u - 1;
  std::vector<uint32_t> user(locals, kNobody), number(locals);
  const auto routines = static_cast<uint32_t>(program.routines.size());
  for (uint32_t i = 0; i < routines; ++i) {
    ForEachTouched(ir::RoutineId(i), [&](uint32_t local) {
      if (user[local] != i) user[local] = user[local] == kNobody ? i : kSeveral;
    });
  }
  const std::vector<uint32_t> all = std::exchange(local_of, {});
  const auto renumber = [&](auto is_wanted) {
    local_of.assign(all.size(), kUntracked);
    for (size_t place = 0; place < all.size(); ++place) {
      if (all[place] != kUntracked && is_wanted(all[place])) local_of[place] = number[all[place]];
    }
  };
  const auto count_own = [&] {
    own.assign(routines, 0);
    for (uint32_t local = 0; local < user.size(); ++local) {
      if (user[local] < routines) number[local] = own[user[local]]++;
    }
  };
  // Who is read before it is written, when only its own routine is looked at, is not forgotten between two calls.
  count_own();
  renumber([&](uint32_t local) { return user[local] < routines; });
  std::vector<std::vector<uint32_t>> of_routine(routines);
  for (uint32_t local = 0; local < user.size(); ++local) {
    if (user[local] < routines) of_routine[user[local]].push_back(local);
  }
  alone = true;
  for (uint32_t i = 0; i < routines; ++i) {
    locals = own[i];
    if (locals == 0) continue;
    const Live before = Routine(ir::RoutineId(i), Live(locals));
    for (const uint32_t local : of_routine[i]) {
      if (before.Has(number[local])) user[local] = kSeveral;
    }
  }
  alone = false;
  shared = 0;
  count_own();
  for (uint32_t local = 0; local < user.size(); ++local) {
    if (user[local] == kSeveral) number[local] = shared++;
  }
  shared = (shared + Live::kBits - 1) / Live::kBits * Live::kBits;
  for (uint32_t local = 0; local < user.size(); ++local) {
    if (user[local] < routines) number[local] += shared;
  }
  renumber([&](uint32_t local) { return user[local] != kNobody; });
}

std::vector<ir::RoutineId> Analysis::CalleesFirst() const {
  std::vector<ir::RoutineId> order;
  std::vector<bool> seen(program.routines.size());
  const auto visit = [&](auto& self, ir::RoutineId id) -> void {
    if (seen[id.index]) return;
    seen[id.index] = true;
    const ir::Routine& routine = program.routines[id];
    for (const RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      ir::ForEachInst(program, region, [&](InstId inst) {
        if (program[inst].op == OpKind::kCall) self(self, program.calls[ir::CallId(program[inst].payload)].routine);
      });
    }
    order.push_back(id);
  };
  for (uint32_t i = 0; i < program.routines.size(); ++i) visit(visit, ir::RoutineId(i));
  return order;
}

void Analysis::Read(ir::PlaceId place, Live& live) const {
  if (place.valid() && local_of[place.index] != kUntracked) live.Add(local_of[place.index]);
}

void Analysis::Store(InstId id, Live& live) {
  const uint32_t local = local_of[program[id].payload];
  if (local == kUntracked) return;
  if (removes && !live.Has(local)) dead[id.index] = true;
  live.Remove(local);
}

void Analysis::Call(const Inst& inst, Live& live) {
  if (alone) return;
  Summary& callee = summaries[program.calls[ir::CallId(inst.payload)].routine.index];
  // A partition that the schedule calls has locals of its own.
  if (program.routines[program.calls[ir::CallId(inst.payload)].routine].kind != ir::RoutineKind::kSubroutine) return;
  if (collects) callee.after.Join(live);
  live.Intersect(callee.passes);
  live.Join(callee.reads);
}

void Analysis::Switch(const Inst& inst, Live& live) {
  const std::vector<ir::SwitchCase>& cases = program.switches[ir::SwitchId(inst.payload)].cases;
  Live joined(locals), next = live;
  bool has_default = false;
  for (const ir::SwitchCase& arm : std::views::reverse(cases)) {
    Live before = arm.falls_through ? next : live;
    Region(arm.region, before);
    joined.Join(before);
    next = std::move(before);
    has_default = has_default || arm.values.empty();
  }
  if (!has_default) joined.Join(live);
  live = std::move(joined);
}

void Analysis::Loop(InstId id, Live& live) {
  const ir::Loop loop = program.loops[ir::LoopId(program[id].payload)];
  const bool remove = std::exchange(removes, false);
  const Live after = live;
  Live exhausted(locals);
  if (loop.exhausted.valid()) {
    exhausted = after;
    removes = remove;
    Region(loop.exhausted, exhausted);
    removes = false;
  }
  behind.insert_or_assign(id.index, after);
  // A loop in another one goes on from where the other's last round left it, for what is live only grows: with each
  // from nothing the rounds of a nest would be a power of its depth.
  head.try_emplace(id.index, locals);
  // One round, from what is live at the head of the next one.
  const auto round = [&] {
    Live before = loop.kind == ir::LoopBound::kBudget ? after : head.at(id.index);
    Region(loop.step, before);
    Region(loop.body, before);
    before.Join(exhausted);
    if (loop.condition.valid()) {
      before.Join(after);
      Region(loop.condition, before);
    }
    return before;
  };
  for (;;) {
    Live before = round();
    before.Join(head.at(id.index));
    if (before == head.at(id.index)) break;
    head.insert_or_assign(id.index, std::move(before));
  }
  removes = remove;
  live = removes ? round() : head.at(id.index);
  live.Join(head.at(id.index));
  behind.erase(id.index);
}

void Analysis::Repeat(const Inst& inst, Live& live) {
  Live refused = live;
  Region(RegionId(inst.b), refused);
  if (!ir::ValueId(inst.a).valid()) live = Live(locals);
  live.Join(refused);
  live.Join(head.at(inst.payload));
  Read(program.loops[ir::LoopId(program[InstId(inst.payload)].payload)].budget, live);
}

void Analysis::Instruction(InstId id, Live& live) {
  const Inst inst = program[id];
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kLoad:
      Read(ir::PlaceId(inst.payload), live);
      break;
    case ir::Shape::kStore:
      Store(id, live);
      break;
    case ir::Shape::kCall:
      Call(inst, live);
      break;
    case ir::Shape::kIf: {
      Live otherwise = live;
      Region(RegionId(inst.c), otherwise);
      Region(RegionId(inst.b), live);
      live.Join(otherwise);
      break;
    }
    case ir::Shape::kSwitch:
      Switch(inst, live);
      break;
    case ir::Shape::kLoop:
      Loop(id, live);
      break;
    case ir::Shape::kBlock:
      behind.insert_or_assign(id.index, live);
      Region(RegionId(inst.a), live);
      behind.erase(id.index);
      break;
    case ir::Shape::kExit:
      if (!ir::ValueId(inst.a).valid()) live = Live(locals);
      live.Join(behind.at(inst.payload));
      break;
    case ir::Shape::kRepeat:
      Repeat(inst, live);
      break;
    case ir::Shape::kHostCall:  // writes its second result, or leaves the place as it is
    case ir::Shape::kPure:
    case ir::Shape::kStep:
    case ir::Shape::kConst:
    case ir::Shape::kText:
    case ir::Shape::kStatement:
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      break;
  }
}

void Analysis::Region(RegionId region, Live& live) {
  if (!region.valid()) return;
  for (const InstId id : std::views::reverse(program.regions[region].insts)) Instruction(id, live);
}

/// What is live before the routine, when `after` is behind it.
Live Analysis::Routine(ir::RoutineId id, Live after) {
  const ir::Routine routine = program.routines[id];
  head.clear();
  for (const RegionId region : {routine.epilogue, routine.body, routine.prologue}) Region(region, after);
  return after;
}

void Analysis::Sweep() {
  for (ir::Region& region : program.regions) {
    std::erase_if(region.insts, [this](InstId id) { return dead[id.index]; });
  }
  for (uint32_t i = 0; i < dead.size(); ++i) {
    if (dead[i]) ir::Forget(program[InstId(i)]);
  }
}

}  // namespace

void RemoveDeadLocals(ir::Program& program) {
  Analysis analysis{.program = program};
  analysis.FindLocals();
  if (analysis.locals == 0) return;
  analysis.Divide();
  const Live none(analysis.shared);
  analysis.summaries.assign(program.routines.size(),
                            {.reads = none, .passes = Live::All(analysis.shared), .after = none});
  const std::vector<ir::RoutineId> order = analysis.CalleesFirst();
  for (const ir::RoutineId id : order) {
    analysis.locals = analysis.shared + analysis.own[id.index];
    const Live reads = analysis.Routine(id, Live(analysis.locals));
    const Live passes = analysis.Routine(id, Live::All(analysis.locals));
    analysis.summaries[id.index].reads = reads.First(analysis.shared);
    analysis.summaries[id.index].passes = passes.First(analysis.shared);
  }
  analysis.collects = true;
  analysis.removes = true;
  analysis.dead.assign(program.insts.size(), false);
  for (const ir::RoutineId id : std::views::reverse(order)) {
    analysis.locals = analysis.shared + analysis.own[id.index];
    const bool shares = program.routines[id].kind == ir::RoutineKind::kSubroutine;
    Live after(analysis.locals);
    if (shares) after.Join(analysis.summaries[id.index].after);
    analysis.Routine(id, std::move(after));
  }
  analysis.Sweep();
}

}  // namespace plcxx::passes
