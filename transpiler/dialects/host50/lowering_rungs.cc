// Results of instructions: computed where they are used, and before something that would change them.

#include <algorithm>

#include "transpiler/dialects/host50/lowering_internal.h"

namespace plcxx::host50 {

using ir::OpKind;
using ir::ValueId;

bool Lowering::IsConstant(ValueId value, uint64_t constant) const {
  const ir::Inst& inst = program_[value];
  return inst.op == OpKind::kConst && ir::ConstantValue(inst) == constant;
}

ValueId Lowering::And(ValueId a, ValueId b) {
  if (IsConstant(a, 1)) return b;
  if (IsConstant(b, 1)) return a;
  return builder_.Pure(OpKind::kBitAnd, {a, b});
}

ValueId Lowering::Or(ValueId a, ValueId b) {
  if (IsConstant(a, 0)) return b;
  if (IsConstant(b, 0)) return a;
  return builder_.Pure(OpKind::kBitOr, {a, b});
}

ValueId Lowering::Not(ValueId a) {
  if (IsConstant(a, 0) || IsConstant(a, 1)) return builder_.Bit(IsConstant(a, 0) ? 1 : 0);
  return builder_.Pure(OpKind::kBitNot, {a});
}

/// A block without Q conducts what it gets, so that who uses its result uses its input once more.
void Lowering::CountUses(Span instructions) {
  for (uint32_t i = 0; i < instructions.count; ++i) results_[instructions.first + i] = {};
  for (uint32_t i = instructions.count; i-- > 0;) {
    const InstructionId id(instructions.first + i);
    const Instruction& instruction = tree_.instructions[id];
    const bool conducts = Info(instruction.op).effect == RungEffect::kOutput && results_[id.index].uses > 0;
    ForEachTaken(instruction, [&](InstructionId taken) { results_[taken.index].uses += conducts ? 2 : 1; });
  }
}

void Lowering::Execute(InstructionId id) {
  const Instruction& instruction = tree_.instructions[id];
  builder_.SetRange(instruction.range);
  switch (Info(instruction.op).effect) {
    case RungEffect::kLoad:
    case RungEffect::kSeries:
    case RungEffect::kParallel:
      TakeEdge(id);
      pending_.push_back(id);
      break;
    case RungEffect::kJoinSeries:
    case RungEffect::kJoinParallel:
    case RungEffect::kCompare:
      pending_.push_back(id);
      break;
    case RungEffect::kOutput:
      if (instruction.op == Op::kOut || instruction.op == Op::kOuti) {
        Coil(instruction);
      } else if (instruction.op == Op::kLbl) {
        Jump(instruction);
      } else if (AxisBlockOf(instruction.op) != nullptr) {
        CommandAxis(id);
      } else {
        ActIf(id);
      }
      pending_.push_back(id);
      break;
    case RungEffect::kElement:
      results_[id.index].value = Element(instruction);
      break;
    case RungEffect::kBranchOpen:
    case RungEffect::kBranchNext:
    case RungEffect::kBranchLast:
    case RungEffect::kClose:
    case RungEffect::kNothing:
      break;  // evaluated by the parser
  }
}

/// An edge is taken where its instruction stands, whatever the rung's condition is.
void Lowering::TakeEdge(InstructionId id) {
  const Instruction& instruction = tree_.instructions[id];
  const Contact contact = Info(instruction.op).contact;
  if (contact != Contact::kRising && contact != Contact::kFalling) return;
  open_if_.then = {};
  const ValueId operand = Load(OperandOf(tree_, instruction, 0).address);
  const OpKind step = contact == Contact::kRising ? OpKind::kRising : OpKind::kFalling;
  results_[id.index].contact = builder_.Step(step, OwnInstance(id), {operand});
}

ValueId Lowering::ContactOf(InstructionId id) {
  const Instruction& instruction = tree_.instructions[id];
  if (results_[id.index].contact.valid()) return results_[id.index].contact;
  const Operand& operand = OperandOf(tree_, instruction, 0);
  const source::Range user = builder_.range();
  builder_.SetRange(instruction.range);  // reports name the line that reads
  const ValueId value = operand.kind == OperandKind::kConstant ? builder_.Bit(operand.bits) : Load(operand.address);
  builder_.SetRange(user);
  return Info(instruction.op).contact == Contact::kInverted ? Not(value) : value;
}

/// Spelled again by each user instead of once into a local.
bool Lowering::IsContactAlone(const Instruction& instruction) const {
  const InstructionInfo& info = Info(instruction.op);
  if (info.contact != Contact::kPlain && info.contact != Contact::kInverted) return false;
  return info.effect == RungEffect::kLoad ||
         (info.effect == RungEffect::kSeries && instruction.input.kind == InputKind::kRail);
}

bool Lowering::SameInput(const Input& a, const Input& b) const {
  if (a.kind != b.kind) return false;
  if (a.kind != InputKind::kResults) return true;
  const auto begin = tree_.results.begin();
  return std::equal(begin + a.results.first, begin + a.results.first + a.results.count, begin + b.results.first,
                    begin + b.results.first + b.results.count);
}

void Lowering::Release(const Input& input) {
  if (input.kind != InputKind::kResults) return;
  for (uint32_t i = 0; i < input.results.count; ++i) --results_[tree_.results[input.results.first + i].index].uses;
}

void Lowering::Retain(const Input& input) {
  if (input.kind != InputKind::kResults) return;
  for (uint32_t i = 0; i < input.results.count; ++i) ++results_[tree_.results[input.results.first + i].index].uses;
}

/// The value of a result that has been computed, or is a contact alone.
ValueId Lowering::Take(InstructionId id) {
  Result& result = results_[id.index];
  if (result.uses > 0) --result.uses;
  return result.value.valid() ? result.value : ContactOf(id);
}

ValueId Lowering::TakeInput(const Input& input) {
  if (input.kind != InputKind::kResults) return builder_.Bit(1);
  const auto first = tree_.results.begin() + input.results.first;
  Compute({first, first + input.results.count});
  ValueId value = Take(*first);
  for (uint32_t i = 1; i < input.results.count; ++i) value = Or(value, Take(first[i]));
  return value;
}

/// All that `wanted` needs, in the order of the instructions: a chain of contacts may be long, so no recursion.
void Lowering::Compute(std::vector<InstructionId> wanted) {
  std::vector<InstructionId> needed;
  while (!wanted.empty()) {
    const InstructionId id = wanted.back();
    wanted.pop_back();
    const Instruction& instruction = tree_.instructions[id];
    if (results_[id.index].value.valid() || IsContactAlone(instruction)) continue;
    needed.push_back(id);
    ForEachTaken(instruction, [&wanted](InstructionId taken) { wanted.push_back(taken); });
  }
  std::ranges::sort(needed);
  const auto repeated = std::ranges::unique(needed);
  needed.erase(repeated.begin(), repeated.end());
  for (const InstructionId id : needed) results_[id.index].value = ComputeOne(id);
}

ValueId Lowering::ComputeOne(InstructionId id) {
  const Instruction& instruction = tree_.instructions[id];
  builder_.SetRange(instruction.range);
  const auto input = [&] { return TakeInput(instruction.input); };
  switch (Info(instruction.op).effect) {
    case RungEffect::kLoad:
      return ContactOf(id);
    case RungEffect::kSeries: {
      const ValueId before = input();
      return And(before, ContactOf(id));
    }
    case RungEffect::kParallel: {
      const ValueId before = input();
      return Or(before, ContactOf(id));
    }
    case RungEffect::kJoinSeries: {
      const ValueId left = Take(instruction.other);
      return And(left, input());
    }
    case RungEffect::kJoinParallel: {
      const ValueId left = Take(instruction.other);
      return Or(left, input());
    }
    case RungEffect::kCompare: {
      const ValueId before = input();
      return And(before, Comparison(instruction));
    }
    case RungEffect::kOutput:
      return input();
    case RungEffect::kElement:
    case RungEffect::kBranchOpen:
    case RungEffect::kBranchNext:
    case RungEffect::kBranchLast:
    case RungEffect::kClose:
    case RungEffect::kNothing:
      break;
  }
  PLCXX_UNREACHABLE();  // an element has its value from its execution, the others have none
}

bool Lowering::ReadsAny(InstructionId id, const WriteSet& writes) {
  std::vector<InstructionId> open = {id};
  while (!open.empty()) {
    const InstructionId at = open.back();
    open.pop_back();
    if (results_[at.index].value.valid()) continue;
    const Instruction& instruction = tree_.instructions[at];
    const bool taken = results_[at.index].contact.valid();  // an edge does not look again
    if (!taken && ReadsOwn(instruction, writes)) return true;
    ForEachTaken(instruction, [&open](InstructionId each) { open.push_back(each); });
  }
  return false;
}

std::vector<InstructionId> Lowering::Endangered(const WriteSet& writes) {
  std::erase_if(pending_,
                [this](InstructionId id) { return results_[id.index].uses == 0 || results_[id.index].value.valid(); });
  std::vector<InstructionId> endangered;
  for (const InstructionId id : pending_) {
    if (ReadsAny(id, writes)) endangered.push_back(id);
  }
  return endangered;
}

void Lowering::Keep(const std::vector<InstructionId>& results) {
  Compute(results);
  for (const InstructionId id : results) {
    if (!results_[id.index].value.valid()) results_[id.index].value = ContactOf(id);
  }
}

void Lowering::Coil(const Instruction& instruction) {
  open_if_.then = {};
  ValueId value = TakeInput(instruction.input);
  Keep(Endangered(WritesOf(instruction)));
  builder_.SetRange(instruction.range);
  if (instruction.op == Op::kOuti) value = Not(value);
  Store(OperandOf(tree_, instruction, 0).address, value);
}

void Lowering::ActIf(InstructionId id) {
  const Instruction& instruction = tree_.instructions[id];
  const WriteSet writes = WritesOf(instruction);
  const auto act = [&] { Act(instruction); };
  if (open_if_.then.valid() && SameInput(open_if_.input, instruction.input)) {
    Release(instruction.input);
    if (Endangered(writes).empty()) {
      return builder_.Into(open_if_.then, act);
    }
    Retain(instruction.input);
  }
  const ValueId condition = TakeInput(instruction.input);
  Keep(Endangered(writes));
  builder_.SetRange(instruction.range);
  open_if_ = {};
  if (IsConstant(condition, 1)) return act();
  open_if_ = {builder_.RegionOf(act), instruction.input};
  builder_.If(condition, open_if_.then);
}

}  // namespace plcxx::host50
