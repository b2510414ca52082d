// The exit code of an internal error, which a parent process tells from every other end of its child.
#pragma once

namespace plcxx::support {

inline constexpr int kInternalFaultExit = 3;

}  // namespace plcxx::support
