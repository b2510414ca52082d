// The JSON schemas of plant.yaml and panel.yaml, for editors.
#pragma once

#include <string>

namespace plcxx::plant {

std::string PlantSchema();
std::string PanelSchema();

}  // namespace plcxx::plant
