// The mark that some editors write in front of UTF-8: it says how a file is written, and is none of its text.
#pragma once

#include <string>
#include <string_view>

namespace plcxx::support {

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

inline void RemoveByteOrderMark(std::string& text) {
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
}

}  // namespace plcxx::support
