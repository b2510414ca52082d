// The search for runs in which two versions differ, from the machine at work towards what was changed.
//
// Both versions run beside each other in the simulator. First come the scenarios that stand beside the old version, as
// they are. Then it goes back again and again to a moment that was seen, and does something unexpected there. Moments
// that are gone back to: those at which something differs already, for more follows from it; those at which what the
// changed statements read was not seen like this before; those at which something that this is computed from has a
// value for the first time, as the step of a sequence that leads there; those between two steps of a scenario. Of each
// such a solver is asked what has to be set there so that a difference is seen within a few periods: that hits what has
// to be set in one scan. In: two versions. Out: a run for each cell that was seen to differ. Not its job: making a run
// short, proofs.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/prove/diff/wide_runs.h"
#include "transpiler/review/diff/machine.h"
#include "transpiler/review/diff/runs.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::review::diff {

class DirectedSearch {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `cells`: of the old version, what is looked at. All outlive the search.
  DirectedSearch(const DiffSide& old_side, const DiffSide& new_side, const prove::machine::Version& old_version,
                 const prove::machine::Version& new_version, const prove::diff::Match& match,
                 const CellWords& old_words, const std::vector<execute::CellId>& cells);

  /// The scenarios, once; `end` is the time for that.
  void RunScenarios(Time end, RandomRuns& result);
  /// Runs that a solver computed, each once: from their ends there is more to be seen.
  void Follow(const std::vector<prove::diff::Run>& computed, Time end, RandomRuns& result);
  /// Until `end`, or until each of `sought` (old cells, those that matter most first) has differed.
  void Run(const std::vector<execute::CellId>& sought, Time end, RandomRuns& result);
  /// The same with runs that were seen to differ in many lanes at once (prove/diff/wide_runs.h), each repeated here.
  void RunWide(const std::vector<execute::CellId>& sought, Time end, RandomRuns& result);
  /// The same from the moments that are kept: where that was not done yet each input near the change is changed there,
  /// one by one, and held; then several are, of all moments.
  void RunWideFromMoments(const std::vector<execute::CellId>& sought, Time end, RandomRuns& result);
  /// Runs that begin with something in memory that is kept without power: to be called when others have shown nothing.
  void BeginWithKept(Time end, RandomRuns& result);
  /// What was seen to advance a number is done again and again, as far as the programs have constants that it may be
  /// compared with: farther at each call.
  void RunCounts(const std::vector<execute::CellId>& sought, Time end, RandomRuns& result);
  /// Whether the versions have different constants, so that a limit of a count is another one, perhaps.
  bool has_changed_constants() const { return has_changed_constants_; }
  /// The moments that are kept, as one version saw them.
  void ForEachSeenState(prove::diff::Which which,
                        const std::function<void(const prove::invariants::CellValues&, uint64_t now_ms)>& visit);
  /// As both saw them.
  void ForEachSeenPair(const std::function<void(const prove::invariants::CellValues& of_old,
                                                const prove::invariants::CellValues& of_new, uint64_t now_ms)>& visit);

 private:
  /// Bits that are set together: an input, or a word of inputs.
  using Input = std::vector<prove::diff::SetCell>;
  /// Of the watched pairs those that are in one byte of both pictures, or one field.
  struct Compared {
    uint32_t old_at = 0, new_at = 0, bytes = 1;
    uint8_t mask = 0xFF;
    std::vector<execute::CellId> cells;
  };
  struct Moment {
    DiffMachine::Saved old_saved, new_saved;
    Stimuli stimuli;  // from power-on
    uint64_t periods = 0;
    size_t scenario = 0, next_step = 0;  // of the known runs, of which it is the continuation
    bool is_asked = false;               // what has to be set there
    bool is_spread = false;              // each input near the change was changed there
    bool is_waited = false;              // and what was begun there was given time
    bool is_counted = false;             // and numbers were counted on from there
  };
  using Moments = std::vector<std::shared_ptr<Moment>>;
  /// A number that the program writes, where the picture of the old version has it.
  struct Counter {
    uint32_t at = 0, new_at = 0;  // its lowest byte
    uint32_t bytes = 0;
    bool is_big = false;                      // the other bytes come before it
    uint32_t rank = 0;                        // 0: the changed statements read it
    std::vector<execute::CellId> cells = {};  // of the old version, from the lowest
    bool is_asked = false;                    // what advances it
    uint64_t before = 0, magnitudes = 0;
    size_t pulses = 0;
    std::set<uint64_t> passed = {};  // constants, of each of which the moment is kept

