// An element of a table, by an index that is a term.
//
// Two tables with the same elements give the same term wherever they begin and however wide their index is: what the
// index is made of is looked at bit by bit, from the most significant one on. In: the elements. Not its job: to tell
// which elements there are.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

struct TableElement {
  uint64_t index = 0;
  TermId value;
};

/// `elements` ascending, each index once. `otherwise`: for every other index; none: there is no other. Where `given`
/// does not hold, the element may be any.
TermId LookUp(Terms& terms, TermId given, TermId index, const std::vector<TableElement>& elements, TermId otherwise);

}  // namespace plcxx::terms
