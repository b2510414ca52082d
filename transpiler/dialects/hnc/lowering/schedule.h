// The cycle around the parts (specification 4.2): image transfer, due times, power-on, standstill after a fault.
#pragma once

#include <functional>
#include <string_view>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class CriticalSections;
class Dispatcher;
class Faults;
class Handlers;
class HostCalls;
class Memory;
class CellPlaces;
class SystemRoutines;

class Schedule : Context {
 public:
  Schedule(const Context& context, HostCalls& host_calls, CriticalSections& critical, Faults& faults, Memory& memory,
           CellPlaces& places, SystemRoutines& system_routines, Handlers& handlers, Dispatcher& dispatcher)
      : Context(context),
        host_calls_(host_calls),
        critical_(critical),
        faults_(faults),
        memory_(memory),
        places_(places),
        system_routines_(system_routines),
        handlers_(handlers),
        dispatcher_(dispatcher) {}

  void AddScalars();
  void AddRoutines();
  /// The times between two calls of plc1() and of plc2().
  ir::PlaceId period1() const { return period1_; }
  ir::PlaceId period2() const { return period2_; }

 private:
  void Exchange(std::string_view name, std::string_view comment, ir::HostAccess access);
  void Parameters();
  void CallEntry(FunctionId function);
  void Copy(Area area, uint32_t to, uint32_t from, uint32_t bytes);
  void AddStandstill();
  void WhenRunning(const std::function<void()>& body);
  void Cycle();
  uint32_t LongestPeriod(Storage storage) const;
  void Fill();

  HostCalls& host_calls_;
  CriticalSections& critical_;
  Faults& faults_;
  Memory& memory_;
  CellPlaces& places_;
  SystemRoutines& system_routines_;
  Handlers& handlers_;
  Dispatcher& dispatcher_;
  ir::RoutineId init_, fast_, slow_, cycle_, period_routine_, standstill_;
  ir::PlaceId started_, due_fast_, due_slow_, next_fast_, next_slow_, fast_done_, slow_done_, now_, period1_, period2_;
};

}  // namespace plcxx::hnc
