// Where lines begin and end.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "transpiler/source/source.h"

namespace plcxx::source {

/// The first is 0; the last may be the end of the text, when a line end is the last thing in it.
std::vector<uint32_t> FindLineStarts(std::string_view text, LineEnds ends);

/// The length of the line end at text[at]; 0 where no line ends.
size_t LineEndLength(std::string_view text, size_t at, LineEnds ends);

/// A line with its end, as two line starts cut it, without the end.
std::string_view WithoutLineEnd(std::string_view line, LineEnds ends);

}  // namespace plcxx::source
