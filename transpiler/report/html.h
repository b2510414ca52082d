// Text as it may stand in HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace plcxx::report {

/// With &, <, >, " and ' escaped; control characters other than tab and line end become U+FFFD, and so do the marks
/// that turn the direction of a text, which could make a line read as something else.
std::string Escape(std::string_view utf8);

}  // namespace plcxx::report
