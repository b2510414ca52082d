// Both versions beside each other in the simulator, and the moments that a search goes back to.
//
// In: two versions, steps. Out: what differs after each step, in a RandomRuns; the moments that are worth going back
// to. Not its job: which steps are done (search.h, counts.h).
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "transpiler/prove/diff/wide_runs.h"
#include "transpiler/review/diff/machine.h"
#include "transpiler/review/diff/runs.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::review::diff {

/// Bits that are set together: an input, or a word of inputs.
using Input = std::vector<prove::diff::SetCell>;

/// What the changed statements read, and what that is computed from: which values of it were seen.
class News {
 public:
  News() = default;
  /// By old cells, ascending. `before`: without what anybody may set.
  News(std::vector<execute::CellId> read, const std::vector<execute::CellId>& before);

  const std::vector<execute::CellId>& read() const { return read_; }
  bool IsRead(execute::CellId old_cell) const { return std::ranges::binary_search(read_, old_cell); }
  bool IsBefore(execute::CellId old_cell) const { return before_.contains(old_cell); }

  enum class Kind : uint8_t { kNone, kRead, kBefore };
  /// What the machines have for the first time now: what is read, a value of this kind; what is before, a magnitude.
  Kind Note(const DiffMachine& old_machine, const DiffMachine& new_machine, const prove::diff::Match& match);

 private:
  uint64_t Signature(const DiffMachine& old_machine, const DiffMachine& new_machine,
                     const prove::diff::Match& match) const;
  bool NoteMagnitudes(const DiffMachine& old_machine);

  std::vector<execute::CellId> read_;
  std::map<execute::CellId, uint64_t> before_;  // by old cell which magnitudes were seen
  std::set<uint64_t> signatures_;
};

class PairedMachines {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// In which of the known runs it is, and which of its steps is the next.
  struct KnownPosition {
    size_t scenario = 0, next_step = 0;
  };
  struct Moment {
    DiffMachine::Saved old_saved, new_saved;
    Stimuli stimuli;  // from power-on
    uint64_t periods = 0;
    KnownPosition known;      // of which it is the continuation
    bool is_asked = false;    // what has to be set there
    bool is_spread = false;   // each input near the change was changed there
    bool is_waited = false;   // and what was begun there was given time
    bool is_counted = false;  // and numbers were counted on from there
  };
  using Moments = std::vector<std::shared_ptr<Moment>>;
  /// Why a moment is kept.
  enum class Kept : uint8_t { kDiffers, kNew, kOnTheWay, kBetweenSteps };

  /// Powered on, for all the time that there is. `cells`: of the old version, what is compared. All outlive the object.
  PairedMachines(const DiffSide& old_side, const DiffSide& new_side, const prove::machine::Version& old_version,
                 const prove::machine::Version& new_version, const prove::diff::Match& match,
                 const std::vector<execute::CellId>& cells);

  /// Keeps power-on, and measures a slow pass. `known_runs`: a number that is none of theirs.
  void BeginSearch(size_t known_runs);
  void EndAt(Time end);
  Time end() const { return end_; }
  bool Late() const { return std::chrono::steady_clock::now() >= end_; }

  /// Called around each Step; may be empty.
  std::function<void()> before_step, after_step;
  /// One step, in pieces so that what differs for a moment only is seen; keeps the moment when it is worth it. false:
  /// it is late, or a version is stuck.
  bool Step(const Stimulus& stimulus, RandomRuns& result);
  /// Does what a run sets, by time, and compares after each period.
  void Repeat(const prove::diff::Run& run, uint32_t period_ms, RandomRuns& result);
  /// Both versions do it, and are looked at; nothing is compared. false as Step.
  bool Apply(const Stimulus& stimulus);
  /// The same without looking: several steps, then Look().
  bool ApplyUnseen(const Stimulus& stimulus);
  void Look();
  struct Differences {
    bool any = false, is_new = false;  // something differs; it was not seen to differ before
  };
  /// Compares the pictures; adds to `result` what was not seen to differ before.
  Differences Compare(RandomRuns& result);

  /// What was done since power-on, and what is done without Step.
  Stimuli& stimuli() { return stimuli_; }
  void AddPeriodsOf(const Stimulus& stimulus) { periods_ += stimulus.slow + stimulus.fast + stimulus.ms / period_ms_; }
  KnownPosition& known() { return known_; }

  Moment Here() const;
  void GoTo(const Moment& moment);
  void GoToPowerOn() { GoTo(*kept_moments(Kept::kBetweenSteps).front()); }
  void Keep(Kept why);
  Moments& kept_moments(Kept why) { return moments_[static_cast<size_t>(why)]; }
  /// Keeps the moments at which others have shown a difference: waiting and counting from power-on come to some that
  /// nothing here comes to.
  void KeepShown(RandomRuns& result);
  /// The moments that are kept, as one version saw them.
  void ForEachSeenState(prove::diff::Which which,
                        const std::function<void(const prove::invariants::CellValues&, uint64_t now_ms)>& visit);
  /// As both saw them.
  void ForEachSeenPair(const std::function<void(const prove::invariants::CellValues& of_old,
                                                const prove::invariants::CellValues& of_new, uint64_t now_ms)>& visit);

  /// The versions for a solver that looks ahead, without what the control clears.
  prove::diff::UnrolledVersions Unrollable() const;
  /// Where both are now.
  prove::diff::SeenState Seen() const;

  News news;
  terms::Random random{0x8EBC6AF09C88C6E3};

  DiffMachine& old_machine() { return old_machine_; }
  DiffMachine& new_machine() { return new_machine_; }
  const DiffMachine& old_machine() const { return old_machine_; }
  const DiffMachine& new_machine() const { return new_machine_; }
  const prove::machine::Version& old_version() const { return old_version_; }
  const prove::machine::Version& new_version() const { return new_version_; }
  const prove::diff::Match& match() const { return match_; }
  const prove::machine::Uses& old_uses() const { return old_uses_; }
  const prove::machine::Uses& new_uses() const { return new_uses_; }
  uint32_t period_ms() const { return period_ms_; }
  /// Of a whole slow pass.
  uint32_t pass_periods() const { return pass_periods_; }

 private:
  /// Of the compared pairs those that are in one byte of both pictures, or one field.
  struct Compared {
    uint32_t old_at = 0, new_at = 0, bytes = 1;
    uint8_t mask = 0xFF;
    std::vector<execute::CellId> cells;
  };
  void FindCompared(const std::vector<execute::CellId>& cells);
  void AddDifferences(const std::vector<execute::CellId>& differ, RandomRuns& result);

  const prove::machine::Version& old_version_;
  const prove::machine::Version& new_version_;
  const prove::diff::Match& match_;
  prove::machine::Uses old_uses_, new_uses_;
  DiffMachine old_machine_, new_machine_;
  uint32_t period_ms_ = 1, pass_periods_ = 1;
  Time end_ = Time::max();
  std::vector<Compared> compared_;
  std::vector<execute::CellId> compared_calls_;
  std::array<Moments, 4> moments_;  // by Kept
  size_t most_moments_ = 0;
  Stimuli stimuli_;  // from power-on until now
  uint64_t periods_ = 0;
  KnownPosition known_;
  std::set<uint32_t> kept_runs_;  // of the result: its own, and those of which the moment is kept
  size_t kept_inputs_ = 0;        // of the runs that were kept
};

}  // namespace plcxx::review::diff
