#include "transpiler/dialects/host50/lowering/results.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/host50/lowering/contacts.h"
#include "transpiler/dialects/host50/lowering/logic.h"
#include "transpiler/dialects/host50/lowering/numbers.h"

namespace plcxx::host50 {

using ir::ValueId;

Results::Results(const Context& context, Contacts& contacts, Logic& logic, Numbers& numbers)
    : Context(context), contacts_(contacts), logic_(logic), numbers_(numbers), results_(tree_.instructions.size()) {}

/// A block without Q conducts what it gets, so that who uses its result uses its input once more.
void Results::BeginNetwork(Span instructions) {
  for (uint32_t i = instructions.count; i-- > 0;) {
    const InstructionId id(instructions.first + i);
    const Instruction& instruction = tree_.instructions[id];
    const bool conducts = Info(instruction.op).effect == RungEffect::kOutput && results_[id.index].uses > 0;
    ForEachTaken(instruction, [&](InstructionId taken) { results_[taken.index].uses += conducts ? 2 : 1; });
  }
}

/// The value of a result that has been computed, or is a contact alone.
ValueId Results::Take(InstructionId id) {
  Result& result = results_[id.index];
  if (result.uses > 0) --result.uses;
  return result.value.valid() ? result.value : contacts_.ValueOf(id);
}

ValueId Results::TakeInput(const Input& input) {
  if (input.kind != InputKind::kResults) return builder_.Bit(1);
  const auto first = tree_.results.begin() + input.results.first;
  Compute({first, first + input.results.count});
  ValueId value = Take(*first);
  for (uint32_t i = 1; i < input.results.count; ++i) value = logic_.Or(value, Take(first[i]));
  return value;
}

/// All that `wanted` needs, in the order of the instructions: a chain of contacts may be long, so no recursion.
void Results::Compute(std::vector<InstructionId> wanted) {
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

ValueId Results::TakeOne(InstructionId id) {
  Compute({id});
  return Take(id);
}

ValueId Results::ComputeOne(InstructionId id) {
  const Instruction& instruction = tree_.instructions[id];
  builder_.SetRange(instruction.range);
  const auto input = [&] { return TakeInput(instruction.input); };
  switch (Info(instruction.op).effect) {
    case RungEffect::kLoad:
      return contacts_.ValueOf(id);
    case RungEffect::kSeries: {
      const ValueId before = input();
      return logic_.And(before, contacts_.ValueOf(id));
    }
    case RungEffect::kParallel: {
      const ValueId before = input();
      return logic_.Or(before, contacts_.ValueOf(id));
    }
    case RungEffect::kJoinSeries: {
      const ValueId left = Take(instruction.other);
      return logic_.And(left, input());
    }
    case RungEffect::kJoinParallel: {
      const ValueId left = Take(instruction.other);
      return logic_.Or(left, input());
    }
    case RungEffect::kCompare: {
      const ValueId before = input();
      return logic_.And(before, numbers_.Comparison(instruction));
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

bool Results::ReadsAny(InstructionId id, const WriteSet& writes) {
  std::vector<InstructionId> open = {id};
  while (!open.empty()) {
    const InstructionId at = open.back();
    open.pop_back();
    if (results_[at.index].value.valid()) continue;
    const Instruction& instruction = tree_.instructions[at];
    if (!contacts_.IsTaken(at) && ReadsOwn(tree_, instruction, writes)) return true;
    ForEachTaken(instruction, [&open](InstructionId each) { open.push_back(each); });
  }
  return false;
}

std::vector<InstructionId> Results::Endangered(const WriteSet& writes) {
  std::erase_if(pending_,
                [this](InstructionId id) { return results_[id.index].uses == 0 || results_[id.index].value.valid(); });
  std::vector<InstructionId> endangered;
  for (const InstructionId id : pending_) {
    if (ReadsAny(id, writes)) endangered.push_back(id);
  }
  return endangered;
}

bool Results::Release(const Input& input, const WriteSet& writes) {
  const Span taken = input.kind == InputKind::kResults ? input.results : Span{};
  const auto uses = [&](uint32_t i) -> uint32_t& { return results_[tree_.results[taken.first + i].index].uses; };
  for (uint32_t i = 0; i < taken.count; ++i) --uses(i);
  if (Endangered(writes).empty()) return true;
  for (uint32_t i = 0; i < taken.count; ++i) ++uses(i);
  return false;
}

void Results::Keep(const std::vector<InstructionId>& results) {
  Compute(results);
  for (const InstructionId id : results) {
    if (!results_[id.index].value.valid()) results_[id.index].value = contacts_.ValueOf(id);
  }
}

}  // namespace plcxx::host50
