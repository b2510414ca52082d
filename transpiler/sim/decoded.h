// Instructions made ready for execution: the function of each and what it has to know, in the order of execution.
//
// In: a program. Out: for each region a stretch of decoded instructions; constants stand at its end, for their values
// are there from the start. Not its job: what an instruction does (instructions.h), and how regions are entered.
#pragma once

#include <cstdint>

namespace plcxx::sim {

struct Execution;

/// Whether execution goes on after an instruction, or an Exit is on its way to the block or loop that it leaves.
enum class Flow : uint8_t { kOn, kLeaving };

/// Half a line of the cache, for a program of thousands of statements is read from memory in each period.
struct Decoded {
  Flow (*execute)(Execution& execution, const Decoded& inst) = nullptr;
  uint32_t id = 0;       // its InstId, which is where its result goes, too
  uint32_t order = 0;    // how many are in front of it in its region
  uint32_t a = 0;        // operand: whose result it is
  uint32_t b = 0;        // operand; of a load or store of what does not move the byte in its space, or a field's place
  uint32_t c = 0;        // operand; likewise the space
  uint32_t payload = 0;  // as ir::Inst has it; likewise the bit

  uint32_t byte() const { return b; }
  uint32_t space() const { return c; }
  uint32_t bit() const { return payload; }

  // Of a rung (rungs.h), whose id and order are those of its last instruction: the first of the instructions that it
  // is, its steps, and what stands around them.
  static constexpr uint32_t kHasStatement = 1, kHasCoil = 2;
  uint32_t first() const { return a; }
  uint32_t first_step() const { return b; }
  uint32_t step_count() const { return c; }
  bool has_statement() const { return (payload & kHasStatement) != 0; }
  bool has_coil() const { return (payload & kHasCoil) != 0; }
};
static_assert(sizeof(Decoded) <= 32);

/// Stretches of decoded instructions: each by itself, constants at the end, and ready to be executed, in rungs
/// (rungs.h) where there are some.
struct DecodedRegion {
  uint32_t begin = 0, constants = 0, end = 0;
  uint32_t ready_begin = 0, ready_end = 0;
};

}  // namespace plcxx::sim
