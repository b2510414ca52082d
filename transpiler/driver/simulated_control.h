// The option of a dialect that lets a simulated control answer the program's requests; `sim` and `live` switch it on.
#pragma once

#include <algorithm>

#include "transpiler/dialects/dialect.h"

namespace plcxx::driver {

inline constexpr const char* kStubOption = "nc-stub";

inline bool HasStub(const dialects::Dialect& dialect) {
  return std::ranges::any_of(dialect.options, [](const auto& option) { return option.key == kStubOption; });
}

}  // namespace plcxx::driver
