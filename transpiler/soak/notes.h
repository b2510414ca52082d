// A program that notes in memory of its own what of it was reached: a bit for each mark.
//
//   v1 = load I0A0          v1 = load I0A0
//                    ->     note 7 |= v1, note 8 |= not v1         the condition was seen 1, was seen 0
//
// So whatever executes programs tells what a soak is steered by, for hundreds of machines at once, too. In: a program,
// its goals, what is watched. Out: the program with a space of notes behind all others, which nothing clears but
// power-on. A note says where it is worth while to look: what is told in the end was repeated (trial.h). Of conditions
// of loops nothing is noted, and of properties only those that speak of one moment. Not its job: executing it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/soak/goals.h"
#include "transpiler/soak/watch.h"

namespace plcxx::soak {

/// What one bit of the notes says.
struct Mark {
  ir::InstId inst;                   // it gave this
  uint8_t given = 0;                 // bits of Simulator::NoteGiven, one of which was given
  std::optional<uint32_t> property;  // by number: it did not hold after a period; then there is no instruction
};

struct NotedProgram {
  ir::Program program;
  ir::SpaceId notes;
  std::vector<Mark> marks;  // mark i is bit i % 8 of byte i / 8

  ir::Place PlaceOf(size_t mark) const;
};

NotedProgram NoteReached(const Goals& goals, const WatchPlan& plan);

}  // namespace plcxx::soak
