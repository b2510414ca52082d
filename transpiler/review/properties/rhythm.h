// Runs in which some inputs come and go at a steady pace, each at its own, while the others are held.
//
// What a machine counts - strokes, parts, steps of a magazine - goes on by pulses that come again and again, and what
// it waits for stays. Inputs that change at random seldom do both for long. In: words of inputs, the nearest to the
// property first. Out: what is set, by period. Not its job: running it.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/review/properties/run_plan.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::review::properties {

struct RhythmInputs {
  std::vector<std::vector<execute::CellId>> words;  // each from its lowest bit
  std::vector<uint64_t> constants;                  // that a word may be compared with
  uint32_t pass_periods = 1;                        // of a slow pass
};

/// `passes`: about how long.
RunPlan MakeRhythm(const RhythmInputs& inputs, uint64_t passes, terms::Random& random);

}  // namespace plcxx::review::properties
