#include "transpiler/scenarios/run.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/scenarios/calls.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/scenarios/failure.h"
#include "transpiler/sim/clock.h"
#include "transpiler/support/check.h"

namespace plcxx::scenarios {
namespace {

/// What a step answers: none, or why it failed.
using Verdict = std::optional<std::string>;

std::string ListText(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return "[" + text + "]";
}

class Runner {
 public:
  explicit Runner(ScenarioRun run)
      : run_(std::move(run)),
        clock_(run_.program, {&run_.engines}),
        control_(run_.program, run_.dialect, run_.engines, std::move(run_.stub)) {
    clock_.before_period = [this](uint32_t now_ms) { control_.BeforePeriod(now_ms); };
    clock_.after_period = [this](uint32_t now_ms) { AfterPeriod(now_ms); };
    clock_.interrupted = [this] {
      return run_.engines.difference() || run_.engines.false_fact() || Violation() != nullptr;
    };
  }

  Verdict Run() {
    if (run_.plan.plant) control_.Attach(run_.plan.plant);
    clock_.PowerOn();
    control_.PowerOn();
    if (run_.monitor != nullptr) run_.monitor->PowerOn();
    for (const PlannedStep& step : run_.plan.steps) {
      step_ = &step;
      Verdict verdict = std::visit([this](const auto& action) { return Do(action); }, step.written->action);
      run_.engines.CatchUp();
      // A difference explains a wrong value, so it is told first.
      if (run_.engines.difference()) return Differ(*run_.engines.difference());
      if (const Verdict false_fact = FindFalseFact()) return false_fact;
      if (verdict) return verdict;
      if (Violation() != nullptr) return Failed(step.written->mark, *Violation());
    }
    return std::nullopt;
  }

 private:
  void AfterPeriod(uint32_t now_ms) {
    if (run_.trace != nullptr) run_.trace->Record(before_power_cycles_ms_ + clock_.time_ms(), control_.Reader());
    control_.AfterPeriod(now_ms);
    if (run_.monitor != nullptr) run_.monitor->AfterPart(run_.engines, clock_.last_part());
  }

  /// Of a property; none: there is none so far.
  const std::string* Violation() const {
    return run_.monitor != nullptr && run_.monitor->violation() ? &*run_.monitor->violation() : nullptr;
  }

  /// Of a program that is compiled with checked facts: code was left out, or chosen, for a reason that does not hold.
  Verdict FindFalseFact() const {
    if (!run_.engines.false_fact()) return std::nullopt;
    return Failed(step_->written->mark, FalseFactText(*run_.engines.false_fact(), run_.program, run_.sources));
  }

  std::string Failed(ScenarioMark mark, const std::string& message) const {
    return StepFailure(run_.scenario, *step_->written, mark, clock_.time_ms(), message);
  }

  std::string Differ(const engines::Difference& difference) const {
    std::string text = StepFailure(run_.scenario, *step_->written, step_->written->mark, difference.now_ms,
                                   DifferenceText(difference));
    if (difference.place) {
      text +=
          "\n" + LastWritesText(difference.what, {.place = *difference.place}, run_.writes, run_.program, run_.sources);
    }
    return text;
  }

  Verdict Do(const SetStep&) {
    for (const PlannedValue& planned : step_->values) {
      if (planned.location.text_input) {
        run_.engines.SendText(planned.text);
        continue;
      }
      if (planned.location.absent) {
        if (!absent_forces_.contains(planned.location.place.name))
          absent_values_[planned.location.place.name] = planned.value;
        continue;
      }
      control_.Set(planned.location, planned.value);
    }
    return std::nullopt;
  }

  Verdict Do(const ForceStep&) {
    for (const PlannedValue& planned : step_->values) {
      if (planned.location.absent) {
        absent_forces_[planned.location.place.name] = absent_values_[planned.location.place.name] = planned.value;
      } else {
        for (const auto& [place, value] : WritesTo(planned.location, planned.value)) run_.engines.Force(place, value);
      }
    }
    return std::nullopt;
  }

  Verdict Do(const ReleaseStep&) {
    for (const PlannedValue& planned : step_->values) {
      if (planned.location.absent) {
        absent_forces_.erase(planned.location.place.name);
      } else {
        for (const auto& [place, value] : WritesTo(planned.location, 0)) run_.engines.Release(place);
      }
    }
    return std::nullopt;
  }

  Verdict Do(const RunStep& run) {
    for (const RunPart& part : run.parts) {
      switch (RunOn(clock_, part)) {
        case sim::Step::kDone:
          break;
        case sim::Step::kInterrupted:
          return std::nullopt;
        case sim::Step::kStuck:
          return Failed(step_->written->mark, "the part was not completed within " +
                                                  std::to_string(run_.program.schedule.most_periods) + " periods");
      }
    }
    return std::nullopt;
  }

