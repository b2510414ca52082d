// The tool `why`: which conditions make a signal what it is.
#pragma once

#include "transpiler/mcp/command.h"

namespace plcxx::mcp {

Json WhySchema();
Json RunWhy(const Workplace& workplace, const Json& arguments);

}  // namespace plcxx::mcp
