// Where values are that are not there.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace plcxx::yaml {

/// The parser puts what is missing ("run:", and a line's end) where the next word is, lines further down. Puts it
/// behind the colon or the dash after which it is missing. `text`: what the tree was read from.
void PlaceMissingValues(YAML::Node& root, const std::string& text);

}  // namespace plcxx::yaml
