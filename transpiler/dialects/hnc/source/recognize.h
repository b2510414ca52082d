#pragma once

#include <string_view>

namespace plcxx::hnc {

/// Does a text without a telling extension look like C for this control: an #include, or two of the three entries?
bool Recognize(std::string_view text);

}  // namespace plcxx::hnc
