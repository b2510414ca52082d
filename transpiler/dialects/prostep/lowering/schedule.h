// The scheduler around the modules: power-on, tick, slow passes (specification 4.2 to 4.5, 8.1).
#pragma once

#include "transpiler/dialects/prostep/lowering/context.h"
#include "transpiler/dialects/prostep/lowering/host_calls.h"

namespace plcxx::prostep {

class Cells;
class Instances;
class Locals;
class Refresh;
class Scalars;

class Schedule : Context {
 public:
  Schedule(const Context& context, HostCalls& host, Scalars& scalars, Cells& cells, Instances& instances,
           Locals& locals, Refresh& refresh)
      : Context(context),
        host_(host),
        scalars_(scalars),
        cells_(cells),
        instances_(instances),
        locals_(locals),
        refresh_(refresh) {}

  void AddRoutines();
  ir::RoutineId init() const { return init_; }
  /// Before the modules are lowered.
  void LowerPowerOn();
  /// Everything else: after them.
  void Lower();

 private:
  void Fast();
  void Slow();
  void Advance();
  void Tick();
  void SlowPass();
  void SlowStep();
  void Periods();
  void SystemSignals();
  void Enter(ModuleId module);
  void EnterWhenActive(ModuleId module);
  void Fill();

  HostCalls& host_;
  Scalars& scalars_;
  Cells& cells_;
  Instances& instances_;
  Locals& locals_;
  Refresh& refresh_;
  ir::RoutineId init_, fast_, slow_, advance_, tick_, slow_pass_, slow_step_, period_, fast_only_, elapse_;
  ir::RoutineId refresh_inputs_, refresh_outputs_;
};

}  // namespace plcxx::prostep
