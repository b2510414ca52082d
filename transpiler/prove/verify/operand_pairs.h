// What is enough for two terms to be equal: that the operands are equal in which two equal operations differ.
//
// A solver multiplies and divides bit by bit, and knows nothing of two products but that. Where only the factors are
// written otherwise, and are equal only where the program may come to (an index in its range), it is the factors that
// it should be asked about.
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/symbolic/solver/sweep.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::verify {

/// What is done with two choices in which something is multiplied or divided: they are asked about as they are, or
/// condition by condition and branch by branch.
enum class Choices : uint8_t { kAsked, kTakenApart };

struct PairWhere {
  solver::TermPair pair;
  terms::TermId given;  // of width 1
};

/// Pairs of which each being equal where its condition holds makes `asked.pair` equal where `asked.given` does:
/// x * y + 1 and z * y + 1 -> x and z; (c ? x : y) * z and y * z -> x and y where c holds. None where the two do not
/// multiply or divide alike, or there are more than a few.
std::vector<PairWhere> OperandPairs(terms::Terms& terms, const PairWhere& asked, Choices choices);

}  // namespace plcxx::prove::verify
