// What the routines of a program are made of. Only the lowering's files include it.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "transpiler/dialects/technol/syntax.h"
#include "transpiler/ir/program.h"

namespace plcxx::technol {

/// What one routine holds of the program.
struct Body {
  UnitId unit;                              // a module or mechanism; none: subprograms
  std::vector<uint32_t> subprograms;        // by Flow's numbers
  std::vector<InstructionId> instructions;  // in source order
  ir::RoutineId routine;
  /// Where a pass or a jump may go on, in source order; their steps count from 1, 0 is the beginning. Waiting points,
  /// and what jumps back to across one of these.
  std::vector<InstructionId> entries;
  bool goes_back = false;  // a jump leads back across an entry: the choice of the entry is in a loop
  /// The stretches between entries are the cases of one `switch`, each running on into the next one; what comes from
  /// `tail` on is after it. Not where a jump leads forward into a stretch other than the next one, or from the tail
  /// back into the last case.
  bool stretches_are_cases = false;
  std::optional<InstructionId> tail;
  bool tail_goes_back = false;     // to an entry
  ir::PlaceId entry;               // which subprogram is called, where there are several
  bool calls = false;              // subprograms, with which it shares its registers
  bool leaves = false;             // may leave all routines at once, by a refused jump or a trap
  bool loops = false;              // it, or what it calls, jumps backward
  std::vector<UnitId> stops;       // subprograms: the mechanisms that they, or what they call, may stop; sorted
  bool stopped_by_callee = false;  // a mechanism: by a subprogram that it calls
  uint32_t level = 0;              // of subprograms: greater than that of each caller

  /// 0 up to the first entry; the number of the last entry at or before the instruction.
  size_t StretchOf(InstructionId id) const {
    return static_cast<size_t>(std::upper_bound(entries.begin(), entries.end(), id) - entries.begin());
  }
  bool IsEntry(InstructionId id) const { return std::binary_search(entries.begin(), entries.end(), id); }
};

}  // namespace plcxx::technol
