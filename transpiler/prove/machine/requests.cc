#include "transpiler/prove/machine/requests.h"

#include "transpiler/ir/builder.h"
#include "transpiler/ir/op.h"

namespace plcxx::prove::machine {
namespace {

/// Looks for `if REQUEST { answer = polled(); if answer == ... { REQUEST = 0 } }`.
class RequestWalk {
 public:
  RequestWalk(const Version& version, std::vector<bool>& cells)
      : version_(version), program_(*version.program), cells_(cells) {}

  void Region(ir::RegionId region) {
    if (!region.valid()) return;
    for (const ir::InstId id : program_.regions[region].insts) Inst(program_[id]);
  }

 private:
  void Inst(const ir::Inst& inst) {
    switch (ir::Info(inst.op).shape) {
      case ir::Shape::kIf: {
        const ir::Inst& condition = program_[ir::InstId(inst.a)];
        const bool asks_bit = IsBit(condition, ir::Shape::kLoad);
        const std::vector<execute::CellId> answered = answered_;
        if (asks_bit) asked_.push_back(CellOf(condition));
        Region(ir::RegionId(inst.b));
        if (asks_bit) asked_.pop_back();
        answered_ = answered;  // after the branch nobody knows whether the host was asked
        Region(ir::RegionId(inst.c));
        break;
      }
      case ir::Shape::kHostCall: {
        const ir::HostFunction& host = program_.host_functions[program_.calls[ir::CallId(inst.payload)].host];
        if (host.polled && host.result != ir::Type::kNone) answered_ = asked_;
        break;
      }
      case ir::Shape::kStore: {
        if (!IsBit(inst, ir::Shape::kStore)) break;
        const ir::Inst& value = program_[ir::InstId(inst.a)];
        const bool clears = ir::Info(value.op).shape == ir::Shape::kConst && ir::ConstantValue(value) == 0;
        const execute::CellId cell = CellOf(inst);
        for (const execute::CellId asked : answered_) {
          if (clears && asked == cell) cells_[cell.index] = true;
        }
        break;
      }
      case ir::Shape::kBlock:
        Region(ir::RegionId(inst.a));
        break;
      case ir::Shape::kSwitch:
      case ir::Shape::kLoop:
      case ir::Shape::kRepeat:
        for (const ir::RegionId region : ir::OwnedRegions(program_, inst)) {
          const std::vector<execute::CellId> answered = answered_;
          Region(region);
          answered_ = answered;  // the next arm, or what follows, may come without this one
        }
        break;
      case ir::Shape::kPure:
      case ir::Shape::kStep:
      case ir::Shape::kText:
      case ir::Shape::kConst:
      case ir::Shape::kStatement:
      case ir::Shape::kLoad:
      case ir::Shape::kExit:
      case ir::Shape::kCall:
      case ir::Shape::kJump:
      case ir::Shape::kLabel:
        break;
    }
  }

  bool IsBit(const ir::Inst& inst, ir::Shape shape) const {
    if (ir::Info(inst.op).shape != shape) return false;
    const ir::Place& place = program_.places[ir::PlaceId(inst.payload)];
    return !place.is_field() && !place.indexed && place.type == ir::Type::kBit && execute::IsInside(program_, place);
  }
  execute::CellId CellOf(const ir::Inst& inst) const {
    const ir::Place& place = program_.places[ir::PlaceId(inst.payload)];
    return version_.cells.OfBit(place.space, place.offset, place.bit);
  }

  const Version& version_;
  const ir::Program& program_;
  std::vector<bool>& cells_;
  std::vector<execute::CellId> asked_, answered_;  // bits that are 1 here; that were when the host was asked
};

}  // namespace

std::vector<bool> RequestCells(const Version& version) {
  std::vector<bool> cells(version.cells.count);
  for (const ir::Routine& routine : version.program->routines) {
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue})
      RequestWalk(version, cells).Region(region);
  }
  const Uses uses = UsesOf(version);
  for (uint32_t i = 0; i < version.cells.count; ++i) {
    const bool is_cleared = WhatControlWrites(version, execute::CellId(i)) == execute::ControlWrite::kClears;
    if (is_cleared && uses.writes[i]) cells[i] = true;
  }
  return cells;
}

}  // namespace plcxx::prove::machine
