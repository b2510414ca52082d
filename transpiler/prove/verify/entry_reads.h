// Which cells a part of a program may read before it has written them: on which of the values that it finds it depends.
//
// In: a part, with all that it calls. Out: those cells. What is written for certain in front of each read is none of
// them; a part that writes a cell on some ways only leaves there what it found, and does not depend on it otherwise.
// Not its job: what host functions see of the state beside their arguments (Footprint).
#pragma once

#include <optional>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/symbolic/execute/cells.h"
#include "transpiler/symbolic/execute/execute.h"

namespace plcxx::prove::verify {

class EntryReads {
 public:
  /// Both outlive it.
  EntryReads(const ir::Program& program, const execute::Cells& cells)
      : program_(program), cells_(cells), routines_(program.routines.size()) {}

  /// By CellId.
  std::vector<bool> Of(const execute::Stretch& part) { return Walk(part).read; }

 private:
  /// Cells that are written on every way so far, in the order in which that became so.
  struct Written {
    std::vector<bool> is_written;  // by CellId
    std::vector<execute::CellId> cells;

    void Add(execute::CellId cell);
    /// Takes back, and gives, what was added since there were so many.
    std::vector<execute::CellId> TakeBack(size_t count);
  };
  struct Summary {
    std::vector<bool> read;                // by CellId
    std::vector<execute::CellId> written;  // at the end of the part
  };
  struct Walked {
    std::vector<bool> read;
    Written written;
  };

  Summary Walk(const execute::Stretch& part);
  const Summary& OfRoutine(ir::RoutineId id);
  void Region(Walked& walked, ir::RegionId region);
  void Inst(Walked& walked, const ir::Inst& inst);
  void Branches(Walked& walked, const ir::Inst& inst);
  void Read(Walked& walked, execute::CellId cell) const;
  void ReadAll(Walked& walked, const std::vector<execute::CellId>& cells) const;

  const ir::Program& program_;
  const execute::Cells& cells_;
  std::vector<std::optional<Summary>> routines_;  // by RoutineId
};

}  // namespace plcxx::prove::verify
