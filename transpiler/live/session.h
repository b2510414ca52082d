// One program being looked at: running or not, where it stops, what is watched and what it has said.
//
// In: wishes of the operator (commands.h reads them), and real time (how many periods are due). Out: the machine after
// each of them, to be shown (state_view.h). Nothing here runs by itself, and one caller at a time is served. Not its
// job: HTTP and threads.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/ir/name_index.h"
#include "transpiler/live/chart.h"
#include "transpiler/live/condition.h"
#include "transpiler/live/panel.h"
#include "transpiler/live/signals.h"
#include "transpiler/live/timeline.h"
#include "transpiler/report/program_input.h"

namespace plcxx::live {

/// Why a wish was not granted; lower case, no full stop. Empty: it was.
using Refusal = std::string;

enum class StepKind : uint8_t { kPeriod, kFast, kSlow, kSlice, kStatement };

enum class BreakKind : uint8_t { kStatement, kChange, kCondition };
struct Breakpoint {
  uint32_t number = 0;
  BreakKind kind{};
  std::string text;  // of a change the location, of a condition itself
  ir::StatementId statement;
  std::optional<sim::Watched> location;  // of a change
  std::optional<uint64_t> last;          // of a change: the value before
  std::optional<Condition> condition;
};
inline constexpr size_t kMostBreakpoints = 64;

/// What the machine has said.
enum class NoteKind : uint8_t { kMessage, kCall, kFault, kLink };
struct Note {
  uint64_t period = 0, time_ms = 0;
  NoteKind kind{};
  std::string text;
  ir::StatementId statement;  // of a fault: where
};
inline constexpr size_t kMostNotes = 200;

/// What is known of a running machine that is shown instead of a simulated one.
struct LinkStatus {
  std::string address;
  bool is_connected = false;
  std::string reason;      // why it is not; lower case, no full stop
  bool can_write = false;  // there is code that writes; now it may only with
  bool may_write = false;
  uint32_t forced_bytes = 0;  // whoever has forced them
  uint32_t scans = 0;
  uint64_t lost = 0;      // samples of what is watched now, for which the wire was too slow
  uint64_t round_ms = 0;  // in which all of State was read last
};

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

  Refusal Set(const std::string& name, const std::string& value);
  Refusal Toggle(const std::string& name);
  Refusal Force(const std::string& name, const std::string& value);
  Refusal Release(const std::string& name);
  Refusal ReleaseAll();
  Refusal SwitchStatement(ir::StatementId statement, bool on);
  Refusal SwitchAllOn();
  Refusal PowerOff();
  Refusal PowerOn();
  Refusal Expect(const std::vector<std::string>& names);
  Refusal ExpectMessages();

  /// Of controls of the panel, by number.
  Refusal PressPanel(size_t control);
  Refusal ReleasePanel(size_t control);
  Refusal TurnPanel(size_t control, size_t position);

  Refusal BreakAtStatement(ir::StatementId statement, bool on);
  Refusal BreakAtChange(const std::string& name);
  Refusal BreakAtCondition(const std::string& text);
  Refusal RemoveBreakpoint(uint32_t number);

  Refusal Watch(const std::string& name);
  Refusal Unwatch(size_t number);
  struct TriggerWish {
    std::string edge;  // "rising", "falling", "condition"
    std::string text;  // the bit, or the condition
    uint32_t base_ms = 0, delay_ms = 0, samples = 0, before_percent = 0;
  };
  Refusal Arm(const TriggerWish& wish);
  void Disarm() { chart_.Disarm(); }

  /// Of a running machine (linked_machine.h). From the first status on nothing runs here, and time is the machine's.
  void ShowLink(LinkStatus status) { link_ = std::move(status); }
  const std::optional<LinkStatus>& link() const { return link_; }
  /// One for each watched location, after the scan of this number.
  void TakeSample(uint32_t scan, const std::vector<uint64_t>& values);
  /// Those that were reported before, without a break, are not news.
  void TakeFaults(const std::vector<sim::HostEvent>& faults);
  void SetForced(std::vector<Forced> forced) { forced_ = std::move(forced); }
  void NoteOfLink(std::string text);

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
  const BoundPanel* panel() const { return panel_.get(); }
  std::vector<ControlState> PanelStates();
  /// "turret 'tools' (plant.yaml:7)"; empty: the plant does not drive it.
  std::string DriverOf(const dialects::Location& location) const;
  const std::vector<Breakpoint>& breakpoints() const { return breakpoints_; }
  const std::vector<Forced>& forced() const { return forced_; }
  const std::deque<Note>& notes() const { return notes_; }
  uint32_t notes_version() const { return notes_version_; }
  std::vector<std::string> ActiveMessages();
  uint32_t unit_ms() const { return sim::UnitMs(program().schedule); }

 private:
  Refusal Do(Action action);
  /// Runs the rest of a period; true: nothing stopped it.
  bool Period(const Advance& advance);
  void Observe(uint64_t period);
  /// Why it stops after the period; empty: it does not.
  std::string BreaksAfterPeriod();
  void WentElsewhere();
  enum class Zeros : uint8_t { kWritten, kLeftOut };
  void Write(const plant::PanelControl& control, size_t position, Zeros zeros);
  void PutPanelBack(const std::vector<ControlState>& before);
  /// Buttons that were released before they had been pressed long enough.
  void LetButtonsGo();
  void AddNote(Note note);
  void FindForced();
  Machine::StopAt StatementStops();
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
  std::vector<Breakpoint> breakpoints_;
  uint32_t next_breakpoint_ = 1;
  std::vector<bool> stops_at_;  // by StatementId
  std::vector<Forced> forced_;
  struct Held {
    bool is_pressed = false, is_let_go = false;  // of a button
    uint64_t since_ms = 0;
    std::optional<int64_t> position;  // of what stays where it is put, before the period
    uint64_t period = 0;
  };
  std::shared_ptr<const scenarios::BoundPlant> plant_;
  std::shared_ptr<const BoundPanel> panel_;
  std::vector<Held> held_;  // by control of the panel
  std::deque<Note> notes_;
  uint32_t notes_version_ = 0;
  bool is_running_ = false, is_on_ = true;
  double speed_ = 1;
  std::string why_stopped_, opened_;
  std::optional<LinkStatus> link_;
  std::vector<std::string> faults_;  // of the scan that was computed again last
};

}  // namespace plcxx::live
