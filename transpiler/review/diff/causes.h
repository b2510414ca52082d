// Why an item differs: the statements that write it, the changed ones before them, and the items that they read.
//
// In: both versions, the items of a comparison with their cells. Out: the items' statements and what they are
// different through. Not its job: verdicts.
#pragma once

#include <vector>

#include "transpiler/review/diff/named_items.h"

namespace plcxx::review::diff {

void AddCauses(std::vector<NamedItem>& items, const Named& old_side, const Named& new_side);

}  // namespace plcxx::review::diff
