// Run-time faults (specification 6.9): a record in memory and a call of the host, as one routine.
#pragma once

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class HostCalls;
class Memory;

/// In the order of 6.9, from 1.
enum class Fault : uint8_t { kDivision = 1, kIndex = 2, kLoop = 3 };

class Faults : Context {
 public:
  Faults(const Context& context, HostCalls& host_calls, Memory& memory)
      : Context(context), host_calls_(host_calls), memory_(memory) {}

  void AddRoutine();
  void Record(Fault fault);
  void RecordWhen(ir::ValueId condition, Fault fault);
  ir::RoutineId routine() const { return routine_; }
  /// With faults=stop: a fault has happened, the machine stands still.
  ir::PlaceId stop() const { return stop_; }
  ir::PlaceId stopped() const { return stopped_; }

 private:
  HostCalls& host_calls_;
  Memory& memory_;
  ir::RoutineId routine_;
  ir::PlaceId stop_, stopped_;
};

}  // namespace plcxx::hnc
