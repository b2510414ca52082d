// The headers of runtime_support as files beside generated code.
#pragma once

#include <string>

namespace plcxx::compile {

/// Writes them to `directory`/plcxx, which is made when missing. False when one of them cannot be written.
bool WriteRuntime(const std::string& directory);

}  // namespace plcxx::compile
