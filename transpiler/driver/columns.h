// Texts in columns and lists.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plcxx::driver {

/// Filled with spaces up to `width`, on the left or on the right of the text; longer ones stay as they are.
inline std::string RightAligned(std::string text, size_t width) {
  text.insert(0, width > text.size() ? width - text.size() : 0, ' ');
  return text;
}
inline std::string LeftAligned(std::string text, size_t width) {
  text.append(width > text.size() ? width - text.size() : 0, ' ');
  return text;
}

/// "a, b, c"
inline std::string CommaSeparated(const std::vector<std::string_view>& words) {
  std::string joined;
  for (const std::string_view word : words) {
    if (!joined.empty()) joined += ", ";
    joined += word;
  }
  return joined;
}

}  // namespace plcxx::driver
