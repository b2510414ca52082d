// The dialect prostep: PRONUM 630T and 640FC.
#pragma once

#include "transpiler/dialects/dialect.h"

namespace plcxx::prostep {

extern const dialects::Dialect kProstep;

}  // namespace plcxx::prostep
