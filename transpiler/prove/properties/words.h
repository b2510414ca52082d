// The words of one line of a file of properties.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plcxx::prove::properties {

struct PropertyWord {
  std::string text;     // without quotes
  uint32_t column = 0;  // 1-based, in bytes
  uint32_t length = 0;  // as written
  bool quoted = false;  // a location, whatever it looks like
  bool is_end = false;  // after the last one
};

/// Up to a comment; the last word is the end. `unclosed`: a quote has no partner; what follows it is the last word.
struct PropertyLine {
  std::vector<PropertyWord> words;
  std::string text;  // the line without comment and blanks around it
  bool unclosed = false;
};
PropertyLine SplitProperty(std::string_view line);

}  // namespace plcxx::prove::properties
