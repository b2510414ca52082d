#include "transpiler/driver/diff_runs.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include "transpiler/driver/diff_machine.h"
#include "transpiler/prove/meaning/meaning.h"

namespace plcxx::driver {
namespace {

using prove::CellId;

constexpr int kMostRuns = 40, kSteps = 60;
constexpr uint64_t kRandomShare = 5;  // of the time: a fifth

class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}
  uint64_t Next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return state_;
  }
  bool OneIn(uint64_t n) { return Next() % n == 0; }

 private:
  uint64_t state_;
};

/// The pairs that the host writes and a version reads, by the names of inputs that a scenario can set.
std::vector<prove::SetCell> InputsOf(const prove::Version& old_version, const prove::Version& new_version,
                                     const prove::Match& match) {
  const prove::Uses old_uses = UsesOf(old_version), new_uses = UsesOf(new_version);
  std::vector<prove::SetCell> inputs;
  for (uint32_t i = 0; i < old_version.cells.calls; ++i) {
    const CellId old_cell(i), new_cell = match.new_of_old[i];
    if (!new_cell.valid() || !(old_uses.reads[i] || new_uses.reads[new_cell.index])) continue;
    if (IsInputPair(old_version, old_uses, new_uses, match, old_cell)) {
      inputs.push_back({.old_cell = old_cell, .new_cell = new_cell});
    }
  }
  return inputs;
}

/// Inputs change seldom in some runs and often in others; now and then nothing happens for a while, so that timers end.
Stimuli MakeStimuli(Random& random, const std::vector<prove::SetCell>& inputs, int run) {
  const uint64_t one_in = uint64_t{2} << (run % 6);
  const uint64_t density = 1 + static_cast<uint64_t>(run) % 3;  // of ones, in quarters
  Stimuli stimuli;
  for (int step = 0; step < kSteps; ++step) {
    Stimulus stimulus;
    for (prove::SetCell input : inputs) {
      if (step != 0 && !random.OneIn(one_in)) continue;
      input.value = random.Next() % 4 < density;
      stimulus.inputs.push_back(input);
    }
    if (random.OneIn(8)) {
      stimulus.ms = static_cast<uint32_t>(100 * (1 + random.Next() % 30));
    } else {
      stimulus.slow = 1;
    }
    stimuli.push_back(std::move(stimulus));
  }
  return stimuli;
}

}  // namespace

RandomRuns RunBoth(const DiffSide& old_side, const DiffSide& new_side, const prove::Version& old_version,
                   const prove::Version& new_version, const prove::Match& match, const DiffOptions& options) {
  RandomRuns result;
  const std::vector<prove::SetCell> inputs = InputsOf(old_version, new_version, match);
  std::vector<std::pair<CellId, CellId>> pairs;
  for (uint32_t i = 0; i < old_version.cells.count; ++i) {
    if (match.new_of_old[i].valid() && IsState(old_version, CellId(i)))
      pairs.emplace_back(CellId(i), match.new_of_old[i]);
  }
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(options.time_ms / kRandomShare);
  Random random(0x9E3779B97F4A7C15);
  for (int run = 0; run < kMostRuns && std::chrono::steady_clock::now() < end; ++run) {
    if (options.progress) options.progress("random run " + std::to_string(run + 1));
    Stimuli stimuli = MakeStimuli(random, inputs, run);
    DiffMachine old_machine(old_side, old_version), new_machine(new_side, new_version);
    for (uint32_t step = 0; step < stimuli.size() && std::chrono::steady_clock::now() < end; ++step) {
      const Stimulus& stimulus = stimuli[step];
      for (const prove::SetCell& input : stimulus.inputs) {
        old_machine.SetBit(input.old_cell, input.value);
        new_machine.SetBit(input.new_cell, input.value);
      }
      if (!old_machine.Advance(stimulus) || !new_machine.Advance(stimulus)) break;
      old_machine.Look();
      new_machine.Look();
      for (const auto& [old_cell, new_cell] : pairs) {
        if (old_machine.Seen(old_cell) == new_machine.Seen(new_cell)) continue;
        result.difference_of.try_emplace(old_cell, RandomRuns::Difference{static_cast<uint32_t>(run), step + 1});
      }
    }
    result.runs.push_back(std::move(stimuli));
  }
  return result;
}

}  // namespace plcxx::driver
