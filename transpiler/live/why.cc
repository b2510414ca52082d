#include "transpiler/live/why.h"

#include <memory>
#include <utility>

#include "transpiler/explanation/recorder.h"
#include "transpiler/live/locations.h"
#include "transpiler/scenarios/why.h"

namespace plcxx::live {
namespace {

constexpr size_t kMaxLines = 40;
/// Periods that are repeated at least, where there are so many: what was kept is followed back in them.
constexpr uint64_t kRepeated = 64;

/// Does to a copy of the machine what was done to the machine since a checkpoint.
class Repetition {
 public:
  Repetition(const Session& session, explanation::Recorder& recorder)
      : session_(session),
        recorder_(recorder),
        control_(session.program(), *session.compilation().dialect, recorder, StubOf(session.compilation())),
        clock_(session.program(), {&recorder}) {
    clock_.before_period = [this](uint32_t now_ms) { control_.BeforePeriod(now_ms); };
    clock_.after_period = [this](uint32_t now_ms) { control_.AfterPeriod(now_ms); };
  }

  void Run() {
    const Timeline& timeline = session_.timeline();
    const Timeline::Replay from = timeline.ReplayFrom(kRepeated);
    recorder_.Restore(from.saved->simulator);
    recorder_.RestoreNoted(from.saved->noted);
    control_.Restore(from.saved->control);
    control_.RestoreMessages(from.saved->messages);
    for (uint32_t i = 0; i < from.saved->off.size(); ++i) {
      recorder_.EnableStatement(ir::StatementId(i), !from.saved->off[i]);
    }
    clock_.GoTo(from.saved->time_ms);
    for (uint64_t period = from.first; period <= timeline.period(); ++period) {
      for (const Entry& entry : timeline.entries()) {
        if (entry.period == period) Do(entry.action);
      }
      if (period < timeline.period()) Machine::RunOn(clock_, timeline.AdvanceOf(period));
    }
  }

 private:
  void Do(const Action& action) {
    const auto writes = [&] { return scenarios::WritesTo(action.location, action.value); };
    switch (action.kind) {
      case ActionKind::kSet:
        control_.Set(action.location, action.value);
        return;
      case ActionKind::kForce:
        for (const auto& [place, value] : writes()) recorder_.Force(place, value);
        return;
      case ActionKind::kRelease:
        for (const auto& [place, value] : writes()) recorder_.Release(place);
        return;
      case ActionKind::kText:
        recorder_.SendText(action.text);
        return;
      case ActionKind::kSwitchOff:
      case ActionKind::kSwitchOn:
        recorder_.EnableStatement(action.statement, action.kind == ActionKind::kSwitchOn);
        return;
      case ActionKind::kPowerCycle:
        control_.PowerOff();
        clock_.PowerCycle();
        control_.PowerOn();
        return;
      case ActionKind::kExpect:
      case ActionKind::kExpectMessages:
        return;
    }
  }

  const Session& session_;
  explanation::Recorder& recorder_;
  scenarios::ScenarioControl control_;
  sim::Clock clock_;
};

}  // namespace

Reasons WhyNow(Session& session, const std::string& name) {
  const compilation::Compilation& compilation = session.compilation();
  const auto found = FindLocation(compilation, name);
  if (const auto* refusal = std::get_if<std::string>(&found)) return {{}, *refusal};
  const auto& location = std::get<dialects::Location>(found);
  if (std::string why = scenarios::CannotBeExplained(compilation, location); !why.empty()) return {{}, why};
  for (const bool off : session.timeline().machine().off()) {
    if (off) return {{}, "statements are switched off: switch them on to ask why"};
  }
  if (session.timeline().period() == session.timeline().first()) return {{}, "nothing has run yet"};
  const scenarios::WhyQuestion question{.name = name, .location = location, .steps = {}, .time_ms = {}};
  const scenarios::WhyAnswer answer =
      scenarios::ExplainInRun(compilation, question,
                              [&](std::unique_ptr<explanation::Recorder> recorder,
                                  const std::function<void()>& look) -> std::optional<std::string> {
                                Repetition(session, *recorder).Run();
                                look();
                                return std::nullopt;
                              });
  if (!answer.refusal.empty()) return {{}, answer.refusal};
  return {scenarios::WhyText(answer, question, compilation, kMaxLines), {}};
}

}  // namespace plcxx::live
