// What was done in an episode of runs in many lanes, and the way of one lane through it.
//
// Now and then whole groups of lanes become copies of a lane that is nearer to what is looked for. The run of a lane is
// therefore that of another one before the copy.
//
//   period      0    1    2        before period 2 the lanes 64 to 127 became copies of lane 5
//   lane 70     5    5   70        its way
//
// Not its job: which lanes are copied, what the runs are for.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "transpiler/prove/wide/inputs.h"
#include "transpiler/prove/wide/machine.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::prove::wide {

/// What happened before one period, in all lanes.
struct Period {
  CopyOf copy_of = NoCopies();
  std::vector<WideSet> sets;
  std::vector<std::pair<execute::CellId, terms::Plane>> done;  // requests that the control clears
};

/// What is set before the period in a lane, in the order in which it is: `set(cell, value)`; a cell may come twice.
template <class Set>
void ForEachSet(const Period& period, const WideInputs& inputs, uint32_t lane, Set&& set) {
  for (const WideSet& one : period.sets) {
    if (one.where.Get(lane)) set(inputs.inputs()[one.input].cell, one.value.Get(lane));
  }
  for (const auto& [request, where] : period.done) {
    if (where.Get(lane)) set(request, false);
  }
}

/// The lane in which a lane was in each period before `end`: copies are followed back.
std::vector<uint32_t> WayOf(std::span<const Period> history, uint32_t lane, uint32_t end);

/// Some of the requests, in some lanes.
std::vector<std::pair<execute::CellId, terms::Plane>> DrawDone(std::span<const execute::CellId> requests,
                                                               terms::Random& random);

/// By lane how much it is worth to begin there again; 0: nothing.
using Scores = std::array<float, terms::Plane::kLanes>;
/// `weight` is shared by the lanes; of many of them none is worth anything.
void AddScore(const terms::Plane& lanes, float weight, Scores& scores);
/// Lanes with high scores for most words; what was taken counts less after that. Some words go their own ways.
CopyOf DrawCopies(Scores& scores, terms::Random& random);

uint32_t CountLanes(const terms::Plane& lanes);
/// In ascending order.
template <class Visit>
void ForEachLane(const terms::Plane& lanes, Visit&& visit) {
  for (uint32_t w = 0; w < terms::Plane::kWords; ++w) {
    for (uint64_t word = lanes.words[w]; word != 0; word &= word - 1)
      visit(64 * w + static_cast<uint32_t>(std::countr_zero(word)));
  }
}

}  // namespace plcxx::prove::wide
