#include "transpiler/dialects/classicladder/lowering/pages.h"

#include <string>

namespace plcxx::classicladder {

using ir::OpKind;
using ir::ValueId;

void Pages::Fire(const Transition& transition) {
  builder_.SetRange(transition.range);
  ValueId fires = accesses_.ReadBit(transition.condition);
  for (const uint32_t step : transition.deactivates) {
    fires = builder_.Pure(OpKind::kBitAnd, {fires, builder_.Load(places_.ActiveOf(step))});
  }
  builder_.When(fires, [&] {
    for (const uint32_t step : transition.deactivates) builder_.Store(places_.ActiveOf(step), builder_.Bit(0));
    for (const uint32_t step : transition.activates) builder_.Store(places_.ActiveOf(step), builder_.Bit(1));
    builder_.Store(changed_, builder_.Bit(1));
  });
}

void Pages::Lower(const Section& section) {
  const ir::RegionId outside = builder_.region();
  statements_.Begin(section);
  if (!changed_.valid()) {
    changed_ = places_.NewLocal("changed", ir::Type::kBit);
    rounds_ = places_.NewLocal("rounds", ir::Type::kI32);
  }
  builder_.Store(changed_, builder_.Bit(1));
  builder_.Store(rounds_, Word(0));
  ir::Loop loop{.kind = ir::LoopBound::kProven,
                .bound = kMostSeqRounds,
                .budget = {},
                .condition = builder_.NewRegion(),
                .body = builder_.NewRegion(),
                .exhausted = {}};
  builder_.SetRegion(loop.condition);
  const ValueId changed = builder_.Load(changed_);
  const ValueId more = builder_.Pure(OpKind::kLess32, {builder_.Load(rounds_), Word(kMostSeqRounds)});
  builder_.Pure(OpKind::kBitAnd, {changed, more});
  builder_.SetRegion(outside);
  builder_.LoopWith(loop);
  builder_.SetRegion(loop.body);
  builder_.Store(changed_, builder_.Bit(0));
  for (const auto& [index, transition] : tree_.transitions) {
    if (transition.page == static_cast<int32_t>(section.page)) Fire(transition);
  }
  builder_.Increment(rounds_);
  builder_.SetRegion(outside);
  builder_.SetRange(section.range);
  if (!steps_.valid()) {
    steps_ = builder_.AddRoutine("refresh_steps", ir::RoutineKind::kSubroutine,
                                 "Behind each sequential page: activity and time of the steps of all pages.");
  }
  builder_.CallRoutine(steps_, {});
}

void Pages::RefreshStep(uint32_t index, const Step& step) {
  constexpr uint32_t kMsPerSecond = 1000;
  builder_.SetRange(step.range);
  const ir::PlaceId ms = places_.Named("step" + std::to_string(index) + "_ms", StepMs(index));
  builder_.Choose(
      builder_.Load(places_.ActiveOf(index)),
      [&] { builder_.Store(ms, builder_.Pure(OpKind::kAdd32, {builder_.Load(ms), Word(settings_.period_ms)})); },
      [&] { builder_.Store(ms, Word(0)); });
  const ValueId active = builder_.Load(places_.ActiveOf(index));
  builder_.Store(places_.Of({VariableKind::kStepActive, step.number}), active);
  const ValueId seconds = builder_.Pure(OpKind::kSignedDiv32, {builder_.Load(ms), Word(kMsPerSecond)});
  builder_.Store(places_.Of({VariableKind::kStepTime, step.number}), seconds);
}

/// 2.10 passes over steps that are not there. 2.9 does not: each has the number 0, and the last one of the array
/// writes last.
void Pages::LowerRefresh() {
  if (!steps_.valid()) return;
  builder_.SetRegion(program_.routines[steps_].body);
  const bool all = tree_.sizes.version == LinuxCnc::kTwoNine;
  for (const auto& [index, step] : tree_.steps) {
    if (step.page >= 0 || all) RefreshStep(index, step);
  }
  constexpr uint32_t kLast = kSteps - 1;
  if (!all || tree_.steps.contains(kLast)) return;
  RefreshStep(kLast, {});
}

}  // namespace plcxx::classicladder
