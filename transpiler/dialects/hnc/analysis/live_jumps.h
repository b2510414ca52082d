// Which gotos of a function control can get to, before anything is lowered: a label that only dead gotos name is dead
// itself, and a goto further down may bring a dead region back to life.
//
// Example: in `return; again: g++; if (g < 5) goto again;` nothing is alive; with `if (h) goto again;` in front of the
// return, all of it is.
#pragma once

#include <unordered_set>

#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

/// The gotos (index of their StatementId) of the statements that control can get to. Never fewer than the lowering
/// finds: like it, it takes both arms of an if for possible, and a loop or a switch as what C says of any condition
/// that is no constant expression.
std::unordered_set<uint32_t> FindLiveGotos(const Unit& unit, StatementId body);

/// Whether a goto may be refused, so that control goes on after it: an annotation bounds its iterations.
bool MayBeRefused(const Unit& unit, const Statement& jump);

/// The value of a condition that is a constant expression; none: it is not.
std::optional<bool> ConstantCondition(const Unit& unit, ExprId id);

}  // namespace plcxx::hnc
