// What the system says of an error, as our messages are written.
#pragma once

#include <string>

namespace plcxx::support {

/// Of an `errno`: lower case at the beginning, no full stop.
std::string SystemWords(int error);

}  // namespace plcxx::support
