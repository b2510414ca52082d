// What is around the program's rungs: routines, init, the period.
#pragma once

#include "transpiler/dialects/classicladder/lowering/edges.h"
#include "transpiler/dialects/classicladder/lowering/host_calls.h"
#include "transpiler/dialects/classicladder/lowering/places.h"

namespace plcxx::classicladder {

class Schedule : Context {
 public:
  Schedule(const Context& context, HostCalls& host, Places& places, Edges& edges)
      : Context(context), host_(host), places_(places), edges_(edges) {}

  void AddRoutines();
  /// The main sections.
  ir::RegionId fast() const { return program_.routines[fast_].body; }
  /// The bit by which the program stands still from the next period on.
  ir::PlaceId stopped() const { return stopped_; }
  /// Everything else: after the sections are lowered.
  void Lower();

 private:
  void Init();
  void Period();
  void Fill();

  HostCalls& host_;
  Places& places_;
  Edges& edges_;
  ir::RoutineId init_, fast_, period_;
  ir::PlaceId periods_, stopped_;
};

}  // namespace plcxx::classicladder
