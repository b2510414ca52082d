// The pieces of a slow part that is executed one piece at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::ir {

struct SlicePiece {
  uint64_t slice = 0;  // the value of the parameter "slice" that selects it
  RegionId region;
};

/// In ascending order of the slices: the arms of the body's choice by the parameter "slice". Empty: the routine is not
/// sliced, or its slices are no pieces of the text (jumps lead from one into another).
std::vector<SlicePiece> SlicePieces(const Program& program, RoutineId routine);

/// Whether the routine takes a slice.
bool TakesSlice(const Routine& routine);

}  // namespace plcxx::ir
