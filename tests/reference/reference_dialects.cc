#include "tests/reference/reference_dialects.h"

#include <algorithm>
#include <array>

#include "tests/reference/host50_reference.h"
#include "tests/reference/nc110_reference.h"
#include "tests/reference/prostep.h"
#include "tests/reference/technol.h"

namespace plcxx::reference {
namespace {

constexpr std::array kDialects = {
    ReferenceDialect{.name = "nc110", .make = MakeNc110, .generate = RandomNc110, .unsupported_scenarios = 0},
    ReferenceDialect{.name = "host50", .make = MakeHost50, .generate = RandomHost50, .unsupported_scenarios = 0},
    ReferenceDialect{.name = "prostep", .make = MakeProstepReference, .generate = MakeRandomProstep},
    ReferenceDialect{.name = "technol",
                     .make = MakeTechnolReference,
                     .generate = MakeRandomTechnol,
                     .spelling_cuts_statements = true},
};

}  // namespace

std::span<const ReferenceDialect> ReferenceDialects() { return kDialects; }

const ReferenceDialect* FindReference(std::string_view dialect) {
  const auto* const found = std::ranges::find(kDialects, dialect, &ReferenceDialect::name);
  return found == kDialects.end() ? nullptr : &*found;
}

}  // namespace plcxx::reference
