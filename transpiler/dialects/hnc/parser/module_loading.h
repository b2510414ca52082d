// The module with the C parser: where it is, and its function.
#pragma once

#include <string>

#include "transpiler/dialects/hnc/parser/module.h"

namespace plcxx::hnc {

/// None, with the reason in words, when this installation has no module. Loads it once.
ParseFunction LoadParser(std::string& reason);

}  // namespace plcxx::hnc
