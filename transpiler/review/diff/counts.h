// The search for what is seen after many counts: what advanced a number once is done again and again, as far as the
// programs have constants that it may be compared with.
//
// In: both versions in the simulator, and what their steps advance while others search. Out: runs that count, and what
// differs in them. Not its job: other ways of searching (search.h).
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "transpiler/review/diff/paired_machines.h"

namespace plcxx::review::diff {

class Counts {
 public:
  using Time = PairedMachines::Time;

  /// `inputs`: all. `constants`: of both programs, ascending. They and the machines outlive the object, which looks at
  /// each step of these.
  Counts(PairedMachines& machines, const std::vector<Input>& inputs, const std::vector<uint64_t>& constants);
  Counts(const Counts&) = delete;
  Counts& operator=(const Counts&) = delete;

  /// Until `end`, or until each of `sought` (old cells) has differed; counts farther at each call.
  void Run(const std::vector<execute::CellId>& sought, Time end, RandomRuns& result);

 private:
  using Moment = PairedMachines::Moment;
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

  void FindCounters();
  void FindNumbersOfPlaces();
  void FindNumbersOfStates();
  /// Where the old version writes and reads a number of these cells, and both pictures have it.
  void AddCounter(std::span<const execute::CellId> cells, uint32_t bytes);
  /// Before a step, and what it advanced.
  void LookAtCounters();
  void NoteAdvances();
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
  uint64_t ValueIn(const Counter& counter) const {
    return counter.Value(machines_.old_machine().picture(), counter.at);
  }
  bool IsFarFromConstants(uint64_t value, uint64_t advance, uint32_t bytes) const;
  Counting* NextCounting();
  /// Many pulses, and one look; false: the number did not go on as it should, and nothing was done.
  bool CountAtOnce(Counting& counting, RandomRuns& result);
  void CountOn(Counting& counting, RandomRuns& result);
  void CompareCounted(Counting& counting, RandomRuns& result);

  PairedMachines& machines_;
  const std::vector<Input>& inputs_;
  const std::vector<uint64_t>& constants_;
  std::vector<Counter> counters_;
  std::vector<bool> is_input_;                     // by old cell
  std::set<std::pair<uint32_t, uint32_t>> taken_;  // where they are, and their bytes
  std::vector<Pulse> pulses_;
  std::vector<Counting> countings_;
  uint64_t most_counted_ = 0;
};

}  // namespace plcxx::review::diff
