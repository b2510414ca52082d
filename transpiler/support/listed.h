// Names as a sentence has them: "A, B and 4 more", "A, B, C".
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

/// "a, b, c": of a range of texts.
template <class Texts>
std::string CommaSeparated(const Texts& words) {
  std::string joined;
  for (const auto& word : words) {
    if (!joined.empty()) joined += ", ";
    joined += word;
  }
  return joined;
}

}  // namespace plcxx::support
