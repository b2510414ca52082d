#include "transpiler/symbolic/terms/division.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace plcxx::terms {
namespace {

constexpr uint8_t kMostShift = 62;  // powers of two and what is compared with them stay below 64 bits

struct Quotient {
  TermId number;
  uint64_t divisor = 0;
};

constexpr int kMostDivisions = 24;  // eight decimal digits, each divided and cut
constexpr int kDepthOfChoice = 2;   // it has two ways

TermId BelowZeros(const Terms& terms, TermId id) {
  while (terms[id].kind == TermKind::kConcat && terms.IsZero(TermId(terms[id].a))) id = TermId(terms[id].b);
  return id;
}

/// A choice is not above its greater part, and x is below c where x < c is why it is chosen.
uint64_t GreatestIn(const Terms& terms, TermId id, int steps) {
  const Term term = terms[id];
  const uint64_t all = Masked(~uint64_t{0}, term.width);
  if (term.kind == TermKind::kConst) return terms.Value(id);
  if (steps <= 0) return all;
  switch (term.kind) {
    case TermKind::kConcat: {
      const TermId low(term.b);
      if (terms.IsZero(TermId(term.a))) return GreatestIn(terms, low, steps - 1);
      return all;
    }
    case TermKind::kExtract: {
      if (term.b != 0) return all;
      return std::min(all, GreatestIn(terms, TermId(term.a), steps - 1));
    }
    case TermKind::kIte: {
      const uint64_t otherwise = GreatestIn(terms, TermId(term.c), steps - kDepthOfChoice);
      if (otherwise == all) return all;
      uint64_t then = GreatestIn(terms, TermId(term.b), steps - kDepthOfChoice);
      const Term condition = terms[TermId(term.a)];
      if (condition.kind == TermKind::kUlt && terms.IsConst(TermId(condition.b)) &&
          BelowZeros(terms, TermId(condition.a)) == BelowZeros(terms, TermId(term.b)))
        then = std::min(then, terms.Value(TermId(condition.b)) - 1);
      return std::max(then, otherwise);
    }
    case TermKind::kUdiv:
    case TermKind::kUrem: {
      const TermId divisor(term.b);
      if (!terms.IsConst(divisor) || terms.IsZero(divisor)) return all;
      const uint64_t number = GreatestIn(terms, TermId(term.a), steps - 1);
      if (term.kind == TermKind::kUdiv) return number / terms.Value(divisor);
      return std::min(number, terms.Value(divisor) - 1);
    }
    case TermKind::kConst:
    case TermKind::kVariable:
    case TermKind::kNot:
    case TermKind::kAnd:
    case TermKind::kOr:
    case TermKind::kXor:
    case TermKind::kAdd:
    case TermKind::kSub:
    case TermKind::kMul:
    case TermKind::kSdiv:
    case TermKind::kSrem:
    case TermKind::kShl:
    case TermKind::kLshr:
    case TermKind::kAshr:
    case TermKind::kEq:
    case TermKind::kUlt:
    case TermKind::kSlt:
    case TermKind::kApply:
      return all;
  }
  PLCXX_UNREACHABLE();
}

/// The division that the low bits of a quotient come from; divisor 0: it is none.
Quotient QuotientOf(const Terms& terms, TermId id) {
  Term term = terms[id];
  while (term.kind == TermKind::kConcat && terms.IsZero(TermId(term.a))) term = terms[TermId(term.b)];
  if (term.kind == TermKind::kExtract && term.b == 0) term = terms[TermId(term.a)];
  if (term.kind != TermKind::kUdiv || !terms.IsConst(TermId(term.b))) return {};
  return {TermId(term.a), terms.Value(TermId(term.b))};
}

}  // namespace

uint64_t GreatestOf(const Terms& terms, TermId id) { return GreatestIn(terms, id, kMostDivisions); }

uint8_t WidthOfDivision(uint64_t greatest) {
  constexpr int kByte = 8;
  return static_cast<uint8_t>(
      std::bit_ceil(static_cast<unsigned>(std::max(kByte, static_cast<int>(std::bit_width(greatest))))));
}

TermId QuotientOfProduct(Terms& terms, TermId product, uint8_t shift) {
  const Term term = terms[product];
  if (term.kind != TermKind::kMul || shift > kMostShift) return {};
  for (const auto& [factor, number] : {std::pair(TermId(term.a), TermId(term.b)), {TermId(term.b), TermId(term.a)}}) {
    const Term wide = terms[number];
    if (!terms.IsConst(factor) || wide.kind != TermKind::kConcat || !terms.IsZero(TermId(wide.a))) continue;
    const TermId x(wide.b);
    const uint64_t greatest = Masked(~uint64_t{0}, terms.Width(x)), m = terms.Value(factor);
    const uint64_t power = uint64_t{1} << shift;
    if (m < 2 || m >= power || greatest > Masked(~uint64_t{0}, term.width) / m) continue;
    // m * d = 2^shift + excess, so that x * m / 2^shift is too large by x * excess / (d * 2^shift): no whole number is
    // reached while that is less than 1 / d.
    const uint64_t divisor = (power + m - 1) / m;
    const uint64_t excess = m * divisor - power;
    if (divisor > greatest || (excess != 0 && greatest > (power - 1) / excess)) continue;
    return terms.Zext(terms.Udiv(x, terms.Const(divisor, terms.Width(x))), term.width);
  }
  return {};
}

TermId RemainderOfSum(Terms& terms, TermId a, TermId b) {
  const uint8_t width = terms.Width(a);
  for (const auto& [rest, multiple] : {std::pair(a, b), std::pair(b, a)}) {
    const Term product = terms[multiple];
    if (product.kind != TermKind::kMul) continue;
    for (const auto& [factor, other] :
         {std::pair(TermId(product.a), TermId(product.b)), {TermId(product.b), TermId(product.a)}}) {
      if (!terms.IsConst(factor)) continue;
      const auto [number, divisor] = QuotientOf(terms, other);
      if (divisor == 0 || Masked(uint64_t{0} - divisor, width) != terms.Value(factor)) continue;
      // Of both, the same low bits: all others of the quotient and of the number have no place in the sum.
      const TermId divisor_term = terms.Const(divisor, terms.Width(number));
      if (terms.Resize(terms.Udiv(number, divisor_term), width) != other) continue;
      if (terms.Resize(number, width) != rest) continue;
      return terms.Resize(terms.Urem(number, divisor_term), width);
    }
  }
  return {};
}

}  // namespace plcxx::terms
