// Does a text look like a source of dialect host50?
#pragma once

#include <string_view>

namespace plcxx::host50 {

/// Yes when a line begins with NETWORK or with the END word of a part.
bool Recognize(std::string_view text);

}  // namespace plcxx::host50
