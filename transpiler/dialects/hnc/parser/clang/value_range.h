// Which numbers an integer expression can have, as its text alone says: by types, widths of bit-fields, constants and
// the operators above them. What is known of variables at a place is lowering's (intervals.h).
#pragma once

#include <cstdint>

#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

struct ValueRange {
  int64_t least = 0, most = 0;
};

/// Of an lvalue: what it can hold. All that fits into 64 bits where the expression is no integer.
ValueRange ValueRangeOf(const Unit& unit, ExprId id);

}  // namespace plcxx::hnc
