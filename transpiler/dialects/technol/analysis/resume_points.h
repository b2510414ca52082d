// Where the passes of a module or mechanism begin (specification 6.7).
#pragma once

#include <cstddef>
#include <vector>

#include "transpiler/dialects/technol/analysis/flow.h"

namespace plcxx::technol {

/// Beside the beginning. A mechanism keeps the number of the point where its next pass begins in a word.
inline constexpr size_t kMostResumePoints = 65535;

struct ResumePoints {
  std::vector<InstructionId> points;  // in source order
  bool goes_back = false;             // a jump leads back across one of them
};

/// What the unit of a root executes, in source order.
std::vector<InstructionId> InstructionsOf(const Flow& flow, const Root& root);
/// Waiting points, and what jumps back to across one of these.
ResumePoints ResumePointsOf(const Flow& flow, const std::vector<InstructionId>& instructions);

}  // namespace plcxx::technol
