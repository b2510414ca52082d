// Checks for faults of plcxx itself. A wrong source program is a diagnostic, never a check.
//
// PLCXX_CHECK(condition) << nothing: it prints the place and ends the process with exit code 3
// (section 1 of the design: "a fault of plcxx itself, with a request to report it").
#pragma once

namespace plcxx::support {

/// Prints the failed condition with a request to report it and ends the process with exit code 3.
[[noreturn]] void InternalFault(const char* condition, const char* file, int line);

}  // namespace plcxx::support

#define PLCXX_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::plcxx::support::InternalFault(#condition, __FILE__, __LINE__))
#define PLCXX_UNREACHABLE() ::plcxx::support::InternalFault("unreachable", __FILE__, __LINE__)
