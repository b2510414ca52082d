#include "transpiler/prove/verify/llvm_ir/loop_execution.h"

#include <algorithm>
#include <string>
#include <utility>

namespace plcxx::prove::verify::llvm_ir {
namespace {

constexpr size_t kMostHeads = 16;  // of one loop that are looked at

}  // namespace

void LoopExecution::RunLoop(const FlowLevel& level, Passage entry, terms::TermId context,
                            std::vector<Passage>& leaving) {
  if (run_.loops != CodeRun::Loops::kAtHeads || sampling_ != 0) {
    UnrollLoop(level, std::move(entry), context, leaving, nullptr);
    return;
  }
  // The first rounds: if they are all, there is no more to be done.
  LoopState state;
  if (!FindItems(*level.nodes.front().block, state)) return;
  const terms::TermId left_out = std::exchange(outcome_.left_out, terms_.Bit(false));
  const size_t obligations = outcome_.obligations.size();
  std::vector<Passage> ways;
  ++sampling_;
  UnrollLoop(level, entry, context, ways, &state);
  --sampling_;
  const bool whole = terms_.IsFalse(outcome_.left_out);
  outcome_.left_out = left_out;
  if (refused()) return;
  if (whole) {
    for (Passage& passage : ways) leaving.push_back(std::move(passage));
    return;
  }
  outcome_.obligations.resize(obligations);
  RunByHead(level, entry, context, state, leaving);
}

std::optional<Passage> LoopExecution::JoinRepeats(const llvm::BasicBlock* head, std::vector<Passage> passages,
                                                  terms::TermId active, std::vector<Passage>& leaving) {
  std::vector<Passage> again;
  std::vector<terms::TermId> conditions;
  terms::TermId any = terms_.Bit(false);
  for (Passage& passage : passages) {
    if (passage.to == head) {
      conditions.push_back(passage.when);
      any = terms_.Or(any, passage.when);
      again.push_back(std::move(passage));
      continue;
    }
    passage.when = terms_.And(active, passage.when);
    if (!terms_.IsFalse(passage.when)) leaving.push_back(std::move(passage));
  }
  if (again.empty()) return std::nullopt;
  Passage next = flow_.Join(std::move(again), conditions);
  next.when = any;
  return next;
}

void LoopExecution::UnrollLoop(const FlowLevel& level, Passage entry, terms::TermId context,
                               std::vector<Passage>& leaving, LoopState* state) {
  const llvm::BasicBlock* head = level.nodes.front().block;
  const bool limited = run_.loops != CodeRun::Loops::kUnrolled;
  terms::TermId active = terms_.Bit(true);
  Passage next = std::move(entry);
  uint32_t unknown = 0;
  for (uint32_t round = 0;; ++round) {
    const bool too_many = round > run_.most_rounds;
    if (limited && (unknown > run_.rounds || too_many)) {
      outcome_.left_out = terms_.Or(outcome_.left_out, terms_.And(context, active));
      return;
    }
    if (too_many) {
      Refuse("a loop may go round more than " + std::to_string(run_.most_rounds) + " times");
      return;
    }
    const terms::TermId when = terms_.And(context, active);
    if (state != nullptr && state->heads.size() < kMostHeads)
      state->heads.emplace_back(terms_.And(when, terms_.Not(outcome_.left_out)), next);
    std::vector<Passage> passages;
    flow_.RunLevel(level, std::move(next), when, passages);
    if (refused()) return;
    std::optional<Passage> again = JoinRepeats(head, std::move(passages), active, leaving);
    if (!again) return;
    active = terms_.And(active, again->when);
    if (terms_.IsFalse(active)) return;
    if (!terms_.IsTrue(active)) ++unknown;
    if (limited && unknown > 0 && environment_.NeverHolds(terms_.And(context, active))) return;
    next = std::move(*again);
  }
}

bool LoopExecution::FindItems(const llvm::BasicBlock& head, LoopState& state) {
  for (const llvm::PHINode& phi : head.phis()) {
    if (!IsSupported(*phi.getType()) || phi.getType()->isStructTy()) {
      Refuse("a loop that keeps a value of a type that is too wide");
      return false;
    }
    state.phis.push_back(&phi);
    state.objects.push_back(0);
    state.items.push_back({.name = phi.hasName() ? std::string_view(phi.getName()) : "a value"});
  }
  return true;
}

void LoopExecution::AddSlots(const Slots& a, const Slots& b, LoopState& state) {
  Slots::ForEachDifference(a, b, [&](uint32_t slot) {
    // Bytes of locals that are gone have no value any more.
    if (slot >= now_.next_slot || memory_.ReadSlot(a, slot) == memory_.ReadSlot(b, slot)) return;
    const bool known = std::any_of(state.items.begin(), state.items.end(), [slot](const CodeLoop::Item& item) {
      return item.name.empty() && item.slot == slot;
    });
    if (!known) state.items.push_back({.name = "", .slot = slot});
  });
}

std::vector<terms::TermId> LoopExecution::ItemsOf(const Passage& passage, const LoopState& state) {
  std::vector<terms::TermId> values;
  for (size_t i = 0; i < state.phis.size(); ++i) {
    const CodeValue& value = passage.values[i];
    if (!state.phis[i]->getType()->isPointerTy()) {
      values.push_back(value.term);
      continue;
    }
    if (value.targets.size() != 1 || value.targets.front().object != state.objects[i]) {
      Refuse("a loop that keeps a pointer to one or another object");
      values.push_back(Undefined(64));
      continue;
    }
    values.push_back(value.targets.front().offset);
  }
  for (size_t i = state.phis.size(); i < state.items.size(); ++i)
    values.push_back(memory_.ReadSlot(passage.slots, state.items[i].slot));
  return values;
}

void LoopExecution::RequireAtHead(const LoopState& state, const Passage& passage, terms::TermId when) {
  const terms::TermId context = std::exchange(context_, when);
  for (size_t i = 0; i < state.phis.size(); ++i)
    poison_.RequireValue(passage.values[i], "a number that a loop keeps and C++ leaves undefined");
  context_ = context;
}

Passage LoopExecution::StartOf(const Passage& entry, const LoopState& state, const std::vector<terms::TermId>& values) {
  Passage start = entry;
  for (size_t i = 0; i < state.items.size(); ++i) {
    if (i >= state.phis.size()) {
      start.slots.Set(state.items[i].slot, values[i]);
    } else if (state.phis[i]->getType()->isPointerTy()) {
      start.values[i].targets = {{terms_.Bit(true), state.objects[i], values[i]}};
    } else {
      start.values[i].term = values[i];
    }
  }
  return start;
}

void LoopExecution::RunByHead(const FlowLevel& level, const Passage& entry, terms::TermId context, LoopState& state,
                              std::vector<Passage>& leaving) {
  const llvm::BasicBlock* head = level.nodes.front().block;
  for (size_t i = 0; i < state.phis.size(); ++i) {
    if (state.phis[i]->getType()->isPointerTy() && !entry.values[i].targets.empty())
      state.objects[i] = entry.values[i].targets.front().object;
  }
  for (const auto& [when, passage] : state.heads) AddSlots(entry.slots, passage.slots, state);
  const std::string name = now_.flows.NameOf(*head->getParent()) + ", " + head->getName().str();
  if (state.items.empty()) {
    Refuse("a loop that changes nothing, and so may never end: " + name);
    return;
  }
  const size_t obligations = outcome_.obligations.size();
  environment_.OpenLoop();
  for (;;) {
    CodeLoop loop{.name = name, .items = state.items, .entry = {context, ItemsOf(entry, state)}, .samples = {}};
    for (size_t i = 1; i < state.heads.size(); ++i)
      loop.samples.push_back({state.heads[i].first, ItemsOf(state.heads[i].second, state)});
    if (refused()) return;
    const std::vector<terms::TermId> values = environment_.AtHead(loop);
    if (values.size() != state.items.size()) {
      Refuse("a loop of which nobody knows how often it goes round: " + name);
      return;
    }
    const Passage start = StartOf(entry, state, values);
    std::vector<Passage> passages, ways;
    flow_.RunLevel(level, start, context, passages);
    if (refused()) return;
    const std::optional<Passage> next = JoinRepeats(head, std::move(passages), terms_.Bit(true), ways);
    const size_t items = state.items.size();
    if (next) AddSlots(start.slots, next->slots, state);
    if (state.items.size() > items) {
      outcome_.obligations.resize(obligations);
      continue;
    }
    const terms::TermId again = next ? next->when : terms_.Bit(false);
    RequireAtHead(state, entry, context);
    if (next) RequireAtHead(state, *next, terms_.And(context, again));
    environment_.CloseLoop(again, next ? ItemsOf(*next, state) : values);
    for (Passage& passage : ways) leaving.push_back(std::move(passage));
    return;
  }
}

}  // namespace plcxx::prove::verify::llvm_ir
