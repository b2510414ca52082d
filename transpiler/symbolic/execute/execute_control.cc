// Executor: branches and exits.
#include <algorithm>
#include <map>
#include <utility>

#include "transpiler/symbolic/execute/executor.h"

namespace plcxx::execute {

void Executor::Leave(ir::InstId target, bool repeats, terms::TermId when) {
  if (terms_.IsFalse(when)) return;
  for (Leaving& leaving : flow_.leaving) {
    if (leaving.target != target || leaving.repeats != repeats) continue;
    leaving.when = terms_.Or(leaving.when, when);
    return;
  }
  flow_.leaving.push_back({.target = target, .repeats = repeats, .when = when});
}

void Executor::Join(std::vector<Arm> arms) {
  if (!refusal_.empty()) {
    flow_.active = terms_.Bit(false);
    return;
  }
  const terms::TermId before = flow_.active;
  // Later arms are joined first, so that the first one stands outermost.
  std::map<CellId, terms::TermId> joined;
  for (const Arm& arm : arms) {
    for (const Memory::Change& change : arm.changes) joined.emplace(change.cell, memory_.Read(change.cell));
  }
  terms::TermId active = before;
  for (auto arm = arms.rbegin(); arm != arms.rend(); ++arm) {
    for (const Memory::Change& change : arm->changes) {
      terms::TermId& value = joined[change.cell];
      value = terms_.Ite(arm->when, change.value, value);
    }
    if (!terms_.IsTrue(arm->flow.active)) {
      active = terms_.Ite(arm->when, terms_.And(before, arm->flow.active), active);
    }
  }
  for (const auto& [cell, value] : joined) WriteCell(cell, value);
  for (const Arm& arm : arms) {
    for (const Leaving& leaving : arm.flow.leaving) {
      Leave(leaving.target, leaving.repeats, terms_.And(before, terms_.And(arm.when, leaving.when)));
    }
  }
  flow_.active = active;
}

terms::TermId Executor::TakeLeaving(ir::InstId target, bool repeats) {
  const auto at = std::ranges::find_if(
      flow_.leaving, [&](const Leaving& leaving) { return leaving.target == target && leaving.repeats == repeats; });
  if (at == flow_.leaving.end()) return terms_.Bit(false);
  const terms::TermId when = at->when;
  flow_.leaving.erase(at);
  return when;
}

void Executor::Land(ir::InstId target, terms::TermId before) {
  const terms::TermId landed = TakeLeaving(target, false);
  if (!refusal_.empty()) return;
  // Who came in and did not leave for somewhere else is here.
  flow_.active = flow_.leaving.empty() ? before : terms_.Or(flow_.active, landed);
}

void Executor::ExecuteIf(ir::InstId, const ir::Inst& inst) {
  const terms::TermId condition = ValueOf(inst.a);
  const ir::RegionId then(inst.b), otherwise(inst.c);
  if (terms_.IsConst(condition)) {
    ExecuteRegion(terms_.IsTrue(condition) ? then : otherwise);
    return;
  }
  std::vector<Arm> arms;
  if (then.valid()) arms.push_back(RunArm(condition, [&] { ExecuteRegion(then); }));
  if (otherwise.valid()) arms.push_back(RunArm(terms_.Not(condition), [&] { ExecuteRegion(otherwise); }));
  Join(std::move(arms));
}

terms::TermId Executor::SelectedBy(const ir::SwitchCase& one, terms::TermId selector) {
  terms::TermId chosen = terms_.Bit(false);
  for (const uint64_t value : one.values) {
    chosen = terms_.Or(chosen, terms_.Eq(selector, terms_.Const(value, terms_.Width(selector))));
  }
  return chosen;
}

std::vector<terms::TermId> Executor::CaseConditions(const std::vector<ir::SwitchCase>& cases, terms::TermId selector) {
  // As in C, the default is taken when no other case is, wherever it stands.
  std::vector<terms::TermId> conditions;
  terms::TermId any = terms_.Bit(false);
  for (const ir::SwitchCase& one : cases) {
    conditions.push_back(SelectedBy(one, selector));
    any = terms_.Or(any, conditions.back());
  }
  for (size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].values.empty()) conditions[i] = terms_.Not(any);
  }
  return conditions;
}

