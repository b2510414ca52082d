#include "transpiler/prove/verify/llvm_ir/flow_execution.h"

#include <llvm/IR/CFG.h>
#include <llvm/Support/Casting.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "transpiler/prove/verify/llvm_ir/loop_execution.h"

namespace plcxx::prove::verify::llvm_ir {
namespace {

constexpr uint32_t kDeepestCall = 200;
constexpr const char* kDecidesUndefined = "a decision by a number that C++ leaves undefined";

}  // namespace

CodeValue FlowExecution::Call(const llvm::Function& function, std::vector<CodeValue> arguments) {
  const llvm::Type& type = *function.getReturnType();
  const auto give_up = [&](std::string reason) {
    Refuse(std::move(reason));
    return values_.AnyResult(type);
  };
  if (!type.isVoidTy() && !IsSupported(type)) {
    Refuse("a function returns a value that is too wide: " + function.getName().str());
    return {};
  }
  const FlowLevel* level = now_.flows.Of(function);
  if (level == nullptr) return give_up("a function has a cycle that is no loop: " + function.getName().str());
  if (depth_ == kDeepestCall) return give_up("calls are nested too deeply");
  ++depth_;
  Execution::Values outer = std::exchange(now_.values, Execution::Values());
  const uint32_t next_slot = now_.next_slot;
  const terms::TermId context = context_;
  for (unsigned i = 0; i < function.arg_size(); ++i) now_.values[function.getArg(i)] = std::move(arguments[i]);
  std::vector<Passage> returns;
  Passage entry;
  entry.slots = std::move(slots_);
  RunLevel(*level, std::move(entry), context, returns);
  --depth_;
  now_.values = std::move(outer);
  now_.next_slot = next_slot;
  context_ = context;
  if (refused()) return values_.AnyResult(type);
  if (returns.empty()) return give_up("a function never returns: " + function.getName().str());
  std::vector<terms::TermId> conditions;
  for (const Passage& passage : returns) conditions.push_back(passage.when);
  Passage back = Join(std::move(returns), conditions);
  slots_ = std::move(back.slots);
  if (back.values.empty()) return {};
  poison_.RequireValue(back.values.front(), "a result that C++ leaves undefined");
  return std::move(back.values.front());
}

Passage FlowExecution::Join(std::vector<Passage> passages, const std::vector<terms::TermId>& conditions) {
  Passage joined = std::move(passages.back());
  for (size_t i = passages.size() - 1; i-- > 0;) {
    const Passage& passage = passages[i];
    std::vector<uint32_t> slots;
    Slots::ForEachDifference(passage.slots, joined.slots, [&](uint32_t slot) { slots.push_back(slot); });
    for (const uint32_t slot : slots) {
      // Bytes of locals that are gone have no value any more.
      if (slot >= now_.next_slot) continue;
      joined.slots.Set(
          slot, terms_.Ite(conditions[i], memory_.ReadSlot(passage.slots, slot), memory_.ReadSlot(joined.slots, slot)));
    }
    for (size_t k = 0; k < joined.values.size(); ++k)
      joined.values[k] = values_.Choose(conditions[i], passage.values[k], joined.values[k]);
  }
  return joined;
}

void FlowExecution::RunLevel(const FlowLevel& level, Passage entry, terms::TermId context,
                             std::vector<Passage>& leaving) {
  const size_t count = level.nodes.size();
  std::vector<std::vector<Passage>> incoming(count);
  std::vector<terms::TermId> since_dominator(count), since_head(count);
  incoming.front().push_back(std::move(entry));
  for (uint32_t i = 0; i < count && !refused(); ++i) {
    const FlowNode& node = level.nodes[i];
    Passage here;
    if (i == 0) {
      here = std::move(incoming[i].front());
      since_dominator[i] = since_head[i] = terms_.Bit(true);
    } else {
      if (incoming[i].empty()) continue;
      std::vector<terms::TermId> conditions;
      terms::TermId any = terms_.Bit(false);
      for (const Passage& passage : incoming[i]) {
        terms::TermId when = passage.when;
        for (uint32_t at = passage.node; at != node.dominator; at = level.nodes[at].dominator)
          when = terms_.And(since_dominator[at], when);
        conditions.push_back(when);
        any = terms_.Or(any, when);
      }
      since_dominator[i] = node.always ? terms_.Bit(true) : any;
      since_head[i] = terms_.And(since_head[node.dominator], since_dominator[i]);
      here = Join(std::move(incoming[i]), conditions);
    }
    std::vector<Passage> passages;
    const terms::TermId when_here = terms_.And(context, since_head[i]);
    if (node.loop != nullptr) {
      loops_.RunLoop(*node.loop, std::move(here), when_here, passages);
    } else {
      context_ = when_here;
      RunBlock(*node.block, std::move(here), passages);
    }
    for (Passage& passage : passages) {
      const auto next = passage.to == nullptr ? level.node_of.end() : level.node_of.find(passage.to);
      if (next != level.node_of.end() && next->second != 0) {
        passage.node = i;
        incoming[next->second].push_back(std::move(passage));
      } else {
        passage.when = terms_.And(since_head[i], passage.when);
        leaving.push_back(std::move(passage));
      }
    }
  }
}

void FlowExecution::RunBlock(const llvm::BasicBlock& block, Passage entry, std::vector<Passage>& leaving) {
  slots_ = std::move(entry.slots);
  size_t phi_number = 0;
  for (const llvm::PHINode& phi : block.phis()) now_.values[&phi] = std::move(entry.values[phi_number++]);
  for (const llvm::Instruction& inst : block) {
    if (refused()) return;
    if (llvm::isa<llvm::PHINode>(inst)) continue;
    ++outcome_.instructions;
    if (inst.isTerminator()) return LeaveBlock(inst, leaving);
    instructions_.Execute(inst);
  }
}

void FlowExecution::LeaveBlock(const llvm::Instruction& inst, std::vector<Passage>& leaving) {
  if (!instructions_.Check(inst)) return;
  if (const auto* branch = llvm::dyn_cast<llvm::BranchInst>(&inst)) {
    LeaveByBranch(*branch, leaving);
  } else if (const auto* choice = llvm::dyn_cast<llvm::SwitchInst>(&inst)) {
    LeaveBySwitch(*choice, leaving);
  } else if (const auto* back = llvm::dyn_cast<llvm::ReturnInst>(&inst)) {
    LeaveByReturn(*back, leaving);
  } else if (llvm::isa<llvm::UnreachableInst>(inst)) {
    Require(terms_.Bit(true), "code behind a call that never returns");
  } else {
    Refuse(std::string("instruction '") + inst.getOpcodeName() + "'");
  }
}

void FlowExecution::LeaveByBranch(const llvm::BranchInst& branch, std::vector<Passage>& leaving) {
  const llvm::BasicBlock& block = *branch.getParent();
  if (branch.isUnconditional() || branch.getSuccessor(0) == branch.getSuccessor(1)) {
    Leave(block, branch.getSuccessor(0), terms_.Bit(true), leaving);
    return;
  }
  poison_.RequireValue(values_.ValueOf(branch.getCondition()), kDecidesUndefined);
  const terms::TermId condition = values_.TermOf(branch.getCondition());
  Leave(block, branch.getSuccessor(0), condition, leaving);
  Leave(block, branch.getSuccessor(1), terms_.Not(condition), leaving);
}

void FlowExecution::LeaveByReturn(const llvm::ReturnInst& back, std::vector<Passage>& leaving) {
  Passage passage;
  passage.from = back.getParent();
  passage.when = terms_.Bit(true);
  passage.slots = slots_;
  if (back.getReturnValue() != nullptr) passage.values.push_back(values_.ValueOf(back.getReturnValue()));
  leaving.push_back(std::move(passage));
}

void FlowExecution::Leave(const llvm::BasicBlock& from, const llvm::BasicBlock* to, terms::TermId when,
                          std::vector<Passage>& leaving) {
  if (terms_.IsFalse(when)) return;
  Passage passage;
  passage.from = &from;
  passage.to = to;
  passage.when = when;
  passage.slots = slots_;
  for (const llvm::PHINode& phi : to->phis()) {
    if (!IsSupported(*phi.getType())) {
      Refuse("instruction 'phi' of a type that is too wide");
      return;
    }
    passage.values.push_back(values_.ValueOf(phi.getIncomingValueForBlock(&from)));
  }
  leaving.push_back(std::move(passage));
}

void FlowExecution::LeaveBySwitch(const llvm::SwitchInst& choice, std::vector<Passage>& leaving) {
  poison_.RequireValue(values_.ValueOf(choice.getCondition()), kDecidesUndefined);
  const terms::TermId selector = values_.TermOf(choice.getCondition());
  struct Way {
    const llvm::BasicBlock* to;
    terms::TermId when;
  };
  std::vector<Way> ways;
  terms::TermId any = terms_.Bit(false);
  const auto add = [&](const llvm::BasicBlock* to, terms::TermId when) {
    const auto same = std::ranges::find_if(ways, [to](const Way& way) { return way.to == to; });
    if (same == ways.end()) {
      ways.push_back({to, when});
    } else {
      same->when = terms_.Or(same->when, when);
    }
  };
  for (const auto& one : choice.cases()) {
    const uint64_t value = one.getCaseValue()->getValue().getZExtValue();
    const terms::TermId when = terms_.Eq(selector, terms_.Const(value, terms_.Width(selector)));
    add(one.getCaseSuccessor(), when);
    any = terms_.Or(any, when);
  }
  add(choice.getDefaultDest(), terms_.Not(any));
  for (const Way& way : ways) Leave(*choice.getParent(), way.to, way.when, leaving);
}

}  // namespace plcxx::prove::verify::llvm_ir
