// The scheduler around the modules: power-on, slow and fast passes (specification 4.2 to 4.4).
#pragma once

#include <string_view>

#include "transpiler/dialects/technol/lowering/context.h"
#include "transpiler/dialects/technol/lowering/host_calls.h"

namespace plcxx::technol {

class CellPlaces;
class Mechanisms;
class Requests;

class Schedule : Context {
 public:
  Schedule(const Context& context, CellPlaces& cells, HostCalls& host, Mechanisms& mechanisms, Requests& served)
      : Context(context), cells_(cells), host_(host), mechanisms_(mechanisms), served_(served) {}

  void AddRoutines();
  /// Those that are MODULE_INIT and MODULE_FAST as well.
  ir::RoutineId init() const { return init_; }
  ir::RoutineId fast() const { return fast_; }
  /// What power-on does before MODULE_INIT.
  void LowerPowerOn();
  /// What a fast pass does before MODULE_FAST.
  void BeginFast();
  /// Everything else: when all routines are lowered.
  void Lower();

 private:
  void Slow();
  void Period();
  void RunFunctions(ModuleKind kind, std::string_view bit);
  void Fill();
  /// Does the program, or its host by the program's requests, touch the area?
  bool IsUsed(Area area) const;
  /// A bit that is always 0.
  ir::PlaceId NeverPlace();

  CellPlaces& cells_;
  HostCalls& host_;
  Mechanisms& mechanisms_;
  Requests& served_;
  ir::RoutineId init_, fast_, slow_, requests_, period_, fast_only_;
};

}  // namespace plcxx::technol
