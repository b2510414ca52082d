#include "transpiler/scenarios/why.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "transpiler/engines/lockstep.h"
#include "transpiler/explanation/recorder.h"
#include "transpiler/scenarios/control.h"
#include "transpiler/scenarios/run.h"
#include "transpiler/sim/value_text.h"

namespace plcxx::scenarios {
namespace {

using explanation::Condition;
using explanation::ConditionKind;
using explanation::Explanation;
using explanation::Recorder;

/// Scans that are looked at for the last one that has to do with the signal; a slow part has more slices seldom.
constexpr uint32_t kMaxScansTried = 16;
/// How far back what was kept is followed, and how much of it.
constexpr uint32_t kMaxScansBack = 2;
constexpr size_t kMaxConditions = 100;

std::vector<execute::CellId> CellsOfLocation(const explanation::Subject& subject, const dialects::Location& location) {
  std::vector<execute::CellId> cells;
  const auto add = [&](const ir::Place& place) {
    if (!execute::IsInside(subject.program, place)) return;
    for (const execute::CellId cell : execute::CellsOf(subject.program, subject.cells, place)) cells.push_back(cell);
  };
  if (location.bits.empty()) add(location.place);
  for (const ir::Place& bit : location.bits) add(bit);
  return cells;
}

class Investigation {
 public:
  Investigation(const compilation::Compilation& compilation, const WhyQuestion& question, RepeatRun repeat)
      : program_(compilation.program), question_(question), repeat_(std::move(repeat)), subject_(compilation.program) {
    cells_ = CellsOfLocation(subject_, question_.location);
  }

  WhyAnswer Run() {
    std::optional<sim::LastWrite> newest;
    Execute({}, [&](Recorder& recorder) {
      parts_ = recorder.parts();
      answer_.has_run = recorder.has_run_since_power_on();
      answer_.value = sim::ValueDigits(question_.location.place.type, ReadLocation(recorder, question_.location),
                                       SignOf(question_.location));
      const auto writes = recorder.last_writes()->Of(AskedPlace());
      if (!writes.empty()) newest = writes.front();
    });
    if (!answer_.has_run) return std::move(answer_);
    answer_.time_ms = parts_.back().now_ms;
    if (newest && newest->writer != sim::Writer::kProgram) {
      Condition set{.kind = newest->writer == sim::Writer::kForce ? ConditionKind::kForced : ConditionKind::kInput,
                    .name = question_.name,
                    .label = question_.name,
                    .text = answer_.value,
                    .statement = {},
                    .last_write = newest};
      answer_.conditions.push_back(std::move(set));
      return std::move(answer_);
    }
    FindDecidingScan();
    return std::move(answer_);
  }

 private:
  ir::Place AskedPlace() const {
    return question_.location.bits.empty() ? question_.location.place : question_.location.bits.front();
  }

  template <class Look>
  void Execute(std::optional<uint32_t> last_part, Look&& look) {
    auto owned = std::make_unique<Recorder>(program_);
    Recorder& recorder = *owned;
    if (last_part) recorder.EndAfterPart(*last_part);
    if (question_.time_ms) recorder.EndAt(*question_.time_ms);
    bool has_ended = false;
    const std::optional<std::string> failure = repeat_(std::move(owned), [&] {
      has_ended = recorder.has_ended();
      look(recorder);
    });
    if (failure && !has_ended) answer_.failure = *failure;
  }

  /// What a scan did to some cells.
  Explanation ExplainPart(uint32_t part, std::span<const execute::CellId> cells, const std::string& name) {
    Explanation explanation;
    explanation.refusal = "the scan did not come about again";
    Execute(part, [&](Recorder& recorder) {
      if (recorder.frame()) explanation = explanation::Explain(subject_, *recorder.frame(), cells, name);
    });
    return explanation;
  }

  void FindDecidingScan() {
    const auto last = static_cast<uint32_t>(parts_.size()) - 1;
    std::optional<Explanation> newest;
    for (uint32_t back = 0; back < kMaxScansTried && back <= last; ++back) {
      const uint32_t part = last - back;
      if (parts_[part].session != parts_[last].session) break;
      Explanation explanation = ExplainPart(part, cells_, question_.name);
      if (!explanation.refusal.empty()) {
        answer_.refusal = explanation.refusal;
        return;
      }
      const bool decides =
          explanation.is_written || std::ranges::any_of(explanation.conditions.front().because, [&](uint32_t reason) {
            return !explanation::IsBookkeeping(explanation.conditions, reason);
          });
      if (!newest) newest = explanation;
      if (!decides) continue;
      Add(std::move(explanation), part);
      return;
    }
    // No statement that could write it was reached: it is what it was before.
    Add(std::move(*newest), last);
  }

