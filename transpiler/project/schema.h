// The JSON schema of plcxx.yaml, for editors that complete and check it while it is typed.
#pragma once

#include <string>

namespace plcxx::project {

/// JSON Schema, draft 7, made from the table of keys; the same bytes each time.
std::string Schema();

}  // namespace plcxx::project
