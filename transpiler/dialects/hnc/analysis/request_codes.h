// The codes of M, S, T and B functions that a function knows: cases and comparisons of the words of requests (7.3).
//
// In: the tree, its objects and facts. Out: codes with their places. Not its job: what is done with a code.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "transpiler/dialects/hnc/analysis/facts.h"
#include "transpiler/dialects/hnc/analysis/objects.h"
#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

struct RequestCode {
  size_t kind = 0;              // index into kHandlerKinds
  int64_t first = 0, last = 0;  // `mod_T_code(ch) / 100` has a hundred codes for a case
  source::Range place;
};

/// In the order of the source. A word that a variable takes, be it divided, is followed as far as the function goes.
std::vector<RequestCode> RequestCodes(const Unit& unit, const Objects& objects, const Facts& facts, FunctionId id);

}  // namespace plcxx::hnc
