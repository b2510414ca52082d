// One program being looked at: running or not, where it stops, what is watched and what it has said.
//
// In: wishes of the operator (commands.h reads them), and real time (how many periods are due). Out: the machine after
// each of them, to be shown (state_view.h). Nothing here runs by itself, and one caller at a time is served. Not its
// job: HTTP and threads.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/ir/name_index.h"
#include "transpiler/live/breakpoints.h"
#include "transpiler/live/chart.h"
#include "transpiler/live/condition.h"
#include "transpiler/live/notes.h"
#include "transpiler/live/panel_hands.h"
#include "transpiler/live/refusal.h"
#include "transpiler/live/shown_link.h"
#include "transpiler/live/signals.h"
#include "transpiler/live/timeline.h"
#include "transpiler/report/program_input.h"

namespace plcxx::live {

enum class StepKind : uint8_t { kPeriod, kFast, kSlow, kSlice, kStatement };

struct Forced {
  std::string name;
  dialects::Location location;
  uint64_t value = 0;
};

class Session {
 public:
  /// Both outlive it; `input` is of `compilation`.
  Session(const compilation::Compilation& compilation, const report::ProgramInput& input);

  /// The machine around the program and the panel; each may be none. At delivery.
  void Equip(std::shared_ptr<const scenarios::BoundPlant> plant, std::shared_ptr<const BoundPanel> panel);
  void Restart();
  /// The same, and the panel is put as it is at delivery.
  void BeginAnew();
  Refusal Run();
  void Pause(std::string why);
  Refusal SetSpeed(double times);
  /// Until so many periods have been run, or something stops it. Gives how many were.
  uint64_t RunPeriods(uint64_t most);

  bool CanStep(StepKind kind) const;
  Refusal Step(StepKind kind);
  Refusal Back(uint64_t periods);
  Refusal BackStatement();
  Refusal GoTo(uint64_t period);

  Refusal PowerOff();
  Refusal PowerOn();
  /// Becomes a part of the recording, behind the period that is half done.
  Refusal Do(Action action);

  /// Of a scenario that is opened: done, and run, without a look at breakpoints.
  void DoRecorded(Action action);
  void RunRecorded(const Advance& advance);
  /// What is shown beside the machine: which scenario was opened, and where it failed.
  void SetOpened(std::string text) { opened_ = std::move(text); }

  /// Where a name is in the program, or why nowhere.
  std::variant<dialects::Location, std::string> Find(const std::string& name) const;
  const compilation::Compilation& compilation() const { return compilation_; }
  const ir::Program& program() const { return compilation_.program; }
  const report::ProgramInput& input() const { return input_; }
  const report::CrossReference& uses() const { return uses_; }
  const SignalTable& signals() const { return signals_; }
  Timeline& timeline() { return timeline_; }
  const Timeline& timeline() const { return timeline_; }
  Chart& chart() { return chart_; }
  const Chart& chart() const { return chart_; }
  bool is_running() const { return is_running_; }
  bool is_on() const { return is_on_; }
  double speed() const { return speed_; }  // of real time; 0: as fast as possible
  const std::string& why_stopped() const { return why_stopped_; }
  const std::string& opened() const { return opened_; }
  PanelHands& hands() { return hands_; }
  const PanelHands& hands() const { return hands_; }
  /// "turret 'tools' (plant.yaml:7)"; empty: the plant does not drive it.
  std::string DriverOf(const dialects::Location& location) const;
  Breakpoints& breakpoints() { return breakpoints_; }
  const Breakpoints& breakpoints() const { return breakpoints_; }
  const ConditionContext& conditions() const { return conditions_; }
  const std::vector<Forced>& forced() const { return forced_; }
  /// Of a running machine, where whoever has forced it is asked.
  void SetForced(std::vector<Forced> forced) { forced_ = std::move(forced); }
  const Notes& notes() const { return notes_; }
  /// Of a running machine (linked_machine.h).
  ShownLink& link() { return link_; }
  const ShownLink& link() const { return link_; }
  uint32_t unit_ms() const { return sim::UnitMs(program().schedule); }

 private:
  /// Runs the rest of a period; true: nothing stopped it.
  bool Period(const Advance& advance);
  void Observe(uint64_t period);
  void WentElsewhere();
  void FindForced();
  uint64_t Count(ir::PlaceId counter);
  Refusal StepUntil(ir::PlaceId counter);

  const compilation::Compilation& compilation_;
  const ir::NameIndex names_;
  const report::ProgramInput& input_;
  report::CrossReference uses_;
  SignalTable signals_;
  ConditionContext conditions_;
  Timeline timeline_;
  Chart chart_;
  Breakpoints breakpoints_;
  std::vector<Forced> forced_;
  std::shared_ptr<const scenarios::BoundPlant> plant_;
  PanelHands hands_;
  Notes notes_;
  ShownLink link_{compilation_.program, timeline_, chart_, notes_};
  bool is_running_ = false, is_on_ = true;
  double speed_ = 1;
  std::string why_stopped_, opened_;
};

}  // namespace plcxx::live
