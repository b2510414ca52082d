// Where lines begin. CR LF, LF and CR each end a line.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace plcxx::source {

/// The first is 0; the last may be the end of the text, when a line end is the last thing in it.
std::vector<uint32_t> FindLineStarts(std::string_view text);

}  // namespace plcxx::source
