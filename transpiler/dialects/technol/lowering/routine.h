// What one routine of the program is.
//
// A module, a mechanism, and a group of subprograms that share instructions are a routine each. A mechanism goes on in
// the next pass where it waited, so its routine begins with a choice among its entries; the instructions from one entry
// to the next are a segment:
//
//    MECH_BEGIN DOOR        void mech_DOOR() {
//                             step = DOOR_step;
//                             for (;;) {                     // goes_back: JL1 TRY leads from segment 2 to segment 0
//                               switch (step) {
//   TRY: FL 1,OPEN                default: OPEN = 1;         // segment 0
//    LDR CLOSED                   case 1:                    // segment 1: entries[0], where EX0 resumes
//    EX0                            if (!CLOSED) { DOOR_step = 1; return; }
//    FL 0,OPEN                      OPEN = 0;
//    EX                             DOOR_step = 2; break;    // waits: the next pass begins at the next segment
//    LDR AGAIN                    case 2:                    // segment 2: entries[1], after EX
//    JL1 TRY                        if (AGAIN) { step = 0; continue; }
//    MECH_END DOOR                  DOOR = 0; DOOR_step = 0; break;
//                               }
//                               break;
//                             }
//                           }
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "transpiler/dialects/technol/syntax/syntax.h"
#include "transpiler/ir/program.h"

namespace plcxx::technol {

struct Routine {
  UnitId unit;                              // a module or mechanism; none: subprograms
  std::vector<uint32_t> subprograms;        // by Flow's numbers
  std::vector<InstructionId> instructions;  // in source order
  ir::RoutineId id;
  /// Where a pass or a jump may go on, in source order; their steps count from 1, 0 is the beginning. Waiting points,
  /// and what jumps back to across one of these.
  std::vector<InstructionId> entries;
  bool goes_back = false;  // a jump leads back across an entry: the choice of the entry is in a loop
  /// The segments are the cases of one `switch`, each running on into the next one; what comes from `tail` on is after
  /// it. Not where a jump leads forward into a segment other than the next one, or from the tail back into the last
  /// case: then the entries are labels, and the `switch` jumps to them.
  bool segments_are_cases = false;
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
  size_t SegmentOf(InstructionId at) const {
    return static_cast<size_t>(std::upper_bound(entries.begin(), entries.end(), at) - entries.begin());
  }
  bool IsEntry(InstructionId at) const { return std::binary_search(entries.begin(), entries.end(), at); }
  /// May a call of these subprograms stop the mechanism?
  bool MayStop(UnitId mechanism) const { return std::binary_search(stops.begin(), stops.end(), mechanism); }
};

}  // namespace plcxx::technol
