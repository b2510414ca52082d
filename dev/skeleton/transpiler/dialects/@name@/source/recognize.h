// Whether a text is a program of dialect @name@, for sources without a telling extension.
#pragma once

#include <string_view>

namespace plcxx::@name@ {

bool Recognize(std::string_view text);

}  // namespace plcxx::@name@