  Verdict Do(const ExpectStep&) {
    std::string text;
    for (const PlannedValue& planned : step_->values) {
      if (const Verdict verdict = Expect(planned)) text += (text.empty() ? "" : "\n") + *verdict;
    }
    if (text.empty()) return std::nullopt;
    return text;
  }

  Verdict Expect(const PlannedValue& planned) {
    const dialects::Location& location = planned.location;
    const ir::Place& place = location.place;
    const auto text = [&](uint64_t value) { return engines::ValueText(place.type, value, SignOf(location)); };
    const auto right = [&](uint64_t value) { return sim::SameValue(place.type, value, planned.value); };
    const std::string expected = "expected " + planned.written.text + " = " + text(planned.value) + ", found ";
    if (location.absent || location.cell) {
      const uint64_t value = location.cell ? control_.ReadCell(*location.cell) : AbsentValue(place.name);
      if (right(value)) return std::nullopt;
      const std::string why = location.absent ? ": the program does not use it" : "";
      return Failed(planned.written.mark, expected + text(value) + why);
    }
    bool wrong = false;
    std::string found;
    for (const auto& engine : run_.engines.engines()) {
      const uint64_t value = ReadLocation(*engine, location);
      wrong |= !right(value);
      if (text(value) == found) continue;
      found += (found.empty() ? "" : ", but in " + std::string(engine->name()) + " ") + text(value);
    }
    if (!wrong) return std::nullopt;
    if (run_.unmet != nullptr) run_.unmet->push_back(&planned);
    return Failed(planned.written.mark, expected + found) + "\n" +
           LastWritesText(planned.written.text, location, run_.writes, run_.program, run_.sources);
  }

  uint64_t AbsentValue(const std::string& name) const {
    const auto known = absent_values_.find(name);
    return known == absent_values_.end() ? 0 : known->second;
  }

  Verdict Do(const ExpectCallsStep&) {
    const std::vector<sim::HostEvent> events = run_.engines.TakeEvents();
    const Verdict mismatch = CallsMismatch(run_.program, step_->calls, events);
    if (!mismatch) return std::nullopt;
    return Failed(step_->written->mark, *mismatch);
  }

  Verdict Do(const ExpectMessagesStep& expect) {
    const std::vector<ShownMessage> shown = control_.TakeMessages();
    const bool equal = std::equal(expect.messages.begin(), expect.messages.end(), shown.begin(), shown.end(), Names);
    if (equal) return std::nullopt;
    std::vector<std::string> words;
    for (const ShownMessage& message : shown) {
      words.push_back(message.text.empty() ? std::to_string(message.number) : "'" + message.text + "'");
    }
    return Failed(step_->written->mark,
                  "expected messages " + ListText(expect.messages) + ", found " + ListText(words));
  }

  Verdict Do(const PowerCycleStep&) {
    before_power_cycles_ms_ += clock_.time_ms();
    control_.PowerOff();
    clock_.PowerCycle();
    control_.PowerOn();
    if (run_.monitor != nullptr) run_.monitor->PowerOn();
    absent_values_ = absent_forces_;
    return std::nullopt;
  }

  ScenarioRun run_;
  sim::Clock clock_;
  ScenarioControl control_;
  const PlannedStep* step_ = nullptr;
  /// Timers and the like that the program does not use: what the scenario wrote into them, by name.
  std::map<std::string, uint64_t> absent_values_, absent_forces_;
  uint64_t before_power_cycles_ms_ = 0;  // the waveform goes on where the time starts again
};

}  // namespace

sim::Step RunOn(sim::Clock& clock, const RunPart& part) {
  switch (part.unit) {
    case RunUnit::kSlowCycles:
      return clock.RunSlow(part.count);
    case RunUnit::kFastTicks:
      return clock.RunFast(part.count);
    case RunUnit::kMilliseconds:
      return clock.RunMs(part.count);
  }
  PLCXX_UNREACHABLE();
}

std::optional<std::string> RunScenario(ScenarioRun run) { return Runner(std::move(run)).Run(); }

std::vector<sim::Watched> WatchedLocations(const ScenarioPlan& plan, const ir::Program& program) {
  std::vector<sim::Watched> watched;
  for (const PlannedStep& step : plan.steps) {
    for (const PlannedValue& planned : step.values) {
      if (planned.location.text_input || planned.location.absent) continue;
      const std::string& name = planned.written.text;
      const bool there =
          std::any_of(watched.begin(), watched.end(), [&](const sim::Watched& w) { return w.name == name; });
      if (!there) watched.push_back(WatchLocation(program, name, planned.location));
    }
  }
  return watched;
}

}  // namespace plcxx::scenarios
