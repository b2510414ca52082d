// Names that a file can have on every system.
#pragma once

#include <algorithm>
#include <string_view>

namespace plcxx::support {

/// Letters, digits, '_', '-' and '.', and does not leave its directory.
inline bool IsFileName(std::string_view name) {
  const auto allowed = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '-' ||
           c == '.';
  };
  return !name.empty() && name.front() != '.' && name.front() != '-' && std::ranges::all_of(name, allowed);
}

}  // namespace plcxx::support
