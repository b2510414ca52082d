// Routines, values and places; specialize_control.cc has the regions.

#include "transpiler/fleet/specialize.h"

#include <algorithm>

#include "transpiler/fleet/evaluate.h"
#include "transpiler/fleet/same_everywhere.h"
#include "transpiler/fleet/specializer.h"
#include "transpiler/ir/accesses.h"
#include "transpiler/ir/builder.h"
#include "transpiler/ir/uses.h"
#include "transpiler/sim/place_access.h"
#include "transpiler/support/check.h"

namespace plcxx::fleet {
namespace {

constexpr size_t kMostCopies = 200;

/// The bits of a space that a place has, half open.
struct Stretch {
  uint64_t begin = 0, end = 0;
  uint32_t place = 0;
};

Stretch StretchOf(const sim::PlaceAccess& access, uint32_t place) {
  if (access.indexed) return {uint64_t{access.low} * 8, uint64_t{access.high} * 8, place};
  if (access.kind == sim::AccessKind::kBit)
    return {uint64_t{access.offset} * 8 + access.bit, uint64_t{access.offset} * 8 + access.bit + 1, place};
  return {uint64_t{access.offset} * 8, uint64_t{access.offset + access.bytes} * 8, place};
}

}  // namespace

ir::Program Specialize(const ir::Program& program) {
  ir::Program specialized = program;
  Specializer(specialized).Run();
  return specialized;
}

Specializer::Specializer(ir::Program& program)
    : program_(program),
      walked_(program.routines.size(), false),
      now_(program.insts.size()),
      followed_(program.places.size(), false) {
  for (const ir::Routine& routine : program.routines)
    sources_.push_back({routine.prologue, routine.body, routine.epilogue});
}

void Specializer::Run() {
  if (HasRecursion()) return;
  FindFollowed();
  const ir::Schedule& schedule = program_.schedule;
  for (const ir::RoutineId id : {schedule.init, schedule.period, schedule.fast_only, schedule.elapse}) {
    if (id.valid()) WalkOnce(id);
  }
  for (uint32_t r = 0; r < program_.routines.size(); ++r) {  // only copies of it are called, or nobody calls it
    ir::Routine& routine = program_.routines[ir::RoutineId(r)];
    if (!walked_[r]) routine.prologue = routine.body = routine.epilogue = ir::RegionId();
  }
  RemoveUnread();
}

bool Specializer::HasRecursion() const {
  // By how many calls deep a routine is at most; deeper than there are routines is a circle.
  std::vector<size_t> depth(sources_.size(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (uint32_t r = 0; r < sources_.size(); ++r) {
      for (const ir::RegionId region : sources_[r]) {
        ir::ForEachInst(program_, region, [&](ir::InstId id) {
          if (program_[id].op != ir::OpKind::kCall) return;
          size_t& callee = depth[program_.calls[ir::CallId(program_[id].payload)].routine.index];
          if (callee > depth[r]) return;
          callee = depth[r] + 1;
          changed = true;
        });
      }
    }
    if (std::ranges::any_of(depth, [&](size_t one) { return one > sources_.size(); })) return true;
  }
  return false;
}

/// Named locals whose bits no other place has.
void Specializer::FindFollowed() {
  std::map<uint32_t, std::vector<Stretch>> stretches;  // by space
  for (uint32_t p = 0; p < program_.places.size(); ++p) {
    const ir::Place& place = program_.places[ir::PlaceId(p)];
    const sim::PlaceAccess access = sim::AccessTo(program_, place);
    if (access.kind == sim::AccessKind::kAbsent || access.kind == sim::AccessKind::kField) continue;
    const ir::Space& space = program_.spaces[place.space];
    if (space.lifetime != ir::Lifetime::kRoutine || !space.own) continue;
    followed_[p] = !access.indexed && IsWhole(place.type);
    stretches[access.owner].push_back(StretchOf(access, p));
  }
  for (auto& [space, all] : stretches) {
    std::ranges::sort(all, {}, &Stretch::begin);
    Stretch furthest;
    for (const Stretch& one : all) {
      if (one.begin < furthest.end) followed_[one.place] = followed_[furthest.place] = false;
      if (one.end > furthest.end) furthest = one;
    }
  }
}

void Specializer::WalkOnce(ir::RoutineId id) {
  if (walked_[id.index]) return;
  WalkRoutine(id, sources_[id.index], {});
}

void Specializer::WalkRoutine(ir::RoutineId id, const Regions& regions, const Known& arguments) {
  walked_[id.index] = true;
  const ir::RegionId out = out_;
  const uint32_t depth = depth_;
  Regions made;
  for (size_t i = 0; i < regions.size(); ++i) {
    if (!regions[i].valid()) continue;
    // A sliced routine's parts may be executed one by one.
    const bool only_body = !regions[0].valid() && !regions[2].valid();
    Known known = only_body ? arguments : Known();
    depth_ = 0;
    made[i] = WalkApart(regions[i], known).region;
  }
  out_ = out;
  depth_ = depth;
  ir::Routine& routine = program_.routines[id];
  routine.prologue = made[0];
  routine.body = made[1];
  routine.epilogue = made[2];
}

ir::RoutineId Specializer::CopyFor(ir::RoutineId routine, const Arguments& arguments) {
  const auto key = std::pair(routine.index, arguments);
  if (const auto found = copies_.find(key); found != copies_.end()) return found->second;
  if (copies_.size() >= kMostCopies) {
    WalkOnce(routine);
    return routine;
  }
  const ir::RoutineId copy = program_.routines.Add(ir::Routine(program_.routines[routine]));
  copies_.emplace(key, copy);
  walked_.push_back(true);
  Known known;
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i]) known[program_.routines[routine].parameter_places[i].index] = *arguments[i];
  }
  WalkRoutine(copy, sources_[routine.index], known);
  return copy;
}

