// Why a wish of the operator was not granted.
#pragma once

#include <string>

namespace plcxx::live {

/// Lower case, no full stop. Empty: it was.
using Refusal = std::string;

}  // namespace plcxx::live
