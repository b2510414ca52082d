// What magnitudes of numbers with a sign are made of: x < 0 ? 0 - x : x.
#pragma once

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// Whether a term is 0 - x of this x.
inline bool IsNegOf(const Terms& terms, TermId negated, TermId of) {
  const Term& term = terms[negated];
  return term.kind == TermKind::kSub && terms.IsZero(TermId(term.a)) && TermId(term.b) == of;
}

/// Whether a bit is the highest one of this word.
inline bool IsSignOf(const Terms& terms, TermId bit, TermId of) {
  const Term& term = terms[bit];
  return term.kind == TermKind::kExtract && term.width == 1 && TermId(term.a) == of && term.b + 1 == terms.Width(of);
}

}  // namespace plcxx::terms
