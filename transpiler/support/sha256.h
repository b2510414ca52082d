// SHA-256 of a text: tells whether bytes are the same as those seen before. LLVM computes it, in the module that reads
// objects.
#pragma once

#include <string>
#include <string_view>

namespace plcxx::support {

/// 64 hexadecimal digits; empty where the module is missing.
std::string Sha256(std::string_view bytes);

/// The function of the module.
using Sha256Function = void(std::string_view bytes, std::string& digits);
inline constexpr const char* kSha256Symbol = "plcxx_sha256";

}  // namespace plcxx::support