  /// The conditions of one scan, then where what it kept comes from.
  void Add(Explanation explanation, uint32_t part) {
    answer_.conditions = std::move(explanation.conditions);
    answer_.conditions.front().text = answer_.value;
    std::vector<std::pair<uint32_t, uint32_t>> open;  // condition, the scan before which it was kept
    const auto open_all = [&](size_t from, uint32_t of_part) {
      for (size_t i = from; i < answer_.conditions.size(); ++i) {
        if (answer_.conditions[i].kind == ConditionKind::kKept) open.emplace_back(static_cast<uint32_t>(i), of_part);
      }
    };
    open_all(0, part);
    std::map<std::pair<uint32_t, execute::CellId>, uint32_t> known;  // scan and first cell: the condition
    for (uint32_t step = 0, level_end = static_cast<uint32_t>(open.size()), level = 0; step < open.size(); ++step) {
      if (step == level_end) {
        level_end = static_cast<uint32_t>(open.size());
        ++level;
      }
      if (level == kMaxScansBack || answer_.conditions.size() > kMaxConditions) return;
      const auto [number, before] = open[step];
      const std::optional<uint32_t> writer = PartThatWrote(answer_.conditions[number], before);
      if (!writer) continue;
      const auto key = std::pair(*writer, answer_.conditions[number].cells.front());
      if (known.contains(key)) continue;
      known.emplace(key, number);
      const size_t first_new = answer_.conditions.size();
      AttachEarlier(number, *writer);
      open_all(first_new, *writer);
    }
  }

  /// The scan in which what is kept became what it is.
  std::optional<uint32_t> PartThatWrote(const Condition& kept, uint32_t before) const {
    // What the schedule writes counts its scans and slices: where that comes from tells nobody anything.
    if (!kept.last_write || !kept.last_write->statement.valid()) return std::nullopt;
    for (uint32_t part = before; part > 0;) {
      --part;
      if (parts_[part].session != parts_[before].session) break;
      if (parts_[part].now_ms == static_cast<uint32_t>(kept.last_write->first_ms)) return part;
      if (parts_[part].now_ms < kept.last_write->first_ms) break;
    }
    return std::nullopt;
  }

  void AttachEarlier(uint32_t number, uint32_t part) {
    const std::vector<execute::CellId> cells = answer_.conditions[number].cells;
    Explanation earlier = ExplainPart(part, cells, answer_.conditions[number].name);
    if (!earlier.refusal.empty() || !earlier.is_written) return;
    const auto shift = static_cast<uint32_t>(answer_.conditions.size()) - 1;
    Condition& kept = answer_.conditions[number];
    kept.statement = earlier.conditions.front().statement;
    for (const uint32_t reason : earlier.conditions.front().because) kept.because.push_back(reason + shift);
    for (size_t i = 1; i < earlier.conditions.size(); ++i) {
      Condition& condition = earlier.conditions[i];
      for (uint32_t& reason : condition.because) reason += shift;
      answer_.conditions.push_back(std::move(condition));
    }
  }

  const ir::Program& program_;
  const WhyQuestion& question_;
  RepeatRun repeat_;
  explanation::Subject subject_;
  std::vector<execute::CellId> cells_;
  std::vector<Recorder::Part> parts_;
  WhyAnswer answer_;
};

}  // namespace

std::string CannotBeExplained(const compilation::Compilation& compilation, const dialects::Location& location) {
  if (location.text_input) return "it is the operator's keyboard";
  if (location.absent) return "the program does not use it, so that it is always 0";
  if (location.cell) return "it is the simulated control's own, not the program's";
  const auto inside = [&](const ir::Place& place) { return execute::IsInside(compilation.program, place); };
  if (location.bits.empty() ? !inside(location.place) : !std::ranges::all_of(location.bits, inside)) {
    return "it is not in the program's memory";
  }
  return {};
}

WhyAnswer ExplainInRun(const compilation::Compilation& compilation, const WhyQuestion& question, RepeatRun repeat) {
  return Investigation(compilation, question, std::move(repeat)).Run();
}

WhyAnswer ExplainInScenario(const compilation::Compilation& compilation, const Scenario& scenario, ScenarioPlan plan,
                            const WhyQuestion& question) {
  if (question.steps && *question.steps < plan.steps.size()) plan.steps.resize(*question.steps);
  return ExplainInRun(
      compilation, question,
      [&](std::unique_ptr<Recorder> recorder, const std::function<void()>& look) -> std::optional<std::string> {
        const sim::LastWrites* const writes = recorder->last_writes();
        std::vector<std::unique_ptr<sim::Engine>> engines;
        engines.push_back(std::move(recorder));
        engines::Lockstep lockstep(compilation.program, std::move(engines));
        std::optional<std::string> failure = RunScenario({.scenario = scenario,
                                                          .plan = plan,
                                                          .dialect = *compilation.dialect,
                                                          .program = compilation.program,
                                                          .sources = *compilation.sources,
                                                          .engines = lockstep,
                                                          .writes = writes,
                                                          .stub = StubOf(compilation)});
        look();
        return failure;
      });
}

void ShiftTimes(WhyAnswer& answer, uint64_t origin_ms) {
  if (!answer.has_run) return;
  answer.time_ms += origin_ms;
  for (Condition& condition : answer.conditions) {
    condition.time_ms += origin_ms;
    if (!condition.last_write) continue;
    condition.last_write->first_ms += origin_ms;
    condition.last_write->last_ms += origin_ms;
  }
}

}  // namespace plcxx::scenarios
