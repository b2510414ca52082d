// The functions of the generated code, as pieces that are proved one by one: partitions, subroutines and chunks.
//
// In: the emittable program. Out: for each function which part of the typed IR it was printed from, what it gets from
// its caller, which others it calls, and which cells it may read and write, calls included. Not its job: proving.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/symbolic/execute/cells.h"
#include "transpiler/symbolic/execute/execute.h"

namespace plcxx::prove::verify {

using UnitId = support::Id<struct UnitTag>;

/// What functions of the code get from their callers beside their own parameters.
enum class Passes : uint8_t {
  kStateAndHost,  // State in front, the host after
  kNothing        // State is in global variables
};

/// Cells, by CellId.
struct Footprint {
  std::vector<bool> touched, written;
  std::vector<bool> read;                             // before it is written; may be so
  bool shows_state = false, shows_retentive = false;  // to a host function, as a whole
  bool lends_state = false;                           // to one that writes it, and may read it
};

struct Unit {
  std::string name;  // in C++, without namespace
  execute::Stretch part;
  std::vector<ir::PlaceId> values, references;  // named locals and parameters from the caller, in C++'s order
  ir::PlaceId result;                           // none: void
  std::vector<UnitId> callees;                  // each once
  Footprint footprint;
};

struct Units {
  std::vector<Unit> all;            // by UnitId
  std::vector<UnitId> of_routines;  // by RoutineId; none: it is not printed
  std::vector<UnitId> of_chunks;    // by index into Emittable::chunks

  const Unit& operator[](UnitId id) const { return all[id.index]; }
  Unit& operator[](UnitId id) { return all[id.index]; }
  /// The chunk that begins there; none when there is none.
  UnitId At(const emit::Emittable& emittable, ir::RegionId region, uint32_t instruction) const;
};

Units MakeUnits(const emit::Emittable& emittable, const execute::Cells& cells);

}  // namespace plcxx::prove::verify
