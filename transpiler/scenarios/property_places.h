// Properties from where they stand: files of properties, scenarios. What is wrong with them becomes diagnostics.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/prove/properties/property.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/source/source.h"

namespace plcxx::scenarios {

struct PlacedProperty {
  std::string path;
  prove::properties::Property property;
};

/// What is wrong with a property, and the remedy, in one line.
std::string TextOf(const prove::properties::PropertyError& error, std::string_view dialect);

/// The properties of a file's text. Errors are reported at their places in it.
std::vector<PlacedProperty> PropertiesOfFile(const std::string& path, const std::string& text, std::string_view dialect,
                                             const prove::properties::PropertyContext& context,
                                             source::SourceManager& sources, diag::Engine& diagnostics);

/// Those of a scenario; its text is read again, so that messages can show it.
std::vector<PlacedProperty> PropertiesOfScenario(const Scenario& scenario, std::string_view dialect,
                                                 const prove::properties::PropertyContext& context,
                                                 source::SourceManager& sources, diag::Engine& diagnostics);

/// The same for a run of the scenario: the errors as the scenario's own.
std::vector<prove::properties::Property> WatchedProperties(const Scenario& scenario, std::string_view dialect,
                                                           const prove::properties::PropertyContext& context,
                                                           std::vector<ScenarioError>& errors);

}  // namespace plcxx::scenarios
