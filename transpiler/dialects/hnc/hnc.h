// Dialect hnc: PLC programs in C for the Huazhong Century Star controls.
#pragma once

#include "transpiler/dialects/dialect.h"

namespace plcxx::hnc {

extern const dialects::Dialect kHnc;

}  // namespace plcxx::hnc