ir::InstId Specializer::Write(const ir::Inst& inst) {
  const ir::InstId id = program_.insts.Add(ir::Inst(inst));
  program_.regions[out_].insts.push_back(id);
  ++written_;
  return id;
}

void Specializer::WriteConstant(ir::InstId id, const ir::Inst& inst, uint64_t value) {
  constexpr uint32_t kDecimal = 10;
  now_[id.index] = Write({.op = ir::OpKind::kConst,
                          .type = inst.type,
                          .range = inst.range,
                          .a = static_cast<uint32_t>(value),
                          .b = static_cast<uint32_t>(value >> 32),
                          .c = kDecimal})
                       .index;
}

void Specializer::Map(ir::Inst& inst) {
  ir::ForEachUse(program_, inst, [this](uint32_t& word) { word = now_[word]; });
}

std::optional<uint64_t> Specializer::Constant(uint32_t value) const {
  if (!ir::ValueId(value).valid()) return std::nullopt;
  const ir::Inst& inst = program_[ir::ValueId(value)];
  if (inst.op != ir::OpKind::kConst) return std::nullopt;
  return ir::ConstantValue(inst);
}

void Specializer::WalkPure(ir::InstId id, ir::Inst inst) {
  Map(inst);
  std::array<uint64_t, 3> operands{};
  bool is_constant = IsWhole(inst.type);
  for (int i = 0; i < ir::Info(inst.op).operand_count; ++i) {
    const uint32_t word = i == 0 ? inst.a : i == 1 ? inst.b : inst.c;
    const std::optional<uint64_t> value = Constant(word);
    is_constant = is_constant && value && IsWhole(program_[ir::ValueId(word)].type);
    operands[static_cast<size_t>(i)] = value.value_or(0);
  }
  if (is_constant) return WriteConstant(id, inst, ValueOf(inst.op, operands));
  now_[id.index] = Write(inst).index;
}

