#include "transpiler/symbolic/terms/sign_extended.h"

namespace plcxx::terms {

TermId SignExtended(Terms& terms, TermId id) {
  const Term term = terms[id];
  if (term.kind != TermKind::kConcat) return {};
  const Term above = terms[TermId(term.a)];
  const TermId number(term.b);
  if (above.kind != TermKind::kIte || !terms.IsConst(TermId(above.b)) || !terms.IsZero(TermId(above.c))) return {};
  if (terms.Value(TermId(above.b)) != Masked(~uint64_t{0}, above.width)) return {};
  const auto sign = static_cast<uint8_t>(terms.Width(number) - 1);
  return TermId(above.a) == terms.Extract(number, sign, 1) ? number : TermId();
}

}  // namespace plcxx::terms
