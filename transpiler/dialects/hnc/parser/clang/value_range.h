// Which numbers an integer expression can have, as its text alone says: by types, widths of bit-fields, constants and
// the operators above them. What is known of variables at a place is lowering's (intervals.h).
#pragma once

#include "transpiler/dialects/hnc/syntax/bounds.h"

namespace plcxx::hnc {

/// Of an lvalue: what it can hold. All that fits into 64 bits where the expression is no integer.
Bounds ValueRangeOf(const Unit& unit, ExprId id);

}  // namespace plcxx::hnc
