// Until when something may work: by the clock on the wall, or by the time that this process has had of a processor.
//
// A command that promises when it ends goes by the first. A proof whose verdict must not depend on what else the
// machine does goes by the second.
#pragma once

#include <cstdint>

#include "transpiler/symbolic/solver/solver.h"

namespace plcxx::solver {

/// kProcessor: what the thread that asks has used; a deadline is asked by the thread that made it.
enum class Clock : uint8_t { kWall, kProcessor };

class Deadline {
 public:
  /// So many milliseconds from now.
  Deadline(Clock clock, uint64_t milliseconds);

  uint64_t RestMs() const;
  bool IsOver() const { return RestMs() == 0; }
  /// For a question before it: as much effort, but not more than the rest.
  Limit LimitFor(uint32_t effort_ms) const;

 private:
  Clock clock_;
  uint64_t end_ms_;
};

}  // namespace plcxx::solver