void Executor::ExecuteSwitch(ir::InstId, const ir::Inst& inst) {
  const std::vector<ir::SwitchCase>& cases = program_.switches[ir::SwitchId(inst.payload)].cases;
  const std::vector<terms::TermId> chosen = CaseConditions(cases, ValueOf(inst.a));
  // Cases that run on into each other are one arm; inside it each begins where it is chosen or run into.
  std::vector<Arm> arms;
  for (size_t begin = 0; begin < cases.size();) {
    size_t end = begin + 1;
    terms::TermId any = chosen[begin];
    for (; cases[end - 1].falls_through && end < cases.size(); ++end) any = terms_.Or(any, chosen[end]);
    if (!terms_.IsFalse(any)) {
      arms.push_back(RunArm(any, [&] {
        if (end == begin + 1) {
          ExecuteRegion(cases[begin].region);
          return;
        }
        terms::TermId running = terms_.Bit(false);
        for (size_t i = begin; i < end; ++i) {
          running = terms_.Or(running, chosen[i]);
          if (terms_.IsFalse(running)) continue;
          std::vector<Arm> one;
          one.push_back(RunArm(running, [&] { ExecuteRegion(cases[i].region); }));
          running = terms_.And(running, one.front().flow.active);
          // Who leaves is gone for the cases that follow, too, by `running`; the arm as a whole stays open till its
          // end.
          one.front().flow.active = terms_.Bit(true);
          Join(std::move(one));
        }
        terms::TermId left = terms_.Bit(false);
        for (const Leaving& leaving : flow_.leaving) left = terms_.Or(left, leaving.when);
        if (refusal_.empty()) flow_.active = terms_.Not(left);
      }));
    }
    begin = end;
  }
  Join(std::move(arms));
}

void Executor::ExecuteBlock(ir::InstId id, const ir::Inst& inst) {
  const terms::TermId before = flow_.active;
  std::vector<Leaving> outer = std::exchange(flow_.leaving, {});
  ExecuteRegion(ir::RegionId(inst.a));
  Land(id, before);
  for (const Leaving& leaving : outer) Leave(leaving.target, leaving.repeats, leaving.when);
}

void Executor::ExecuteExit(ir::InstId, const ir::Inst& inst) {
  const bool conditional = ir::ValueId(inst.a).valid();
  const terms::TermId when = conditional ? terms_.And(flow_.active, ValueOf(inst.a)) : flow_.active;
  Leave(ir::InstId(inst.payload), false, when);
  flow_.active = conditional ? terms_.And(flow_.active, terms_.Not(ValueOf(inst.a))) : terms_.Bit(false);
}

void Executor::ExecuteRepeat(ir::InstId, const ir::Inst& inst) {
  const terms::TermId wants = ir::ValueId(inst.a).valid() ? ValueOf(inst.a) : terms_.Bit(true);
  const ir::InstId target(inst.payload);
  const ir::Place& budget = program_.places[program_.loops[ir::LoopId(program_[target].payload)].budget];
  const terms::TermId left = memory_.ReadPlace(budget);
  const terms::TermId refused = terms_.Eq(left, terms_.Const(0, terms_.Width(left)));
  std::vector<Arm> arms;
  arms.push_back(RunArm(terms_.And(wants, terms_.Not(refused)), [&] {
    WritePlace(budget, terms_.Sub(left, terms_.Const(1, terms_.Width(left))));
    Leave(target, true, flow_.active);
    flow_.active = terms_.Bit(false);
  }));
  arms.push_back(RunArm(terms_.And(wants, refused), [&] { ExecuteRegion(ir::RegionId(inst.b)); }));
  std::erase_if(arms, [this](const Arm& arm) { return terms_.IsFalse(arm.when); });
  Join(std::move(arms));
}

}  // namespace plcxx::execute
