// What `plcxx prove` found out, as text, JSON and test cases.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/driver/junit.h"
#include "transpiler/prove/properties/check.h"
#include "transpiler/review/properties/scenario.h"
#include "transpiler/scenarios/property_places.h"

namespace plcxx::driver {

struct ProvedProperty {
  scenarios::PlacedProperty placed;
  prove::properties::PropertyResult result;
  review::properties::PropertyScenario scenario;  // of a violation
  std::string file;                               // where the scenario was written; empty: nowhere
  std::string plant;                              // with which runs were tried; empty: with none
};

enum class Colours : uint8_t { kNone, kTerminal };

/// One property, with all its lines.
std::string ProveText(const ProvedProperty& proved, Colours colours);
/// "3 properties: 1 proved, 1 violated, 1 not decided"; `plant`: with which runs were tried, and a line what that
/// means; empty: with none.
std::string ProveSummary(const std::vector<ProvedProperty>& all, const std::string& plant);
std::string ProveJson(const std::vector<ProvedProperty>& all, const std::string& plant);
std::vector<scenarios::TestCase> ProveCases(const std::vector<ProvedProperty>& all);

}  // namespace plcxx::driver
