// Modules, mechanisms and subprograms as routines, one instruction after the other.
#pragma once

#include <string>
#include <vector>

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Conditions;
class Exits;
class Flags;
class InstructionSet;
class Locals;
class MechanismPlaces;
class Schedule;
class Segments;
class StatementWriter;

class RoutineWriter : Context {
 public:
  RoutineWriter(const Context& context, Locals& locals, MechanismPlaces& mechanisms, Exits& exits, Flags& flags,
                Conditions& conditions, Segments& segments, StatementWriter& statements, InstructionSet& instructions,
                Schedule& schedule)
      : Context(context),
        locals_(locals),
        mechanisms_(mechanisms),
        exits_(exits),
        flags_(flags),
        conditions_(conditions),
        segments_(segments),
        statements_(statements),
        instructions_(instructions),
        schedule_(schedule) {}

  /// All of them, without instructions: each can be called before it is lowered.
  void AddRoutines();
  void Lower(const Routine& routine);

 private:
  void AddSubprograms(Routine& routine);
  ir::RoutineId AddUnit(const Routine& routine);
  std::string CommentOf(const Routine& routine) const;
  bool BeginsFile(UnitId id) const;
  static bool ShowsOpening(const Unit& unit);
  const SourceFile& FileOf(const Unit& unit) const;
  /// What the routine begins with: zeros, the jumps back that it may take, the choice of its entry.
  void Begin();
  void FindLabels();
  /// By its number in the routine.
  void Execute(size_t index);

  Locals& locals_;
  MechanismPlaces& mechanisms_;
  Exits& exits_;
  Flags& flags_;
  Conditions& conditions_;
  Segments& segments_;
  StatementWriter& statements_;
  InstructionSet& instructions_;
  Schedule& schedule_;
  std::vector<bool> label_at_;  // by instruction of the routine
};

}  // namespace plcxx::technol
