// Texts in columns and lists.
#pragma once

#include <string>

namespace plcxx::support {

/// Filled with spaces up to `width`, on the left or on the right of the text; longer ones stay as they are.
inline std::string RightAligned(std::string text, size_t width) {
  text.insert(0, width > text.size() ? width - text.size() : 0, ' ');
  return text;
}
inline std::string LeftAligned(std::string text, size_t width) {
  text.append(width > text.size() ? width - text.size() : 0, ' ');
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
