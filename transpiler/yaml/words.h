// Words of YAML that the tool writes.
#pragma once

#include <string>
#include <string_view>

namespace plcxx::yaml {

/// A text as YAML reads it back: as it is where it has but letters, digits and characters of `plain`, else in quotes.
std::string YamlWord(const std::string& text, std::string_view plain);

}  // namespace plcxx::yaml