std::optional<ir::PlaceId> Specializer::ElementAt(ir::PlaceId id, uint64_t index) {
  const auto key = std::pair(id.index, static_cast<uint32_t>(index));
  if (const auto found = elements_.find(key); found != elements_.end()) return found->second;
  ir::Place place = program_.places[id];
  const sim::PlaceAccess access = sim::AccessTo(program_, place);
  uint32_t offset = 0;
  std::optional<ir::PlaceId> element;
  if (access.kind != sim::AccessKind::kAbsent && sim::ElementOffset(access, index, offset)) {
    place.indexed = false;
    place.offset = offset;
    element = program_.places.Add(std::move(place));
  }
  elements_.emplace(key, element);
  return element;
}

void Specializer::WalkLoad(ir::InstId id, ir::Inst inst, const Known& known) {
  Map(inst);
  if (const std::optional<uint64_t> index = Constant(inst.a); index && IsWhole(inst.type)) {
    const std::optional<ir::PlaceId> element = ElementAt(ir::PlaceId(inst.payload), *index);
    if (!element) return WriteConstant(id, inst, 0);
    inst.payload = element->index;
    inst.a = ir::ValueId().index;
  }
  if (const auto value = known.find(inst.payload); value != known.end()) return WriteConstant(id, inst, value->second);
  now_[id.index] = Write(inst).index;
}

void Specializer::WalkStore(ir::Inst inst, Known& known) {
  Map(inst);
  if (const std::optional<uint64_t> index = Constant(inst.b)) {
    const std::optional<ir::PlaceId> element = ElementAt(ir::PlaceId(inst.payload), *index);
    if (!element) return;
    inst.payload = element->index;
    inst.b = ir::ValueId().index;
  }
  if (IsFollowed(ir::PlaceId(inst.payload))) {
    known.erase(inst.payload);
    if (const std::optional<uint64_t> value = Constant(inst.a)) known[inst.payload] = *value;
  }
  Write(inst);
}

ir::CallId Specializer::CallWith(const ir::Call& call) {
  ir::Call made = call;
  for (ir::ValueId& argument : made.arguments) argument = ir::ValueId(now_[argument.index]);
  return program_.calls.Add(std::move(made));
}

void Specializer::WalkCall(ir::InstId id, ir::Inst inst) {
  const ir::CallId made = CallWith(program_.calls[ir::CallId(inst.payload)]);
  const ir::RoutineId callee = program_.calls[made].routine;
  Arguments arguments;
  for (const ir::PlaceId place : program_.routines[callee].parameter_places) {
    const size_t i = arguments.size();
    const auto& given = program_.calls[made].arguments;
    arguments.push_back(i < given.size() && IsFollowed(place) ? Constant(given[i].index) : std::nullopt);
  }
  if (std::ranges::any_of(arguments, [](const auto& one) { return one.has_value(); })) {
    const ir::RoutineId copy = CopyFor(callee, arguments);
    program_.calls[made].routine = copy;
  } else {
    WalkOnce(callee);
  }
  inst.payload = made.index;
  now_[id.index] = Write(inst).index;
}

void Specializer::WalkHostCall(ir::InstId id, ir::Inst inst, Known& known) {
  inst.payload = CallWith(program_.calls[ir::CallId(inst.payload)]).index;
  if (const ir::PlaceId out = program_.calls[ir::CallId(inst.payload)].out; out.valid()) known.erase(out.index);
  now_[id.index] = Write(inst).index;
}

/// Stores into named locals that no load is left of.
void Specializer::RemoveUnread() {
  std::vector<bool> read(program_.places.size(), false);
  for (const ir::Routine& routine : program_.routines) {
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      ir::ForEachInst(program_, region, [&](ir::InstId id) {
        ir::ForEachAccess(
            program_, program_[id],
            [&](ir::PlaceId place, ir::Access access) {
              if (access != ir::Access::kWrite) read[place.index] = true;
            },
            [](ir::StateId) {});
      });
    }
    if (routine.result_place.valid()) read[routine.result_place.index] = true;
  }
  for (ir::Region& region : program_.regions) {
    std::erase_if(region.insts, [&](ir::InstId id) {
      const ir::Inst& inst = program_[id];
      return ir::Info(inst.op).shape == ir::Shape::kStore && IsFollowed(ir::PlaceId(inst.payload)) &&
             !read[inst.payload];
    });
  }
}

}  // namespace plcxx::fleet
