// What the whole program is checked for beside its lowering: calls, registrations, and the warnings of 10.3.
//
// In: tree and facts. Out: diagnostics only.
#pragma once

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/hnc/analysis/facts.h"
#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

struct CheckContext {
  const Unit& unit;
  const Objects& objects;
  const Facts& facts;
  const source::SourceManager& sources;
  diag::Engine& diagnostics;
};

void Check(const Unit& unit, const Objects& objects, const Facts& facts, const source::SourceManager& sources,
           diag::Engine& diagnostics);

// Its parts, one file each.
/// Recursion, call depth, what is called outside of its place (6.4, 7.3).
void CheckCalls(const CheckContext& context);
/// Names that are not used, stores that others overwrite, periods, handlers.
void CheckUsage(const CheckContext& context);
/// Single expressions: without effect, decided by their types, read otherwise than they look.
void CheckExpressions(const CheckContext& context);

}  // namespace plcxx::hnc
