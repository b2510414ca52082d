// Comparisons of floating point, binary32 or binary64 by the width of the values.
#pragma once

#include "transpiler/symbolic/meaning/value.h"
#include "transpiler/symbolic/terms/floats.h"

namespace plcxx::meaning {

inline Value IsLess(Value a, Value b) { return a.With(terms::FloatLess(*a.terms, a.id, b.id)); }
inline Value IsAtMost(Value a, Value b) { return a.With(terms::FloatLessEqual(*a.terms, a.id, b.id)); }
inline Value IsEqual(Value a, Value b) { return a.With(terms::FloatEqual(*a.terms, a.id, b.id)); }

}  // namespace plcxx::meaning
