// What `plcxx prove` found out, as text, JSON and test cases.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/driver/junit.h"
#include "transpiler/driver/prove_properties.h"
#include "transpiler/driver/prove_scenario.h"
#include "transpiler/prove/properties/check.h"

namespace plcxx::driver {

struct ProvedProperty {
  PlacedProperty placed;
  prove::properties::PropertyResult result;
  PropertyScenario scenario;  // of a violation
  std::string file;           // where the scenario was written; empty: nowhere
};

enum class Colours : uint8_t { kNone, kTerminal };

/// One property, with all its lines.
std::string ProveText(const ProvedProperty& proved, Colours colours);
/// "3 properties: 1 proved, 1 violated, 1 not decided"
std::string ProveSummary(const std::vector<ProvedProperty>& all);
std::string ProveJson(const std::vector<ProvedProperty>& all);
std::vector<TestCase> ProveCases(const std::vector<ProvedProperty>& all);

}  // namespace plcxx::driver
