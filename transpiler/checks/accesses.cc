#include "transpiler/checks/accesses.h"

#include <algorithm>

#include "transpiler/ir/builder.h"

namespace plcxx::checks {
namespace {

/// A step drives its instance when it is priced as the element itself and takes its input.
bool Drives(ir::OpKind op) {
  switch (ir::Info(op).cost) {
    case ir::CostClass::kTimer:
    case ir::CostClass::kPulse:
      return true;
    case ir::CostClass::kCounter:
      return op != ir::OpKind::kResetCounter;
    case ir::CostClass::kFree:
    case ir::CostClass::kLogic:
    case ir::CostClass::kArithmetic:
    case ir::CostClass::kDivide:
    case ir::CostClass::kTable:
    case ir::CostClass::kCompare:
    case ir::CostClass::kLoad:
    case ir::CostClass::kStore:
    case ir::CostClass::kBranch:
    case ir::CostClass::kCall:
    case ir::CostClass::kExpire:
      return false;
  }
  return false;
}

struct Walk {
  const ir::Program& program;
  PartAccesses& out;
  ir::StatementId statement = {};

  void Add(Access access) {
    access.statement = statement;
    out.accesses.push_back(access);
  }
  void Region(ir::RegionId region, uint32_t arm) {
    for (const ir::InstId id : program.regions[region].insts) {
      const ir::Inst& inst = program[id];
      switch (ir::Info(inst.op).shape) {
        case ir::Shape::kLoad:
        case ir::Shape::kStore: {
          const ir::PlaceId place(inst.payload);
          const bool load = inst.op == ir::OpKind::kLoad;
          Add({load ? AccessKind::kRead : AccessKind::kWrite, place, program.places[place].state, inst.range, arm});
          break;
        }
        case ir::Shape::kStep:
          Add({Drives(inst.op) ? AccessKind::kDrive : AccessKind::kTouch,
               {},
               ir::StateId(inst.payload),
               inst.range,
               arm,
               inst.op});
          break;
        case ir::Shape::kText:
          Add({AccessKind::kDrive, {}, ir::StateId(inst.payload), inst.range, arm, inst.op});
          break;
        case ir::Shape::kIf:
        case ir::Shape::kSwitch:
        case ir::Shape::kLoop: {
          uint32_t number = 0;
          for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) {
            out.arms.push_back({arm, id, number++});
            Region(owned, static_cast<uint32_t>(out.arms.size() - 1));
          }
          if (inst.op == ir::OpKind::kLoop) Add({AccessKind::kLoopEnd, {}, {}, inst.range, arm});
          break;
        }
        case ir::Shape::kBlock:
        case ir::Shape::kRepeat: {
          for (const ir::RegionId owned : ir::OwnedRegions(program, inst)) {
            out.arms.push_back({arm, id, 0});
            Region(owned, static_cast<uint32_t>(out.arms.size() - 1));
          }
          break;
        }
        case ir::Shape::kPure:
        case ir::Shape::kConst:
        case ir::Shape::kExit:
        case ir::Shape::kCall:
        case ir::Shape::kHostCall:
        case ir::Shape::kJump:
        case ir::Shape::kLabel:
          break;
        case ir::Shape::kStatement:
          statement = ir::StatementId(inst.payload);
          break;
      }
    }
  }
};

}  // namespace

bool PartAccesses::Encloses(uint32_t arm, uint32_t inner) const {
  while (inner != arm && inner != 0) inner = arms[inner].parent;
  return inner == arm;
}

bool PartAccesses::Exclusive(uint32_t left, uint32_t right) const {
  for (uint32_t l = left; l != 0; l = arms[l].parent) {
    for (uint32_t r = right; r != 0; r = arms[r].parent) {
      if (arms[l].branch == arms[r].branch) return arms[l].number != arms[r].number;
    }
  }
  return false;
}

std::vector<PartAccesses> CollectAccesses(const ir::Program& program) {
  std::vector<PartAccesses> parts;
  for (const ir::Routine& routine : program.routines) {
    if (routine.kind != ir::RoutineKind::kFast && routine.kind != ir::RoutineKind::kSlow) continue;
    PartAccesses& part = parts.emplace_back();
    part.part = routine.kind;
    part.slices = routine.slices;
    Walk walk{program, part};
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (region.valid()) walk.Region(region, 0);
    }
  }
  return parts;
}

BitNumbering::BitNumbering(const ir::Program& program) {
  for (const ir::Space& space : program.spaces) {
    base_.push_back(count_);
    count_ += space.bytes * 8;
  }
  for (const ir::StateInstance& state : program.states) {
    fields_.push_back(count_);
    count_ += static_cast<uint32_t>(ir::Info(state.kind).fields.size());
  }
}

BitSpan BitNumbering::Of(const ir::Place& place) const {
  if (place.is_field()) {
    const uint32_t first = fields_[place.state.index] + place.field;
    return {first, first + 1};
  }
  PLCXX_CHECK(place.space.valid());  // what a control keeps beside memory has no bits here
  const uint32_t first = base_[place.space.index] + place.offset * 8;
  if (place.indexed) return {base_[place.space.index] + place.low * 8, base_[place.space.index] + place.high * 8};
  if (place.type == ir::Type::kBit) return {first + place.bit, first + place.bit + 1};
  return {first, first + 8 * ir::Bytes(place.type)};
}

}  // namespace plcxx::checks
