// Names as a sentence has them: "A, B and 4 more".
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace plcxx::support {

inline std::string Listed(const std::vector<std::string>& names, size_t most) {
  std::string text;
  for (size_t i = 0; i < std::min(names.size(), most); ++i) text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text;
}

}  // namespace plcxx::support
