// What is around the program's statements: init and the tick, host calls, alarms (4.3, 8, 9).
#pragma once

#include "transpiler/dialects/host50/lowering/context.h"
#include "transpiler/dialects/host50/lowering/host_calls.h"

namespace plcxx::host50 {

class Cells;
class OwnInstances;
class OwnPlaces;
class Routines;

class Schedule : Context {
 public:
  Schedule(const Context& context, HostCalls& host, Cells& cells, OwnPlaces& own_places, OwnInstances& instances,
           Routines& routines);

  /// Places that the schedule keeps; before anything is lowered.
  void AddPlaces();
  /// After the sections: init knows their edges then, and the tick the alarms that they drive.
  void Lower();

 private:
  void LowerInit();
  void LowerPeriod();
  void RunSlow();
  void ReportAlarms();

  HostCalls& host_;
  Cells& cells_;
  OwnPlaces& own_places_;
  OwnInstances& instances_;
  Routines& routines_;
  ir::PlaceId tick_, slow_done_;
};

}  // namespace plcxx::host50
