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
constexpr uint32_t kDeepestJoin = 200;
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
  poison_.RequireResult(function, back.values.front());
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

FlowExecution::Meeting FlowExecution::JoinSince(const FlowLevel& level, uint32_t dominator,
                                                std::vector<Passage> passages,
                                                const std::vector<terms::TermId>& since_dominator, uint32_t depth) {
  // The node right after the dominator that a passage comes through; kDirect: it comes from there itself.
  constexpr uint32_t kDirect = 0xFFFFFFFF;
  const auto branch_of = [&level, dominator](const Passage& passage) {
    uint32_t branch = kDirect;
    for (uint32_t at = passage.node; at != dominator; at = level.nodes[at].dominator) branch = at;
    return branch;
  };
  std::vector<std::pair<uint32_t, std::vector<Passage>>> groups;
  for (Passage& passage : passages) {
    const uint32_t branch = branch_of(passage);
    const auto same = std::ranges::find(groups, branch, &std::pair<uint32_t, std::vector<Passage>>::first);
    if (branch == kDirect || depth == kDeepestJoin || same == groups.end()) {
      groups.emplace_back(branch, std::vector<Passage>()).second.push_back(std::move(passage));
    } else {
      same->second.push_back(std::move(passage));
    }
  }
  std::vector<Passage> joined;
  std::vector<terms::TermId> conditions;
  terms::TermId any = terms_.Bit(false);
  for (auto& [branch, members] : groups) {
    uint32_t common = members.front().node;
    const auto dominates = [&level, dominator](uint32_t node, const Passage& passage) {
      uint32_t at = passage.node;
      // Nodes are numbered after their dominators.
      while (at > node && at != dominator) at = level.nodes[at].dominator;
      return at == node;
    };
    const auto is_common = [&](const Passage& passage) { return dominates(common, passage); };
    while (common != dominator && !std::ranges::all_of(members, is_common)) common = level.nodes[common].dominator;
    Meeting meeting;
    if (members.size() == 1) {
      meeting.when = members.front().when;
      meeting.passage = std::move(members.front());
    } else {
      meeting = JoinSince(level, common, std::move(members), since_dominator, depth + 1);
    }
    for (uint32_t at = common; at != dominator; at = level.nodes[at].dominator)
      meeting.when = terms_.And(since_dominator[at], meeting.when);
    joined.push_back(std::move(meeting.passage));
    conditions.push_back(meeting.when);
    any = terms_.Or(any, meeting.when);
  }
  return {.passage = Join(std::move(joined), conditions), .when = any};
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
      Meeting meeting = JoinSince(level, node.dominator, std::move(incoming[i]), since_dominator, 0);
      since_dominator[i] = node.always ? terms_.Bit(true) : meeting.when;
      since_head[i] = terms_.And(since_head[node.dominator], since_dominator[i]);
      here = std::move(meeting.passage);
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
