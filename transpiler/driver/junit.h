// JUnit XML of a run of scenarios or of proofs, as build servers read it. Same run, same bytes: no date, no duration.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "transpiler/scenarios/test_case.h"

namespace plcxx::driver {

/// What the cases are, and so which command found them out.
enum class JunitOf : uint8_t { kScenarios, kProperties };

std::string JunitXml(std::span<const scenarios::TestCase> cases, JunitOf what);

}  // namespace plcxx::driver
