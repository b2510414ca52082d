// The dialect host50 as the driver sees it.
#pragma once

#include "transpiler/dialects/dialect.h"

namespace plcxx::host50 {

extern const dialects::Dialect kHost50;

}  // namespace plcxx::host50
