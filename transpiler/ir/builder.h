// Builds IR: appends instructions to the current region of a program.
//
// In: operands as ValueIds, a range for each instruction. Out: ValueIds. Types are checked at once (PLCXX_CHECK):
// a wrong type here is a fault of a lowering, never of the source program. Not its job: verification as a whole.
#pragma once

#include <initializer_list>
#include <string_view>

#include "transpiler/ir/program.h"

namespace plcxx::ir {

class Builder {
 public:
  explicit Builder(Program& program) : program_(program) {}

  Program& program() { return program_; }
  /// All that follows goes to the end of `region`.
  void SetRegion(RegionId region) { region_ = region; }
  RegionId region() const { return region_; }
  RegionId NewRegion() { return program_.regions.Add({}); }
  /// The range of all that follows, until the next call.
  void SetRange(source::Range range) { range_ = range; }
  source::Range range() const { return range_; }

  /// `base` is how the source spells it (10 or 16), so that generated code can spell it likewise.
  ValueId Constant(Type type, uint64_t value, uint32_t base = 10);
  ValueId Bit(uint64_t value) { return Constant(Type::kBit, value & 1); }
  /// The value of an erroneous expression: a diagnostic has been given.
  ValueId Poison(Type type);
  ValueId Pure(OpKind op, std::initializer_list<ValueId> operands);
  ValueId Load(PlaceId place, ValueId index = {});
  void Store(PlaceId place, ValueId value, ValueId index = {});
  /// Advances `state`; the result is none-typed for operations without one.
  ValueId Step(OpKind op, StateId state, std::initializer_list<ValueId> operands);
  void UpdateText(StateId flag, StateId inbox, TextId text);
  void Statement(StatementId statement);
  /// The arms are regions made by NewRegion; `otherwise` may be none.
  InstId If(ValueId condition, RegionId then, RegionId otherwise = {});
  InstId SwitchOn(ValueId selector, Switch cases);
  InstId LoopWith(Loop loop);
  InstId Block(RegionId body);
  void Exit(InstId block, ValueId condition = {});
  void Repeat(InstId loop, ValueId condition, RegionId refused);
  ValueId CallRoutine(RoutineId routine, std::vector<ValueId> arguments);
  /// `out`: the place for the second result of a function that gives one.
  ValueId CallHost(HostFunctionId function, std::vector<ValueId> arguments, PlaceId out = {});
  void Jump(uint32_t label, ValueId condition = {});
  /// To a label that stands above: at most as often as the i32 place `budget` says; then `refused` runs instead.
  void JumpBack(uint32_t label, ValueId condition, PlaceId budget, RegionId refused);
  void Label(uint32_t label);

 private:
  InstId Append(Inst inst);

  Program& program_;
  RegionId region_;
  source::Range range_;
};

/// Calls `visit(InstId)` for every instruction of `region` and the regions nested in it, in program order.
template <class Visit>
void ForEachInst(const Program& program, RegionId region, Visit&& visit);
/// The regions that an instruction owns, in program order (then, else; cases; condition, body, exhausted).
std::vector<RegionId> OwnedRegions(const Program& program, const Inst& inst);
/// The values that an instruction uses, in order.
std::vector<ValueId> UsedValues(const Program& program, const Inst& inst);

template <class Visit>
void ForEachInst(const Program& program, RegionId region, Visit&& visit) {
  if (!region.valid()) return;
  for (const InstId id : program.regions[region].insts) {
    visit(id);
    const Inst& inst = program[id];
    if (Info(inst.op).effect == Effect::kControl) {
      for (const RegionId owned : OwnedRegions(program, inst)) ForEachInst(program, owned, visit);
    }
  }
}

}  // namespace plcxx::ir
