// The dialect nc110 as the driver sees it.
#pragma once

#include "transpiler/dialects/dialect.h"

namespace plcxx::nc110 {

extern const dialects::Dialect kNc110;

}  // namespace plcxx::nc110
