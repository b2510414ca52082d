// What system functions do on the image of G (specification 6.10), as routines that are there when something calls
// them.
#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include "transpiler/dialects/hnc/lowering/context.h"
#include "transpiler/dialects/hnc/lowering/system_functions.h"

namespace plcxx::hnc {

class Locals;
class Memory;
class CellPlaces;

class SystemRoutines : Context {
 public:
  SystemRoutines(const Context& context, Memory& memory, CellPlaces& places, Locals& locals)
      : Context(context), memory_(memory), places_(places), locals_(locals) {}

  /// What a system function does, as a routine that is there when something calls it.
  ir::RoutineId Routine(SystemFunction function);
  /// Whether a call divides by 0, which is a fault of the statement that calls (6.9); none: it cannot. `arguments` are
  /// as the function has them, the axis is one.
  ir::ValueId DividesByZero(SystemFunction function, const std::vector<ir::ValueId>& arguments);
  void AddHandwheels();
  const std::unordered_map<uint32_t, ir::RoutineId>& routines() const { return made_; }

 private:
  FunctionId Replacement(SystemFunction function) const;
  ir::ValueId AxisWord(Area area, uint32_t word, ir::Type type, ir::ValueId axis);
  void SetAxisWord(uint32_t word, ir::Type type, ir::ValueId value, ir::ValueId axis);
  ir::PlaceId HandwheelPlace();
  /// The function, or what the program has in its place (D13).
  void CallAgain(SystemFunction function, std::vector<ir::ValueId> arguments);
  void Build(SystemRoutine routine, ir::RoutineId id);

  Memory& memory_;
  CellPlaces& places_;
  Locals& locals_;
  std::unordered_map<uint32_t, ir::RoutineId> made_;  // by SystemFunction
  std::array<ir::PlaceId, 4> handwheels_;
  ir::PlaceId handwheel_place_;
};

}  // namespace plcxx::hnc
