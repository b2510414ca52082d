// Runs that violate a property, computed for a host that calls the program as seldom as its parts wait.
//
// A control whose parts wait by themselves (hnc: 16 ms and 32 ms, called each ms) does nothing in most of its periods,
// and a depth that is counted in periods ends before the parts were called three times. A host that calls it every 16
// ms gives one of its runs: inputs change when a part begins. In: a program whose parts wait a known time. Out: such
// runs, in the program's own periods. Not its job: whether the machine shows them, and proofs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "transpiler/prove/properties/check.h"
#include "transpiler/scenarios/property_machine.h"

namespace plcxx::review::properties {

class CoarseRuns {
 public:
  /// The machine outlives it.
  explicit CoarseRuns(const scenarios::ProveMachine& machine);
  ~CoarseRuns();
  CoarseRuns(const CoarseRuns&) = delete;
  CoarseRuns& operator=(const CoarseRuns&) = delete;

  /// The parts wait longer than a period, all of them as long as some number of periods.
  bool AreUseful() const { return periods_ > 1; }
  /// In about so much time; none: there is none, or none was found, or they are of no use.
  std::optional<prove::properties::PropertyRun> Find(const prove::properties::Property& property,
                                                     uint64_t milliseconds);

 private:
  struct Machine;

  const scenarios::ProveMachine& machine_;
  uint32_t periods_ = 1;             // of the program, in one of the host that calls it seldom
  std::unique_ptr<Machine> coarse_;  // made when it is first asked
};

}  // namespace plcxx::review::properties
