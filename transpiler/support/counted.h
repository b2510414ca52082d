// A number and what it counts, as messages say it: "1 period", "2 periods".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace plcxx::support {

inline std::string Counted(uint64_t count, std::string_view what) {
  return std::to_string(count) + " " + std::string(what) + (count == 1 ? "" : "s");
}

}  // namespace plcxx::support