    uint64_t Value(const std::vector<uint8_t>& picture, uint32_t lowest) const;
  };
  /// A run at whose end a number went on by a few.
  struct Pulse {
    size_t counter = 0;
    Stimuli run;
  };
  /// Another number that goes on now and then while one is counted, as one that counts its carries.
  struct Carried {
    size_t counter = 0;
    uint64_t value = 0;
    uint64_t at = 0, times = 0;  // that it went on: after so many counts the last time
  };
  /// Steps that advance it each time, and how often that was done.
  struct Counting {
    size_t counter = 0;
    uint64_t advance = 0;
    std::shared_ptr<Moment> at;
    Stimuli cycle;
    std::shared_ptr<Moment> begin = {};  // of all counts
    bool is_varied = false;              // and done with other inputs, too
    uint64_t done = 0;
    uint64_t most = 0;  // that it is worth to be done, by the carries; at least most_counted_
    std::vector<Carried> carried = {};
    uint32_t stops = 0;  // in a row
    bool is_over = false;
    bool differs = false;       // something does where it is
    bool from_differs = false;  // something did where it began
  };
  /// Why a moment is kept.
  enum class Kept : uint8_t { kDiffers, kNew, kOnTheWay, kBetweenSteps };

  /// The scenarios beside the old version; what has another name in the new version is set by its cells.
  void ReadScenarios();
  void SetKnown(const std::pair<std::string, std::string>& word, Stimulus& stimulus) const;
  void MakePlan(const std::vector<execute::CellId>& cells);
  void FindInputs(bool with_needed);
  void EndAt(Time end);
  prove::diff::WideRuns& Wide();
  /// The versions for a solver that looks ahead, without what the control clears.
  prove::diff::UnrolledVersions Unrollable() const;
  /// Where both are now.
  prove::diff::SeenState Seen() const;
  bool Late() const { return std::chrono::steady_clock::now() >= end_; }
  void GoTo(const Moment& moment);
  Moment Here() const;
  void Keep(Kept why);
  /// Goes back to a moment.
  void GoBack();
  /// Keeps the moments at which others have shown a difference: waiting and counting from power-on come to some that
  /// nothing here comes to.
  void KeepShown(RandomRuns& result);
  /// One step, in pieces so that what differs for a moment only is seen. false: it is late, or a version is stuck.
  bool Step(const Stimulus& stimulus, RandomRuns& result);
  /// Compares the pictures; notes what was not seen to differ before.
  void Compare(RandomRuns& result);
  /// A number for what the changed statements read.
  uint64_t Signature() const;
  /// Whether something behind the changed statements has a value for the first time, or one of another magnitude.
  bool HasFirstValue();
  Stimulus Unexpected();
  /// A part of all inputs gets other values.
  void DisturbMany(Stimulus& stimulus);
  /// The next moment of which the solver was not asked yet; null: there is none.
  Moment* NextToAsk();
  /// The next moment at which nobody waited yet, what was kept last first; null: there is none.
  Moment* NextToWait();
  /// Lets time pass there, as timers need it.
  void Wait(Moment& moment, RandomRuns& result);
  /// Does what a run sets, by time, and compares after each period.
  void Repeat(const prove::diff::Run& run, uint32_t period_ms, RandomRuns& result);
  /// Asks the solver what has to be set at the moment, and does that.
  void Aim(Moment& moment, const std::vector<execute::CellId>& sought, RandomRuns& result);
  void Disturb(const Input& input, std::vector<prove::diff::SetCell>& sets);
  void FindCounters();
  /// Before a step, and what it advanced.
  void LookAtCounters();
  void NoteAdvances();
  /// Both versions do it, and are looked at.
  bool Apply(const Stimulus& stimulus);
  /// What it will set, as it is now.
  Stimulus Undone(const Stimulus& stimulus) const;
  /// What may advance a number once more, shorter ways first; both versions are at the end of its run after that.
  std::vector<Stimuli> PulsesOf(const Pulse& pulse);
  /// Asks the solver what advances the numbers near the change that were not seen to advance.
  void AimAtCounters(RandomRuns& result);
  /// How far the steps take a number each time, if it is always as far; else 0.
  uint64_t AdvanceBy(const Stimuli& cycle, const Counter& counter, const Moment& begin);
  void FindCounting(const Pulse& pulse);
  void FindCountings(Time end);
  /// What is known to advance a number is begun where something differs already: a limit shows more of it.
  void FindCountingsFromDiffering();
  /// What was counted to its end is counted once more where one of these inputs is the opposite of what it was: it may
  /// hide what the count leads to. false: all that is done.
  bool VaryCountings(const std::vector<Input>& hiding);
  /// Inputs of one bit that the statements read which write these.
  std::vector<Input> InputsBeside(const std::vector<execute::CellId>& cells) const;
  /// Of the steps to a constant of the programs those that follow may be anything: the moment is kept.
  void KeepAtConstant(Counter& counter, uint64_t before);
  /// What counts the carries of a number needs as many counts as the two have together.
  void NoteCarries(Counting& counting);
  uint64_t ValueIn(const Counter& counter) const { return counter.Value(old_machine_.picture(), counter.at); }
  bool IsFarFromConstants(uint64_t value, uint64_t advance, uint32_t bytes) const;
  /// Many pulses, and one look; false: the number did not go on as it should, and nothing was done.
  bool CountAtOnce(Counting& counting, RandomRuns& result);
  void CountOn(Counting& counting, RandomRuns& result);
  void CompareCounted(Counting& counting, RandomRuns& result);

