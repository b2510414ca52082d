// Runs of both versions in many lanes at once, to see what differs: candidates, which are repeated one by one.
//
// Both versions run beside each other, lane for lane with the same inputs. A difference has to travel through other
// statements, a period for each, and most die on the way; so now and then whole groups of lanes become copies of one
// in which the news is nearest: what a location that has not differed yet is computed from differs there, and hardly
// anywhere else. Runs begin with power-on, or with a state in which the versions were seen: there one lane for each
// input near the change has that one changed, for a machine at work comes by most conditions but one. In: two versions,
// what is looked for. Out: runs. Not its job: whether the simulator and the control agree; who repeats the runs sees
// that.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "transpiler/prove/diff/runs_from.h"
#include "transpiler/prove/diff/unrolled.h"
#include "transpiler/prove/wide/history.h"
#include "transpiler/prove/wide/inputs.h"
#include "transpiler/prove/wide/machine.h"

namespace plcxx::prove::diff {

/// States in which both versions were seen.
struct WideStarts {
  /// Where the changes go: each input alone and held for a moment, or several of them, now and then, for longer.
  enum class Changes : uint8_t { kOneByOne, kSeveral };

  size_t count = 0;
  /// Calls `use` with one of them.
  std::function<void(size_t start, const std::function<void(const SeenState&)>& use)> visit;
  std::vector<execute::CellId> read;  // old cells that the changed statements read
  Changes changes = Changes::kOneByOne;
};

class WideRuns {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `sought`: old cells, all that may ever be looked for. Executes both versions; when it is not done at `end`, or a
  /// version cannot be executed, it finds nothing. The versions outlive it.
  WideRuns(UnrolledVersions versions, const std::vector<execute::CellId>& sought, Time end);
  ~WideRuns();

  /// How much time passes in one period of a run. A base cycle may be much shorter than what the parts wait for, and
  /// nothing but a counter changes between: so much time is one step here.
  uint32_t period_ms() const;
  bool is_ready() const { return inputs_.has_value() && !(inputs_->inputs().empty() && requests_.empty()); }
  /// Runs of ever other lengths until `end`, or until none of `sought` is open. `found` gets a run for each location
  /// that was seen to differ, one for several of them where it can be; what stays open after that is told again a few
  /// times only.
  /// The first `shared` periods of a run are those of the run before it.
  void Search(const std::vector<execute::CellId>& sought, Time end, const std::function<bool(execute::CellId)>& is_open,
              const std::function<void(const Run&, size_t shared)>& found);
  /// The same from each of the starts, once.
  void SearchFrom(const WideStarts& starts, const std::vector<execute::CellId>& sought, Time end,
                  const std::function<bool(execute::CellId)>& is_open,
                  const std::function<void(const Run&, size_t start)>& found);

 private:
  static constexpr uint32_t kWords = terms::Plane::kWords, kLanes = terms::Plane::kLanes;

  /// Where a location was seen first.
  struct Seen {
    execute::CellId cell;
    uint32_t period = 0;
    terms::Plane lanes;
  };
  /// A location that both machines have, and those that it is computed from, as numbers of pairs_.
  struct Pair {
    execute::CellId old_cell, new_cell;
    std::vector<uint32_t> sources;
    uint32_t told_in_vain = 0;
  };

  /// Where the lanes of a word begin: a start, with the values that the inputs have there.
  struct Begin {
    size_t start = 0;
    uint32_t first_near = 0;      // of the inputs that are changed one by one
    std::vector<uint8_t> levels;  // by number of the input
  };

  std::vector<uint32_t> OpenPairs(const std::vector<execute::CellId>& sought,
                                  const std::function<bool(execute::CellId)>& is_open) const;
  void PowerOn();
  /// Numbers of the inputs that `read` is computed from, those of which it is computed soonest in front.
  std::vector<uint32_t> InputsNear(std::vector<execute::CellId> read) const;
  void BeginAt(uint32_t word, const SeenState& state);
  /// Inputs by their numbers that get the opposite of what they are.
  std::vector<wide::WideSet> Opposites(const std::vector<uint32_t>& near, WideStarts::Changes changes);
  void EpisodeFrom(const std::vector<uint32_t>& near, WideStarts::Changes changes, std::vector<uint32_t>& open,
                   Time end, std::vector<Seen>& seen);
  void FindInputs(const std::vector<execute::CellId>& settable);
  std::optional<uint32_t> NumberOf(execute::CellId old_cell) const;
  void Advance(const wide::Period& period);
  /// What of `open` (numbers of pairs_) differs now, in which lanes.
  void Compare(std::vector<uint32_t>& open, std::vector<Seen>& seen);
  /// Copies lanes in which the news is near.
  void Select(const std::vector<uint32_t>& open, const std::vector<Seen>& seen, wide::Period& period);
  void Episode(std::vector<uint32_t>& open, Time end, std::vector<Seen>& seen);
  uint64_t LevelAtBegin(execute::CellId cell, uint32_t lane) const;
  Run RunOf(const std::vector<uint32_t>& path) const;
  /// Paths in which all that was seen is seen; those that begin alike come one after the other.
  std::vector<std::vector<uint32_t>> Cover(const std::vector<Seen>& seen) const;
  void FindPairs(const std::vector<execute::CellId>& sought);
  void FindSources();

  UnrolledVersions versions_;
  terms::Terms terms_;
  std::unique_ptr<machine::Relation> old_relation_, new_relation_;
  std::optional<wide::WideMachine> old_machine_, new_machine_;
  std::optional<wide::WideInputs> inputs_;
  std::map<execute::CellId, uint32_t> input_of_;  // by old cell: its number
  std::vector<execute::CellId> requests_;
  std::vector<Pair> pairs_;
  std::map<execute::CellId, uint32_t> pair_of_;  // by old cell
  std::vector<terms::Plane> differences_;        // by pair, after the last period
  std::vector<wide::Period> history_;            // of the episode
  std::vector<Begin> begins_;                    // of the episode, by word; none: power-on
  wide::Times now_ms_{};
  uint32_t episodes_ = 0;
  terms::Random random_{0xB5026F5AA96619E9};
};

}  // namespace plcxx::prove::diff
