// Texts in columns of a monospace display: letters of any script, not bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace plcxx::source {

/// How many columns a text in UTF-8 takes.
size_t ColumnsOf(std::string_view text);

/// Filled with spaces up to `width` columns, on the left or on the right of the text; longer ones stay as they are.
std::string RightAligned(std::string text, size_t width);
std::string LeftAligned(std::string text, size_t width);

}  // namespace plcxx::source
