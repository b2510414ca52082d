// The dialect classicladder.
#pragma once

#include "transpiler/dialects/dialect.h"

namespace plcxx::classicladder {

extern const dialects::Dialect kClassicladder;

}  // namespace plcxx::classicladder
