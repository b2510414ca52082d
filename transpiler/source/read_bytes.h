// The bytes of a file or of standard input, never more than allowed.
#pragma once

#include <string>
#include <variant>

#include "transpiler/source/source.h"

namespace plcxx::source {

/// A file above `max_bytes` is refused by its size, before it is opened; what is no file (a device, a pipe that
/// is not support::IsOpened) unopened.
std::variant<std::string, LoadError> ReadBytes(const std::string& path, size_t max_bytes);
std::variant<std::string, LoadError> ReadStandardInput(size_t max_bytes);

/// The words for a text above the limit.
LoadError TooLarge(size_t max_bytes);

}  // namespace plcxx::source
