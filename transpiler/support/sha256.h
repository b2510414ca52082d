// SHA-256 (FIPS 180-4) of a text: tells whether bytes are the same as those seen before.
#pragma once

#include <string>
#include <string_view>

namespace plcxx::support {

/// 64 hexadecimal digits.
std::string Sha256(std::string_view bytes);

}  // namespace plcxx::support