  const DiffSide& old_side_;
  const DiffSide& new_side_;
  const prove::machine::Version& old_version_;
  const prove::machine::Version& new_version_;
  const prove::diff::Match& match_;
  const CellWords& old_words_;
  Time end_ = Time::max();
  DiffMachine old_machine_, new_machine_;
  std::vector<Compared> compared_;
  std::vector<execute::CellId> compared_calls_;
  std::vector<Input> inputs_, behind_, near_;  // all; those after what was changed; those that it reads soon
  std::vector<Input> kept_;  // what the programs write, and keep without power: of it what that is computed from
  std::vector<prove::diff::SetCell> requests_;  // that the control clears
  std::vector<bool> is_settable_;  // by old cell: a scenario may; what one version alone has is nobody else's
  std::vector<execute::CellId> read_by_changed_;
  /// What that is computed from, and so on, without what anybody may set; by old cell which magnitudes were seen.
  std::map<execute::CellId, uint64_t> seen_behind_;
  std::vector<uint64_t> constants_;
  std::vector<Counter> counters_;
  std::vector<Pulse> pulses_;
  std::vector<Counting> countings_;
  uint64_t most_counted_ = 0;
  bool has_changed_constants_ = false;
  std::vector<uint32_t> waits_ms_;
  std::vector<Stimuli> known_;
  std::set<uint64_t> signatures_;
  Moments differing_, new_, on_the_way_, between_;
  bool waits_next_ = false;  // what was begun is given time
  Stimuli stimuli_;          // from power-on until now
  uint64_t periods_ = 0;
  size_t scenario_ = 0, next_step_ = 0;
  size_t most_moments_ = 0;
  size_t followed_ = 0;           // computed runs
  std::set<uint32_t> kept_runs_;  // of the result: its own, and those of which the moment is kept
  size_t kept_inputs_ = 0;        // of the runs that were kept
  prove::machine::Uses old_uses_, new_uses_;
  uint32_t period_ms_ = 1;
  uint32_t pass_periods_ = 1;                                            // of a whole slow pass
  std::chrono::steady_clock::duration searched_{}, aimed_{}, waited_{};  // time that each way took
  bool has_new_difference_ = false;
  bool differs_now_ = false;            // by the last comparison
  std::vector<execute::CellId> cells_;  // what is looked at
  std::optional<prove::diff::WideRuns> wide_;
  terms::Random random_{0x8EBC6AF09C88C6E3};
};

/// The pairs that the host writes and a version reads.
std::vector<prove::diff::SetCell> InputsOf(const prove::machine::Version& old_version,
                                           const prove::machine::Version& new_version, const prove::diff::Match& match);

}  // namespace plcxx::review::diff
