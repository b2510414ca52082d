#include "transpiler/dialects/technol/lowering/lowering.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/technol/lowering/internal.h"
#include "transpiler/dialects/technol/subprogram_groups.h"

namespace plcxx::technol {
namespace {

Memory::Sizes SizesOf(const Program& tree) {
  Memory::Sizes sizes{.user = static_cast<uint32_t>(tree.user_data.size()), .mechanisms = 0, .steps = 1};
  for (const Unit& unit : tree.units) {
    if (unit.kind == UnitKind::kMechanism) ++sizes.mechanisms;
    sizes.steps += 2 * (1 + unit.timers);
  }
  return sizes;
}

}  // namespace

Lowering::Lowering(const Program& tree, const Flow& flow, const Settings& settings,
                   const source::SourceManager& sources)
    : tree_(tree), flow_(flow), settings_(settings), sources_(sources), memory_(program_, SizesOf(tree)) {}

void Lowering::InitialData() {
  const auto initial = [&](Area area, auto&& bytes) {
    for (uint32_t i = 0; i < bytes.size(); ++i) {
      if (bytes[i] != 0) program_.spaces[memory_[area]].initial.push_back({.offset = i, .value = bytes[i]});
    }
  };
  if (!tree_.user_data.empty()) initial(Area::kUser, tree_.user_data);
  initial(Area::kTabTechnol, tree_.table ? ImageOf(*tree_.table) : EmptyImage());
}

/// A register whose upper half nobody reads has 16 bits.
void Lowering::FindWideRegisters() {
  for (uint32_t i = 0; i < tree_.instructions.size(); ++i) {
    const InstructionId id(i);
    if (!flow_.IsReached(id)) continue;
    const uint32_t width = flow_.WidthBefore(id) == 0 ? 16 : flow_.WidthBefore(id);
    const Resources reads = EffectsOf(tree_, tree_.instructions[id], width).reads;
    for (const Register reg :
         {Register::kEax, Register::kEbx, Register::kEcx, Register::kEdx, Register::kEsi, Register::kEdi}) {
      const Resources upper = PartsOf(reg) & ~(PartsOf(reg) >> 1) & ~(PartsOf(reg) >> 2);
      if ((reads & upper) != 0) registers_.MakeWide(reg);
    }
  }
}

void Lowering::FindEntries(Body& body) const {
  std::vector<InstructionId>& entries = body.entries;
  const auto add = [&](InstructionId id) {
    if (id == body.instructions.front()) return;  // step 0
    const auto at = std::lower_bound(entries.begin(), entries.end(), id);
    if (at == entries.end() || *at != id) entries.insert(at, id);
  };
  for (const InstructionId id : body.instructions) {
    if (IsWait(tree_.instructions[id].op)) add(flow_.ResumeOf(id));
  }
  // Each one more may stand between another jump and its label.
  for (size_t count = 0; count != entries.size();) {
    count = entries.size();
    for (const InstructionId id : body.instructions) {
      flow_.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
        if (edge != Edge::kJump || to > id || body.StretchOf(to) == body.StretchOf(id)) return;
        body.goes_back = true;
        add(to);
      });
    }
  }
}

void Lowering::FindStretches(Body& body) const {
  FindEntries(body);
  if (body.entries.empty()) return;
  for (const InstructionId id : body.instructions) {
    bool crosses = false;
    flow_.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
      if (edge != Edge::kJump || to <= id || body.StretchOf(to) == body.StretchOf(id)) return;
      const bool to_end_of_own = body.StretchOf(to) == body.StretchOf(id) + 1 && body.IsEntry(to);
      const bool to_tail = to > body.entries.back();
      crosses |= !to_end_of_own && !to_tail;
      if (to_tail && (!body.tail || to < *body.tail)) body.tail = to;
    });
    if (crosses) return;
  }
  bool into_last_case = false;
  for (const InstructionId id : body.instructions) {
    flow_.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
      if (edge != Edge::kJump || !body.tail || id < *body.tail || to >= *body.tail) return;
      body.tail_goes_back = true;
      into_last_case |= to >= body.entries.back();  // which the tail, part of the same stretch, is outside of
    });
  }
  body.stretches_are_cases = !into_last_case;
  if (into_last_case) body.tail.reset();
}

