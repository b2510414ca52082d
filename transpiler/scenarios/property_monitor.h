// Watches properties while a scenario runs: what a proof says about all runs is looked at in this one.
//
// In: properties and an engine after each part. Out: the first one that is violated. A proof is about whole periods: a
// fast part alone is not looked at, and is no step of a time; a program whose slow part is cut into slices is looked at
// after its last slice. "is never stuck" cannot be seen in one run and is not watched.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/prove/machine/version.h"
#include "transpiler/prove/properties/property.h"
#include "transpiler/sim/clock.h"
#include "transpiler/sim/engine.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::scenarios {

class PropertyMonitor {
 public:
  /// `program` outlives it.
  PropertyMonitor(const ir::Program& program, const execute::Cells& cells,
                  std::vector<prove::properties::Property> properties);

  void PowerOn();
  /// It begins at a moment, of whose past nothing is known: a property is then looked at from there.
  void BeginAt(sim::Engine& engine);
  /// `part` has been executed.
  void AfterPart(sim::Engine& engine, sim::Clock::Part part);
  /// The first violation: "'never U4A8 and U4A9' does not hold"; stays.
  const std::optional<std::string>& violation() const { return violation_; }
  /// The violation has been dealt with: the next one is looked for.
  void GoOn() { violation_.reset(); }

 private:
  struct Watched {
    execute::CellId cell;
    ir::Place place;
    uint8_t width;
  };

  bool IsEndOfPeriod(sim::Engine& engine, sim::Clock::Part part);

  const ir::Program& program_;
  std::vector<prove::properties::Property> properties_;
  std::vector<Watched> watched_;
  uint32_t window_ = 1;
  bool sliced_ = false;
  uint64_t slow_done_ = 0;
  bool fast_ran_alone_ = false;
  uint32_t period_ = 0;
  std::deque<std::map<execute::CellId, uint64_t>> history_;  // of the last periods, the present one in front
  terms::Terms terms_;
  std::optional<std::string> violation_;
};

}  // namespace plcxx::scenarios
