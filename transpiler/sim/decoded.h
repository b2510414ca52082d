// Instructions made ready for execution: the function of each and what it has to know, in the order of execution.
//
// In: a program. Out: for each region a stretch of decoded instructions; constants stand at its end, for their values
// are there from the start. Not its job: what an instruction does (simulator_decode.cc), and how regions are entered.
#pragma once

#include <cstdint>

namespace plcxx::sim {

class Simulator;

/// Whether execution goes on after an instruction, or an Exit is on its way to the block or loop that it leaves.
enum class Flow : uint8_t { kOn, kLeaving };

struct Decoded {
  Flow (*execute)(Simulator& simulator, const Decoded& inst) = nullptr;
  uint32_t id = 0;                // its InstId, which is where its result goes, too
  uint32_t order = 0;             // how many are in front of it in its region
  uint32_t a = 0, b = 0, c = 0;   // operands: whose results they are
  uint32_t payload = 0;           // as ir::Inst has it
  uint32_t owner = 0, place = 0;  // of a place that does not move: the space and the byte in it; of a field its place
  uint8_t bit = 0;                // likewise
};

/// Stretches of decoded instructions.
struct DecodedRegion {
  uint32_t begin = 0, constants = 0, end = 0;
};

}  // namespace plcxx::sim
