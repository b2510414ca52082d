// For tests that edit a program: what is written in its scenario, as files.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "transpiler/scenarios/scenario.h"

namespace plcxx {

/// The texts by the names of their files; from then on the scenario names files that stand beside it.
inline std::map<std::string, std::string> TakeTexts(scenarios::Scenario& scenario) {
  std::map<std::string, std::string> files;
  for (std::string& source : scenario.sources) {
    const auto text = scenario.texts.find(source);
    if (text == scenario.texts.end()) continue;
    source.erase(0, source.rfind('/') + 1);
    files[source] = std::move(text->second);
  }
  scenario.texts.clear();
  return files;
}

}  // namespace plcxx
