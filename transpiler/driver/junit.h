// JUnit XML of a test run, as build servers read it. Same run, same bytes: no date, no duration.
#pragma once

#include <span>
#include <string>

#include "transpiler/scenarios/test_case.h"

namespace plcxx::driver {

std::string JunitXml(std::span<const scenarios::TestCase> cases);

}  // namespace plcxx::driver
