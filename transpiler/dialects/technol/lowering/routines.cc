#include "transpiler/dialects/technol/lowering/routines.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/technol/analysis/resume_points.h"
#include "transpiler/dialects/technol/analysis/subprogram_groups.h"
#include "transpiler/dialects/technol/lowering/entries.h"

namespace plcxx::technol {

Routines::Routines(const Flow& flow, const Settings& settings)
    : tree_(flow.program()), flow_(flow), settings_(settings) {
  FindUnits();
  FindSubprograms();
  FindLeaving();
  FindStopping();
}

void Routines::FindUnits() {
  for (const Root& root : flow_.roots()) {
    Routine routine{.unit = root.unit};
    routine.instructions = InstructionsOf(flow_, root);
    FindSegments(flow_, routine);
    routine_of_unit_[root.unit.index] = static_cast<uint32_t>(routines_.size());
    routines_.push_back(std::move(routine));
  }
}

void Routines::FindSubprograms() {
  routine_of_subprogram_.resize(flow_.subprograms().size());
  for (SubprogramGroup& group : GroupSubprograms(flow_)) {
    for (const uint32_t k : group.subprograms) routine_of_subprogram_[k] = static_cast<uint32_t>(routines_.size());
    routines_.push_back({.unit = {},
                         .subprograms = std::move(group.subprograms),
                         .instructions = std::move(group.instructions),
                         .level = group.level});
  }
}

bool Routines::CanTrap(const Instruction& instruction) const {
  if (settings_.bounds != Bounds::kTrap) return false;
  for (uint32_t i = 0; i < instruction.operands.count; ++i) {
    const Operand& operand = tree_.OperandOf(instruction, i);
    if (operand.kind == OperandKind::kMemory && operand.address.index != Register::kNone) return true;
  }
  return false;
}

/// A jump back may be refused, which leaves all that has been called (6.4).
void Routines::FindLeaving() {
  for (bool changed = true; changed;) {
    changed = false;
    for (Routine& routine : routines_) {
      const bool leaves = routine.leaves, loops = routine.loops;
      for (const InstructionId id : routine.instructions) {
        const Instruction& instruction = tree_.instructions[id];
        routine.leaves |= CanTrap(instruction);
        flow_.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
          if (edge == Edge::kJump && to.index <= id.index) routine.loops = true;
        });
        if (instruction.op != Op::kCall) continue;
        routine.calls = true;
        const Routine& callee = CalleeOf(instruction);
        routine.leaves |= callee.leaves;
        routine.loops |= callee.loops;
      }
      routine.leaves |= routine.loops;
      changed |= leaves != routine.leaves || loops != routine.loops;
    }
  }
}

/// MECH_INIT, and with mech-clear=abort what clears the bit.
void Routines::FindStopping() {
  const auto add = [](std::vector<UnitId>& stops, UnitId mechanism) {
    const auto at = std::ranges::lower_bound(stops, mechanism);
    if (at != stops.end() && *at == mechanism) return false;
    stops.insert(at, mechanism);
    return true;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (Routine& routine : routines_) {
      for (const InstructionId id : routine.instructions) {
        const Instruction& instruction = tree_.instructions[id];
        if (instruction.op == Op::kCall) {
          const Routine& callee = CalleeOf(instruction);
          routine.stopped_by_callee |= routine.unit.valid() && callee.MayStop(routine.unit);
          if (routine.unit.valid()) continue;
          for (const UnitId mechanism : callee.stops) changed |= add(routine.stops, mechanism);
        }
        if (routine.unit.valid()) continue;
        if (const UnitId stopped = StoppedBy(instruction); stopped.valid()) changed |= add(routine.stops, stopped);
      }
    }
  }
}

UnitId Routines::StoppedBy(const Instruction& instruction) const {
  if (instruction.op == Op::kMechInit) return tree_.OperandOf(instruction, 0).mechanism;
  const bool writes = instruction.op == Op::kWr || instruction.op == Op::kFl || instruction.op == Op::kFl1 ||
                      instruction.op == Op::kFl0;
  if (settings_.mech_clear != MechClear::kAbort || !writes) return {};
  const Operand& bit = tree_.OperandOf(instruction, instruction.operands.count - 1);
  const bool sets = instruction.op != Op::kWr && tree_.OperandOf(instruction, 0).value != 0;
  return bit.is_activation_bit() && !sets ? bit.mechanism : UnitId();
}

const Routine* Routines::OfUnit(UnitId unit) const {
  const auto found = routine_of_unit_.find(unit.index);
  return found == routine_of_unit_.end() ? nullptr : &routines_[found->second];
}

const Routine* Routines::OfModule(ModuleKind kind) const {
  const UnitId unit = FindModule(tree_, kind);
  return unit.valid() ? OfUnit(unit) : nullptr;
}

}  // namespace plcxx::technol
