// The dialect @name@.
#pragma once

#include "transpiler/dialects/dialect.h"

namespace plcxx::@name@ {

extern const dialects::Dialect k@Name@;

}  // namespace plcxx::@name@
