// Watches properties while a scenario runs: what a proof says about all runs is looked at in this one.
//
// In: properties and an engine after each part. Out: the first one that is violated. A proof is about whole periods: a
// fast part alone is not looked at, and is no step of a time; a program whose slow part is cut into slices is looked at
// after its last slice; and of a control whose parts have times of their own a slow part is looked at whose fast parts
// did not run before it as often as in its period. What is violated behind either is told as such. "is never stuck"
// cannot be seen in one run and is not watched.
#pragma once

#include <cstdint>
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
  /// What of the past decides what is said later.
  struct Moment {
    std::vector<uint64_t> values;
    uint64_t slow_done = 0;
    uint32_t fast_since_slow = 0;
    bool is_off_schedule = false;
    bool operator==(const Moment&) const = default;
  };
  Moment Now() const {
    return {.values = values_,
            .slow_done = slow_done_,
            .fast_since_slow = fast_since_slow_,
            .is_off_schedule = is_off_schedule_};
  }
  /// Goes where `other` is, which becomes what this one was, and has seen no violation.
  void Exchange(Moment& other);
  /// It begins at a moment, of whose past nothing is known: a property is then looked at from there.
  void BeginAt(sim::Engine& engine);
  /// `part` has been executed.
  void AfterPart(sim::Engine& engine, sim::Clock::Part part);
  /// The first violation: "'never U4A8 and U4A9' does not hold"; stays.
  const std::optional<std::string>& violation() const { return violation_; }
  /// The violation has been dealt with: the next one is looked for.
  void GoOn() { violation_.reset(); }

 private:
  /// A number that lives from period to period (HoldsByCounting).
  struct Count {
    uint32_t variable;
    terms::TermId next;  // what it is after a period
  };
  struct Watched {
    std::string text;
    prove::properties::PropertyKind kind;
    terms::TermId holds;
    std::vector<Count> counts;  // the last one of a response: since when it has been waited for
  };

  bool IsEndOfPeriod(sim::Engine& engine, sim::Clock::Part part);
  bool IsTimed() const { return program_.schedule.fast_ms != 0; }

  const ir::Program& program_;
  std::vector<ir::Place> places_;  // of the first variables
  terms::Terms terms_;
  std::vector<Watched> properties_;
  std::vector<uint64_t> values_;  // by variable
  bool sliced_ = false;
  uint64_t slow_done_ = 0;
  uint32_t fast_since_slow_ = 0;  // parts; counted where they have a time of their own
  bool is_off_schedule_ = false;  // something ran that is no part of a period
  std::optional<std::string> violation_;
};

}  // namespace plcxx::scenarios
