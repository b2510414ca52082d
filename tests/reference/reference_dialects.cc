#include "tests/reference/reference_dialects.h"

#include <algorithm>
#include <array>

namespace plcxx::reference {
namespace {

constexpr std::array<ReferenceDialect, 0> kDialects = {};

}  // namespace

std::span<const ReferenceDialect> ReferenceDialects() { return kDialects; }

const ReferenceDialect* FindReference(std::string_view dialect) {
  const auto* const found = std::ranges::find(kDialects, dialect, &ReferenceDialect::name);
  return found == kDialects.end() ? nullptr : &*found;
}

}  // namespace plcxx::reference
