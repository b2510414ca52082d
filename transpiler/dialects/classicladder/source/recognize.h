// Whether a text is a program of dialect classicladder, for sources without a telling extension.
#pragma once

#include <string_view>

namespace plcxx::classicladder {

bool Recognize(std::string_view text);

}  // namespace plcxx::classicladder
