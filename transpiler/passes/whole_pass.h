// A pass of a slow part that is cut into slices, as one period: for proofs of what happens between the slices.
//
//   routine period {                    routine pass {
//     call fast ()                        store slice 0
//     call slow (slice)          ->       store ms_into_pass 0;  store I0 <- inputs of slice 0;  call period ()
//     slice = slice + 1 ...               store ms_into_pass 10; store I0 <- inputs of slice 1;  call period ()
//   }                                   }
//
// In: a program whose slices are cut (cut_slices.h), and what somebody else sets between two periods. Out: the program
// with a schedule of passes; what is set in front of each slice is memory of its own, which the program only reads. Not
// its job: whether the counter of the slices is 0 again behind the last one, which whoever uses it has to prove.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::passes {

/// A byte of which others set bits: to any value, or to 0 only.
struct ByteBetweenSlices {
  ir::SpaceId space;
  uint32_t offset = 0;
  uint8_t set = 0, taken_back = 0;  // masks, apart from each other
};

struct WholePass {
  uint32_t slices = 1;
  ir::PlaceId slice;  // counts them; 0 in front of a pass
  /// By slice: byte i is what comes to `bytes[i]` in front of it; of its `taken_back` a 1 says that it happens, but in
  /// front of the first slice, where it is whatever it is between two passes.
  std::vector<ir::SpaceId> inputs;
};

/// Makes the pass the period of `program`. None, and the program as it was: it is not cut, its slices have no counter
/// of their own, or its fast part has times of its own.
std::optional<WholePass> MakeWholePass(ir::Program& program, std::span<const ByteBetweenSlices> bytes);

}  // namespace plcxx::passes
