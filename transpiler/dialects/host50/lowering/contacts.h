// What a contact of a rung conducts: the signal or constant itself, turned round, or its edge.
//
// In: an instruction with a contact. Out: its value, spelled where it is asked for; of an edge the value that it had
// where its instruction is. Not its job: what rungs make of contacts (results.h).
#pragma once

#include <vector>

#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Cells;
class Logic;
class OwnInstances;

class Contacts : Context {
 public:
  Contacts(const Context& context, Cells& cells, OwnInstances& instances, Logic& logic);

  /// A network's instructions come: none of their edges has been taken.
  /// An edge is taken where its instruction is, whatever the rung's condition is.
  void TakeEdge(InstructionId id);
  /// An edge that was taken does not look again at what it reads.
  bool IsTaken(InstructionId id) const { return edges_[id.index].valid(); }
  ir::ValueId ValueOf(InstructionId id);

 private:
  Cells& cells_;
  OwnInstances& instances_;
  Logic& logic_;
  std::vector<ir::ValueId> edges_;  // by InstructionId: its value, taken where the instruction is
};

/// The instruction's result is its contact, which each user spells again instead of once into a local.
bool IsContactAlone(const Instruction& instruction);

}  // namespace plcxx::host50
