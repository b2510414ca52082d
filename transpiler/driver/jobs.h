// --jobs of commands that work on all processors where nothing else is said.
#pragma once

#include <algorithm>
#include <thread>

namespace plcxx::driver {

/// `jobs`: as it was asked for; 0: it was not.
inline unsigned JobsOf(unsigned jobs) { return jobs != 0 ? jobs : std::max(1U, std::thread::hardware_concurrency()); }

}  // namespace plcxx::driver
