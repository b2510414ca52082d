// A process that serves many requests outlives a fault of plcxx in one of them.
//
// Without a guard a failed check ends the process (check.h): for a command that is the right thing. A server has
// promised its client not to exit; what it was about to say is lost, everything else is not.
#pragma once

#include <stdexcept>

namespace plcxx::support {

/// A failed check, as text.
struct FaultError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// While one lives, a failed check of this thread throws FaultError.
class FaultGuard {
 public:
  FaultGuard();
  ~FaultGuard();
  FaultGuard(const FaultGuard&) = delete;
  FaultGuard& operator=(const FaultGuard&) = delete;

  /// Whether one lives in this thread.
  static bool IsActive();
};

}  // namespace plcxx::support
