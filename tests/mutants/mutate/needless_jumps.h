// Jumps that go where the program goes without them: the last `break` of a switch, a `continue` that ends a loop's
// body, a `return` that ends a function without a result, also as the last statement of an arm in such a place, and one
// that is followed only by another such jump. Without them the program is the same one by construction: no test could
// see it, and no mutant is made.
#pragma once

#include <clang/AST/Stmt.h>

#include <set>

namespace plcxx::mutants {

using Jumps = std::set<const clang::Stmt*>;

/// `body` of a function without a result.
void AddNeedlessReturns(const clang::Stmt* body, Jumps& needless);
void AddNeedlessContinues(const clang::Stmt* loop_body, Jumps& needless);
void AddNeedlessBreaks(const clang::Stmt* switch_body, Jumps& needless);

}  // namespace plcxx::mutants
