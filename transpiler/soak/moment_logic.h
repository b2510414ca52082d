// A property that speaks of one moment, as instructions: whether it holds now.
//
// In: a property of transpiler/prove/properties. Out: a bit, computed from bits alone, as a fleet is best at. Not its
// job: properties with times, which need what was before (scenarios/property_monitor.h).
#pragma once

#include "transpiler/ir/builder.h"
#include "transpiler/prove/properties/property.h"
#include "transpiler/symbolic/execute/cells.h"

namespace plcxx::soak {

/// Whether HoldsNow can tell: it speaks of bits in memory, without "for" and "within".
bool IsOfOneMoment(const ir::Program& program, const execute::Cells& cells,
                   const prove::properties::Property& property);

/// Written at the end of the builder's region.
ir::ValueId HoldsNow(ir::Builder& builder, const execute::Cells& cells, const prove::properties::Property& property);

}  // namespace plcxx::soak
