// Parts of a text that is hashed, each with its size: where one part ends and the next one begins is part of the text.
#pragma once

#include <string>
#include <string_view>

namespace plcxx::support {

/// ("ab", "c") -> "2:ab1:c"
inline void AddSized(std::string& all, std::string_view part) {
  all += std::to_string(part.size());
  all += ':';
  all += part;
}

}  // namespace plcxx::support
