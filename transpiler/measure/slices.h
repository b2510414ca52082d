// What a slice of a slow part cannot call: by that its figures are told from those of the other slices.
//
// In: the objects, and the program that they were made of. Out: for each slice the functions that only the other ones
// reach. Emission makes functions of the statements of slices and keeps the compiler from inlining them
// (gnu::noinline), and `plcxx build` from calling one function for another one (-fno-ipa-icf): so a block of the
// objects that calls one of them is none of this slice's. What the choice itself executes counts for each slice.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/compile/program_code.h"
#include "transpiler/emit/emittable.h"

namespace plcxx::measure {

struct SliceCode {
  uint64_t slice = 0;
  ir::RegionId piece;
  std::vector<bool> impossible;  // by function of the objects
};

/// Ascending by slice. Empty: the routine is not cut into pieces (ir/slices.h).
std::vector<SliceCode> SlicesOf(const compile::ProgramCode& code, const emit::Emittable& emittable,
                                ir::RoutineId routine);

/// By RegionId: `region`, what nests in it, and the routines that it calls.
std::vector<bool> RegionsFrom(const ir::Program& program, ir::RegionId region);
/// Likewise of a routine as a whole.
std::vector<bool> RegionsOf(const ir::Program& program, ir::RoutineId routine);
/// Likewise of one slice: what each slice executes, and its own piece.
std::vector<bool> RegionsOfSlice(const ir::Program& program, ir::RoutineId routine, ir::RegionId piece);

}  // namespace plcxx::measure
