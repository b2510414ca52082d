// Where a pass through a routine begins, and the segments between its entries (routine.h).
#pragma once

#include <map>
#include <vector>

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Locals;
class MechanismPlaces;

class Segments : Context {
 public:
  Segments(const Context& context, Locals& locals, MechanismPlaces& mechanisms)
      : Context(context), locals_(locals), mechanisms_(mechanisms) {}

  /// The choice among the entries with which the routine that is lowered begins.
  void Begin();
  /// Goes on in the region of the segment that begins at the instruction, if one does.
  void Enter(InstructionId id);
  /// The label at the end of the segment in front of the one that begins at the instruction.
  uint32_t EndBefore(InstructionId next) const { return tree_.instructions.size() + next.index + 1; }
  /// Goes to an entry, if `condition`, by way of the choice at the head of the routine's loop. `refused` is executed
  /// when no iteration is left.
  void JumpToEntry(size_t step, ir::ValueId condition, ir::RegionId refused);

 private:
  struct Segment {
    ir::RegionId region;
    bool is_jumped_to = false;  // from the one before it
  };

  void BeginCases();
  void AddCase(ir::Switch& choice, std::vector<uint64_t> values, InstructionId first, InstructionId end);
  void BeginLabels();
  /// The number of the entry at which the pass begins; where jumps go back, in front of a loop around what follows.
  ir::ValueId ChosenEntry();

  Locals& locals_;
  MechanismPlaces& mechanisms_;
  std::map<InstructionId, Segment> segments_;  // by their first instruction, the tail among them
  ir::InstId loop_;                            // of a mechanism whose jumps go back
  ir::PlaceId chosen_;                         // the entry that its next iteration begins at
};

}  // namespace plcxx::technol
