// What a property says about a run, as terms over the values of cells after each period.
#pragma once

#include <cstdint>
#include <functional>

#include "transpiler/prove/properties/property.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::properties {

/// The value of a cell after a period; periods are counted from 1.
using ValueAfter = std::function<terms::TermId(execute::CellId cell, uint32_t period)>;

/// Whether `period` does not violate the property: a response that was due there has come. What lies before period 1
/// has not held. Not for kNeverStuck.
terms::TermId HoldsAfter(terms::Terms& terms, const Property& property, uint32_t period, const ValueAfter& value);

/// A count that lives from period to period, 0 at power-on: `next` gets what it was, and gives what it is.
using CountPeriods =
    std::function<terms::TermId(uint32_t most, const std::function<terms::TermId(terms::TermId before)>& next)>;

/// The same of the period that `value` tells, with counts instead of the periods before it: what is held for long, and
/// what is waited for, is one number. The last count of a response is how long the oldest question has been open.
terms::TermId HoldsByCounting(terms::Terms& terms, const Property& property,
                              const std::function<terms::TermId(execute::CellId cell)>& value,
                              const CountPeriods& count);

/// How many periods HoldsAfter looks at, the present one included.
uint32_t WindowOf(const Property& property);

/// The value of an operand after a period, as wide as it is.
terms::TermId ValueOf(terms::Terms& terms, const PropertyOperand& operand, uint32_t period, const ValueAfter& value);

}  // namespace plcxx::prove::properties
