// How much of a claim a test looks at. `dev/test` takes a sample that is the same everywhere; `dev/test --all` sets
// PLCXX_ALL_TARGETS and takes everything.
#pragma once

#include <cstdlib>
#include <string_view>

namespace plcxx::testing_support {

inline bool IsWholeVolume() {
  const char* const value = std::getenv("PLCXX_ALL_TARGETS");
  return value != nullptr && *value != '\0' && std::string_view(value) != "0";
}

/// How many of something: `sample`, or `whole` of them.
template <class Count>
Count Volume(Count sample, Count whole) {
  return IsWholeVolume() ? whole : sample;
}

}  // namespace plcxx::testing_support