/// Modules and mechanisms, then the subprograms.
void Lowering::FindBodies() {
  for (const Root& root : flow_.roots()) {
    Body body{.unit = root.unit};
    for (uint32_t i = root.at.index; i <= tree_.units[root.unit].end.index; ++i) {
      const Instruction& instruction = tree_.instructions[InstructionId(i)];
      const bool own = instruction.unit == root.unit || instruction.mechanism == root.unit;
      if (own && flow_.IsReached(InstructionId(i))) body.instructions.push_back(InstructionId(i));
    }
    FindStretches(body);
    body_of_unit_[root.unit.index] = static_cast<uint32_t>(bodies_.size());
    bodies_.push_back(std::move(body));
  }
  body_of_subprogram_.resize(flow_.subprograms().size());
  for (SubprogramGroup& group : GroupSubprograms(flow_)) {
    for (const uint32_t k : group.subprograms) body_of_subprogram_[k] = static_cast<uint32_t>(bodies_.size());
    bodies_.push_back({.unit = {},
                       .subprograms = std::move(group.subprograms),
                       .instructions = std::move(group.instructions),
                       .level = group.level});
  }
}

bool Lowering::CanLeave(const Instruction& instruction) const {
  if (settings_.bounds != Bounds::kTrap) return false;
  for (uint32_t i = 0; i < instruction.operands.count; ++i) {
    const Operand& operand = tree_.OperandOf(instruction, i);
    if (operand.kind == OperandKind::kMemory && operand.address.index != Register::kNone) return true;
  }
  return false;
}

/// A jump back may be refused, which leaves all that has been called (6.4).
void Lowering::FindLeaving() {
  for (bool changed = true; changed;) {
    changed = false;
    for (Body& body : bodies_) {
      const bool leaves = body.leaves, loops = body.loops;
      for (const InstructionId id : body.instructions) {
        const Instruction& instruction = tree_.instructions[id];
        body.leaves |= CanLeave(instruction);
        flow_.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
          if (edge == Edge::kJump && to.index <= id.index) body.loops = true;
        });
        if (instruction.op != Op::kCall) continue;
        body.calls = true;
        const Body& callee = bodies_[body_of_subprogram_[*flow_.CalleeOf(instruction)]];
        body.leaves |= callee.leaves;
        body.loops |= callee.loops;
      }
      body.leaves |= body.loops;
      changed |= leaves != body.leaves || loops != body.loops;
    }
  }
}

/// MECH_INIT, and with mech-clear=abort what clears the bit.
void Lowering::FindStopping() {
  const auto add = [](std::vector<UnitId>& stops, UnitId mechanism) {
    const auto at = std::ranges::lower_bound(stops, mechanism);
    if (at != stops.end() && *at == mechanism) return false;
    stops.insert(at, mechanism);
    return true;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (Body& body : bodies_) {
      for (const InstructionId id : body.instructions) {
        const Instruction& instruction = tree_.instructions[id];
        if (instruction.op == Op::kCall) {
          const Body& callee = bodies_[body_of_subprogram_[*flow_.CalleeOf(instruction)]];
          body.stopped_by_callee |= body.unit.valid() && MayStop(callee, body.unit);
          if (body.unit.valid()) continue;
          for (const UnitId mechanism : callee.stops) changed |= add(body.stops, mechanism);
        }
        if (body.unit.valid()) continue;
        if (const UnitId stopped = StoppedBy(instruction); stopped.valid()) changed |= add(body.stops, stopped);
      }
    }
  }
}

UnitId Lowering::StoppedBy(const Instruction& instruction) const {
  if (instruction.op == Op::kMechInit) return tree_.OperandOf(instruction, 0).mechanism;
  const bool writes = instruction.op == Op::kWr || instruction.op == Op::kFl || instruction.op == Op::kFl1 ||
                      instruction.op == Op::kFl0;
  if (settings_.mech_clear != MechClear::kAbort || !writes) return {};
  const Operand& bit = tree_.OperandOf(instruction, instruction.operands.count - 1);
  const bool sets = instruction.op != Op::kWr && tree_.OperandOf(instruction, 0).value != 0;
  return bit.is_activation_bit() && !sets ? bit.mechanism : UnitId();
}

const Body* Lowering::BodyOfMechanism(UnitId mechanism) const {
  const auto found = body_of_unit_.find(mechanism.index);
  return found == body_of_unit_.end() ? nullptr : &bodies_[found->second];
}

const Body* Lowering::BodyOfModule(ModuleKind kind) const {
  const UnitId unit = FindModule(tree_, kind);
  return unit.valid() ? BodyOfMechanism(unit) : nullptr;
}

ir::Program Lowering::Run() {
  program_.dialect = "technol";
  InitialData();
  FindWideRegisters();
  FindBodies();
  FindLeaving();
  FindStopping();
  AddHostFunctions();
  facts_.Begin(settings_.facts);
  AddScheduleRoutines();
  AddBodyRoutines();
  Init();
  FindTargets();
  for (Body& body : bodies_) LowerBody(body);
  Document();
  Slow();
  Requests();
  Period();
  FillSchedule();
  return std::move(program_);
}

ir::Program Lower(const Program& tree, const Flow& flow, const Settings& settings,
                  const source::SourceManager& sources) {
  return Lowering(tree, flow, settings, sources).Run();
}

}  // namespace plcxx::technol
