// What system functions do on the image of G (specification 6.10), as routines that are there when something calls
// them.
#pragma once

#include <array>
#include <string>
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

  /// Of the routine that is built.
  struct Parameters {
    std::vector<ir::PlaceId> places;
    ir::PlaceId result;  // where there is one
  };
  void Build(SystemRoutine routine, const Parameters& p);
  void SetAxisHome(const Parameters& p);
  void SetAxisJog(const Parameters& p);
  void SetAxisStep(const Parameters& p);
  void SetAxisMove(const Parameters& p);
  void SetAxisMoveto(const Parameters& p);
  void SetAxisStop(const Parameters& p);
  void GetAxisPos(const Parameters& p);
  void GetAxisDen(const Parameters& p);
  void GetHandwheel(const Parameters& p);
  void Handwheel(const Parameters& p);
  ir::ValueId Parameter(const Parameters& p, size_t index);
  /// The number of the axis, which is the first parameter, as an index.
  ir::ValueId Axis(const Parameters& p);
  /// Of that axis: what is left of its way, and its speed.
  ir::ValueId PicA(const Parameters& p);
  ir::ValueId Speed(const Parameters& p);
  /// sys_iip_time, F[251].
  ir::ValueId Iip();
  ir::PlaceId Local(std::string name, ir::Type type, ir::ValueId value);

  Memory& memory_;
  CellPlaces& places_;
  Locals& locals_;
  std::unordered_map<uint32_t, ir::RoutineId> made_;  // by SystemFunction
  std::array<ir::PlaceId, 4> handwheels_;
  ir::PlaceId handwheel_place_;
};

}  // namespace plcxx::hnc
