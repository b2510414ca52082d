#include "transpiler/dialects/host50/lowering/contacts.h"

#include "transpiler/dialects/host50/lowering/cells.h"
#include "transpiler/dialects/host50/lowering/logic.h"
#include "transpiler/dialects/host50/lowering/own_instances.h"

namespace plcxx::host50 {

using ir::OpKind;
using ir::ValueId;

Contacts::Contacts(const Context& context, Cells& cells, OwnInstances& instances, Logic& logic)
    : Context(context), cells_(cells), instances_(instances), logic_(logic), edges_(tree_.instructions.size()) {}

void Contacts::TakeEdge(InstructionId id) {
  const Instruction& instruction = tree_.instructions[id];
  const Contact contact = Info(instruction.op).contact;
  const ValueId operand = cells_.Load(OperandOf(instruction, 0).address);
  const OpKind step = contact == Contact::kRising ? OpKind::kRising : OpKind::kFalling;
  edges_[id.index] = builder_.Step(step, instances_.Add(id), {operand});
}

ValueId Contacts::ValueOf(InstructionId id) {
  if (IsTaken(id)) return edges_[id.index];
  const Instruction& instruction = tree_.instructions[id];
  const Operand& operand = OperandOf(instruction, 0);
  const source::Range user = builder_.range();
  builder_.SetRange(instruction.range);  // reports name the line that reads
  const ValueId value =
      operand.kind == OperandKind::kConstant ? builder_.Bit(operand.bits) : cells_.Load(operand.address);
  builder_.SetRange(user);
  return Info(instruction.op).contact == Contact::kInverted ? logic_.Not(value) : value;
}

bool IsContactAlone(const Instruction& instruction) {
  const InstructionInfo& info = Info(instruction.op);
  if (info.contact != Contact::kPlain && info.contact != Contact::kInverted) return false;
  return info.effect == RungEffect::kLoad ||
         (info.effect == RungEffect::kSeries && instruction.input.kind == InputKind::kRail);
}

}  // namespace plcxx::host50
