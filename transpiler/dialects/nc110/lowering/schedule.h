// What is around the parts: power-on, the period, slices, retentive memory (specification 4.2 to 4.5, 8.1).
#pragma once

#include "transpiler/dialects/nc110/lowering/context.h"
#include "transpiler/dialects/nc110/lowering/host_calls.h"
#include "transpiler/dialects/nc110/lowering/system_places.h"

namespace plcxx::nc110 {

class Cells;
class Routines;

class Schedule : Context {
 public:
  Schedule(const Context& context, HostCalls& host, Cells& cells, SystemPlaces& system, const Routines& routines);

  /// What others have to know of it; before anything is lowered.
  void Declare();
  /// After the parts, which say what is needed.
  void Lower();
  /// Where the control finds what the program wants the operator to read.
  void AddMessagePlaces();

 private:
  void LowerPeriod();
  void LowerFastOnly();
  void BeginPeriod();
  void AdvanceSlice();
  void StoreRetentive();
  ir::ValueId Rose(const Operand& signal, SystemPlace before);

  HostCalls& host_;
  Cells& cells_;
  SystemPlaces& system_;
  const Routines& routines_;
};

}  // namespace plcxx::nc110
