#include "transpiler/dialects/technol/lowering.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/technol/lowering_internal.h"

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
      if ((reads & upper) != 0) wide_[WholeIndex(reg)] = true;
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
  for (const InstructionId id : body.instructions) {
    flow_.ForEachSuccessor(id, [&](InstructionId to, Edge edge) {
      body.tail_goes_back |= edge == Edge::kJump && body.tail && id >= *body.tail && to < *body.tail;
    });
  }
  body.stretches_are_cases = true;
}

/// Modules and mechanisms, then the subprograms: those that share an instruction are one routine.
void Lowering::FindBodies() {
  for (const Root& root : flow_.roots()) {
    Body body{.unit = root.unit};
    for (uint32_t i = root.at.index; i <= tree_.units[root.unit].end.index; ++i) {
      const Instruction& instruction = tree_.instructions[InstructionId(i)];
      const bool own = instruction.unit == root.unit || instruction.mechanism == root.unit;
      if (own && flow_.IsReached(InstructionId(i))) body.instructions.push_back(InstructionId(i));
    }
    FindStretches(body);
    bodies_.push_back(std::move(body));
  }
  body_of_subprogram_.resize(flow_.subprograms().size());
  const size_t first = bodies_.size();
  for (uint32_t k = 0; k < flow_.subprograms().size(); ++k) {
    if (!flow_.IsReached(flow_.EntryOf(k))) continue;
    std::vector<bool> seen(tree_.instructions.size());
    Body body{.unit = {}, .subprograms = {k}, .instructions = {}, .level = flow_.subprograms()[k].level};
    flow_.CollectFrom(flow_.EntryOf(k), seen, body.instructions);
    for (size_t other = first; other < bodies_.size();) {
      const Body& joined = bodies_[other];
      const bool shares = std::any_of(joined.instructions.begin(), joined.instructions.end(),
                                      [&](InstructionId id) { return seen[id.index]; });
      if (!shares) {
        ++other;
        continue;
      }
      body.subprograms.insert(body.subprograms.end(), joined.subprograms.begin(), joined.subprograms.end());
      body.instructions.insert(body.instructions.end(), joined.instructions.begin(), joined.instructions.end());
      body.level = std::max(body.level, joined.level);
      bodies_.erase(bodies_.begin() + static_cast<ptrdiff_t>(other));
    }
    std::sort(body.instructions.begin(), body.instructions.end());
    body.instructions.erase(std::unique(body.instructions.begin(), body.instructions.end()), body.instructions.end());
    std::sort(body.subprograms.begin(), body.subprograms.end(),
              [&](uint32_t a, uint32_t b) { return flow_.EntryOf(a) < flow_.EntryOf(b); });
    bodies_.push_back(std::move(body));
  }
  for (uint32_t i = static_cast<uint32_t>(first); i < bodies_.size(); ++i) {
    for (const uint32_t k : bodies_[i].subprograms) body_of_subprogram_[k] = i;
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

const Body* Lowering::BodyOfMechanism(UnitId mechanism) const {
  const auto found =
      std::find_if(bodies_.begin(), bodies_.end(), [mechanism](const Body& body) { return body.unit == mechanism; });
  return found == bodies_.end() ? nullptr : &*found;
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
  AddHostFunctions();
  AddScheduleRoutines();
  AddBodyRoutines();
  Init();
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
