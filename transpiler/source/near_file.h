// What a file that is not there may have been meant to be.
#pragma once

#include <string>

namespace plcxx::source {

/// ", did you mean 'door.plc'": a file beside the one that is not there, by its name or by its stem; empty: none is
/// near.
std::string DidYouMeanFile(const std::string& path);

}  // namespace plcxx::source
