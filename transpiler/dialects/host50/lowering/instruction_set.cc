#include "transpiler/dialects/host50/lowering/instruction_set.h"

#include <algorithm>

#include "transpiler/dialects/host50/lowering/axes.h"
#include "transpiler/dialects/host50/lowering/blocks.h"
#include "transpiler/dialects/host50/lowering/cells.h"
#include "transpiler/dialects/host50/lowering/contacts.h"
#include "transpiler/dialects/host50/lowering/elements.h"
#include "transpiler/dialects/host50/lowering/jumps.h"
#include "transpiler/dialects/host50/lowering/logic.h"
#include "transpiler/dialects/host50/lowering/results.h"

namespace plcxx::host50 {

using ir::ValueId;

InstructionSet::InstructionSet(const Context& context, Cells& cells, Contacts& contacts, Logic& logic, Results& results,
                               Jumps& jumps, Blocks& blocks, Elements& elements, Axes& axes)
    : Context(context),
      cells_(cells),
      contacts_(contacts),
      logic_(logic),
      results_(results),
      jumps_(jumps),
      blocks_(blocks),
      elements_(elements),
      axes_(axes) {}

void InstructionSet::BeginRung() {
  results_.BeginRung();
  open_if_ = {};
}

void InstructionSet::Execute(InstructionId id) {
  const Instruction& instruction = tree_.instructions[id];
  builder_.SetRange(instruction.range);
  switch (Info(instruction.op).effect) {
    case RungEffect::kLoad:
    case RungEffect::kSeries:
    case RungEffect::kParallel:
      if (IsEdge(Info(instruction.op).contact)) {
        open_if_ = {};
        contacts_.TakeEdge(id);
      }
      results_.Await(id);
      break;
    case RungEffect::kJoinSeries:
    case RungEffect::kJoinParallel:
    case RungEffect::kCompare:
      results_.Await(id);
      break;
    case RungEffect::kOutput:
      ExecuteOutput(id);
      break;
    case RungEffect::kElement:
      open_if_ = {};
      results_.Set(id, elements_.Execute(instruction));
      break;
    case RungEffect::kBranchOpen:
    case RungEffect::kBranchNext:
    case RungEffect::kBranchLast:
    case RungEffect::kClose:
    case RungEffect::kNothing:
      break;  // evaluated by the parser
  }
}

void InstructionSet::ExecuteOutput(InstructionId id) {
  const Instruction& instruction = tree_.instructions[id];
  const bool is_coil = instruction.op == Op::kOut || instruction.op == Op::kOuti;
  const bool is_axis = AxisBlockOf(instruction.op) != nullptr;
  if (!is_coil && !is_axis && instruction.op != Op::kLbl) return ActIf(instruction);
  open_if_ = {};
  if (is_coil) return Coil(instruction);
  if (is_axis) return axes_.Command(id);
  jumps_.Jump(instruction);
}

void InstructionSet::Coil(const Instruction& instruction) {
  ValueId value = results_.TakeInput(instruction.input);
  results_.KeepFrom(WritesOf(tree_, instruction));
  builder_.SetRange(instruction.range);
  if (instruction.op == Op::kOuti) value = logic_.Not(value);
  cells_.Store(OperandOf(instruction, 0).address, value);
}

bool InstructionSet::SameInput(const Input& a, const Input& b) const {
  if (a.kind != b.kind) return false;
  if (a.kind != InputKind::kResults) return true;
  const auto begin = tree_.results.begin();
  return std::equal(begin + a.results.first, begin + a.results.first + a.results.count, begin + b.results.first,
                    begin + b.results.first + b.results.count);
}

void InstructionSet::ActIf(const Instruction& instruction) {
  const WriteSet writes = WritesOf(tree_, instruction);
  const auto act = [&] { blocks_.Act(instruction); };
  if (open_if_.then.valid() && SameInput(open_if_.input, instruction.input) &&
      results_.Release(instruction.input, writes)) {
    return builder_.Into(open_if_.then, act);
  }
  const ValueId condition = results_.TakeInput(instruction.input);
  results_.KeepFrom(writes);
  builder_.SetRange(instruction.range);
  open_if_ = {};
  if (logic_.IsConstant(condition, 1)) return act();
  open_if_ = {builder_.RegionOf(act), instruction.input};
  builder_.If(condition, open_if_.then);
}

}  // namespace plcxx::host50
