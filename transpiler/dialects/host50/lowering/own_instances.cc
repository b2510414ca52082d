#include "transpiler/dialects/host50/lowering/own_instances.h"

#include <utility>

#include "transpiler/dialects/common/statement_ids.h"
#include "transpiler/dialects/host50/lowering/names.h"

namespace plcxx::host50 {

OwnInstances::OwnInstances(const Context& context, const Names& names)
    : Context(context), names_(names), instances_(tree_.instructions.size()) {
  for (const Instruction& instruction : tree_.instructions) {
    if (const std::string name = NameOf(instruction); !name.empty()) ++wanted_[name];
  }
}

/// "START_edge", "POSA_3": empty when the instruction keeps no state of its own.
std::string OwnInstances::NameOf(const Instruction& instruction) const {
  const InstructionInfo& info = Info(instruction.op);
  if (instruction.operands.count == 0) return {};
  const Operand& operand = OperandOf(instruction, 0);
  if (info.state == State::kEdge) return names_.InCode(operand.address) + "_edge";
  if (info.state != State::kAxis) return {};
  const std::string axis = operand.kind == OperandKind::kConstant ? std::to_string(static_cast<int32_t>(operand.bits))
                                                                  : names_.InCode(operand.address);
  return std::string(info.name) + "_" + axis;
}

ir::StateId OwnInstances::Add(InstructionId id) {
  const Instruction& instruction = tree_.instructions[id];
  std::string name = NameOf(instruction);
  if (wanted_.at(name) > 1) name = dialects::NameInStatement(name, now_.statement_id);
  const bool edge = Info(instruction.op).state == State::kEdge;
  const ir::StateKind kind = edge ? ir::StateKind::kEdgeMemory : ir::StateKind::kAxisRequest;
  instances_[id.index] = program_.states.Add({.kind = kind, .name = std::move(name)});
  if (edge) edges_.push_back(id);
  return instances_[id.index];
}

}  // namespace plcxx::host50
