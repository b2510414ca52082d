#include "transpiler/symbolic/terms/intervals.h"

#include <algorithm>
#include <array>
#include <bit>

#include "transpiler/support/low_bits.h"
#include "transpiler/symbolic/terms/sign_extended.h"

namespace plcxx::terms {
namespace {

constexpr uint32_t kMostComputed = 5'000;  // Of and Assume go as deep
constexpr uint32_t kMostBranches = 12;     // of branches in branches whose conditions are looked at
constexpr size_t kMostConjuncts = 64;      // of a condition
constexpr int kMostAlternatives = 4;       // "or" in "or"
constexpr int kRounds = 3;                 // a bound may follow from another one that comes later
constexpr uint8_t kWidest = 32;            // products of such numbers fit into 64 bits

int64_t Least(uint8_t width) { return AsSigned(uint64_t{1} << (width - 1), width); }
int64_t Greatest(uint8_t width) { return static_cast<int64_t>(support::LowBits(width - 1U)); }

Interval AnyOf(uint8_t width) {
  return {.low = 0, .high = support::LowBits(width), .least = Least(width), .greatest = Greatest(width)};
}

/// Each reading says something of the other where all numbers have the same sign.
Interval Fitted(Interval one, uint8_t width) {
  const uint64_t half = uint64_t{1} << (width - 1);
  const auto bits = [width](int64_t number) { return Masked(static_cast<uint64_t>(number), width); };
  for (int i = 0; i < 2; ++i) {
    if (one.high < half || one.low >= half) {
      one.least = std::max(one.least, AsSigned(one.low, width));
      one.greatest = std::min(one.greatest, AsSigned(one.high, width));
    }
    if (one.least >= 0 || one.greatest < 0) {
      one.low = std::max(one.low, bits(one.least));
      one.high = std::min(one.high, bits(one.greatest));
    }
  }
  return one;
}

Interval Without(uint64_t low, uint64_t high, uint8_t width) {
  Interval one = AnyOf(width);
  one.low = low;
  one.high = high;
  return Fitted(one, width);
}

/// What is in both.
Interval Common(const Interval& a, const Interval& b) {
  return {.low = std::max(a.low, b.low),
          .high = std::min(a.high, b.high),
          .least = std::max(a.least, b.least),
          .greatest = std::min(a.greatest, b.greatest)};
}

bool IsEmpty(const Interval& one) { return one.low > one.high || one.least > one.greatest; }

/// What a computation without a limit gives, where it does not wrap; numbers are below 2^63 by kWidest.
void TightenSigned(Interval& one, int64_t least, int64_t greatest, uint8_t width) {
  if (least < Least(width) || greatest > Greatest(width)) return;
  one.least = std::max(one.least, least);
  one.greatest = std::min(one.greatest, greatest);
}
void TightenUnsigned(Interval& one, uint64_t low, uint64_t high, uint8_t width) {
  if (high > support::LowBits(width)) return;
  one.low = std::max(one.low, low);
  one.high = std::min(one.high, high);
}

Interval OfProduct(const Interval& a, const Interval& b, uint8_t width) {
  Interval one = AnyOf(width);
  const auto [least, greatest] =
      std::minmax({a.least * b.least, a.least * b.greatest, a.greatest * b.least, a.greatest * b.greatest});
  TightenSigned(one, least, greatest, width);
  TightenUnsigned(one, a.low * b.low, a.high * b.high, width);
  return one;
}

/// Of a divisor that is never 0 or negative: nothing overflows.
Interval OfSignedQuotient(const Interval& a, const Interval& b, uint8_t width) {
  Interval one = AnyOf(width);
  if (b.least <= 0) return one;
  const auto [least, greatest] =
      std::minmax({a.least / b.least, a.least / b.greatest, a.greatest / b.least, a.greatest / b.greatest});
  TightenSigned(one, least, greatest, width);
  return one;
}

Interval OfSignedRest(const Interval& a, const Interval& b, uint8_t width) {
  Interval one = AnyOf(width);
  if (b.least <= 0) return one;
  const int64_t most = b.greatest - 1;
  TightenSigned(one, a.least >= 0 ? 0 : std::max(-most, a.least), a.greatest <= 0 ? 0 : std::min(most, a.greatest),
                width);
  return one;
}

Interval OfBit(bool never, bool always) {
  return Fitted({.low = always ? 1U : 0U, .high = never ? 0U : 1U, .least = -1, .greatest = 0}, 1);
}

Interval IntervalOfShift(TermKind kind, const Interval& a, uint64_t by, uint8_t width) {
  Interval one = AnyOf(width);
  if (by >= width) return one;
  if (kind == TermKind::kLshr) {
    TightenUnsigned(one, a.low >> by, a.high >> by, width);
  } else if (kind == TermKind::kAshr) {
    TightenSigned(one, a.least >> by, a.greatest >> by, width);
  } else {
    return OfProduct(
        a,
        {.low = uint64_t{1} << by, .high = uint64_t{1} << by, .least = int64_t{1} << by, .greatest = int64_t{1} << by},
        width);
  }
  return one;
}

Interval IntervalOfBinary(TermKind kind, const Interval& a, const Interval& b, uint8_t width) {
  Interval one = AnyOf(width);
  const auto longest = [&] {
    return support::LowBits(static_cast<uint32_t>(std::bit_width(std::max(a.high, b.high))));
  };
  switch (kind) {
    case TermKind::kAnd:
      one.high = std::min(a.high, b.high);
      if (width == 1) one.low = a.low & b.low;
      return one;
    case TermKind::kOr:
      one.low = std::max(a.low, b.low);
      one.high = longest();
      return one;
    case TermKind::kXor:
      one.high = longest();
      return one;
    case TermKind::kAdd:
      TightenSigned(one, a.least + b.least, a.greatest + b.greatest, width);
      TightenUnsigned(one, a.low + b.low, a.high + b.high, width);
      return one;
    case TermKind::kSub:
      TightenSigned(one, a.least - b.greatest, a.greatest - b.least, width);
      if (a.low >= b.high) TightenUnsigned(one, a.low - b.high, a.high - b.low, width);
      return one;
    case TermKind::kMul:
      return OfProduct(a, b, width);
    case TermKind::kUdiv:
      if (b.low > 0) TightenUnsigned(one, a.low / b.high, a.high / b.low, width);
      return one;
    case TermKind::kUrem:
      if (b.low > 0) one.high = std::min(a.high, b.high - 1);
      return one;
    case TermKind::kSdiv:
      return OfSignedQuotient(a, b, width);
    case TermKind::kSrem:
      return OfSignedRest(a, b, width);
    case TermKind::kShl:
    case TermKind::kLshr:
    case TermKind::kAshr:
      return b.low == b.high ? IntervalOfShift(kind, a, b.low, width) : one;
    case TermKind::kEq:
      return OfBit(a.high < b.low || b.high < a.low || a.greatest < b.least || b.greatest < a.least,
                   a.low == a.high && b.low == b.high && a.low == b.low);
    case TermKind::kUlt:
      return OfBit(a.low >= b.high, a.high < b.low);
    case TermKind::kSlt:
      return OfBit(a.least >= b.greatest, a.greatest < b.least);
    case TermKind::kConst:
    case TermKind::kVariable:
    case TermKind::kNot:
    case TermKind::kIte:
    case TermKind::kConcat:
    case TermKind::kExtract:
    case TermKind::kApply:
      return one;
  }
  return one;
}

Interval Joined(const Interval& a, const Interval& b) {
  return {.low = std::min(a.low, b.low),
          .high = std::max(a.high, b.high),
          .least = std::min(a.least, b.least),
          .greatest = std::max(a.greatest, b.greatest)};
}

/// Whether Assume learns from a condition: most ask for a bit.
bool SaysBounds(const Terms& terms, TermId condition) {
  const Term term = terms[condition];
  if (term.kind == TermKind::kNot) return SaysBounds(terms, TermId(term.a));
  if (term.kind == TermKind::kExtract) return term.width == 1 && term.b == terms.Width(TermId(term.a)) - 1U;
  constexpr std::array kKinds = {TermKind::kAnd, TermKind::kOr, TermKind::kEq, TermKind::kUlt, TermKind::kSlt};
  return std::ranges::find(kKinds, term.kind) != kKinds.end();
}

Interval OfPart(const Interval& a, uint8_t low, uint8_t of_width, uint8_t width) {
  Interval one = AnyOf(width);
  if (low == 0 && a.least >= Least(width) && a.greatest <= Greatest(width)) {
    one.least = a.least;
    one.greatest = a.greatest;
  }
  TightenUnsigned(one, a.low >> low, a.high >> low, width);
  if (width == 1 && low == of_width - 1) return OfBit(a.least >= 0, a.greatest < 0);
  return one;
}

}  // namespace

Interval Intervals::OfBranch(TermId condition, bool value, TermId branch) {
  if (depth_ == kMostBranches || !SaysBounds(terms_, condition)) return Of(branch);
  const size_t mark = before_.size();
  const bool contradicted = contradicts_;
  // What is found here holds in the branch only.
  std::unordered_map<uint32_t, Interval> outside = std::exchange(known_, {});
  ++depth_;
  Assume(condition, value);
  known_.clear();
  const Interval one = Of(branch);
  --depth_;
  for (; before_.size() > mark; before_.pop_back()) assumed_[before_.back().first] = before_.back().second;
  known_ = std::move(outside);
  contradicts_ = contradicted;  // a branch that is never taken says nothing of the others
  return one;
}

Interval Intervals::OfChoice(const Term& term) {
  const TermId condition(term.a), then(term.b), otherwise(term.c);
  const Interval chosen = Of(condition);
  if (chosen.low == chosen.high) return OfBranch(condition, chosen.low != 0, chosen.low != 0 ? then : otherwise);
  // The number without its sign.
  const Term negated = terms_[then];
  if (negated.kind == TermKind::kSub && terms_.IsZero(TermId(negated.a)) && TermId(negated.b) == otherwise &&
      condition == terms_.Extract(otherwise, static_cast<uint8_t>(term.width - 1), 1)) {
    const Interval number = Of(otherwise);
    return Without(
        0, std::max(static_cast<uint64_t>(-number.least), static_cast<uint64_t>(std::max<int64_t>(0, number.greatest))),
        term.width);
  }
  return Joined(OfBranch(condition, true, then), OfBranch(condition, false, otherwise));
}

Interval Intervals::Compute(TermId id) {
  const Term term = terms_[id];
  if (term.width > kWidest || ++steps_ > kMostComputed) return AnyOf(term.width);
  switch (term.kind) {
    case TermKind::kConst:
      return Without(terms_.Value(id), terms_.Value(id), term.width);
    case TermKind::kVariable:
    case TermKind::kApply:
      return AnyOf(term.width);
    case TermKind::kNot: {
      const Interval a = Of(TermId(term.a));
      return {.low = support::LowBits(term.width) - a.high,
              .high = support::LowBits(term.width) - a.low,
              .least = -1 - a.greatest,
              .greatest = -1 - a.least};
    }
    case TermKind::kIte:
      return OfChoice(term);
    case TermKind::kConcat: {
      Interval one = AnyOf(term.width);
      if (const TermId number = SignExtended(terms_, id); number.valid()) {
        const Interval bounds = Of(number);
        one.least = bounds.least;
        one.greatest = bounds.greatest;
        return one;
      }
      const uint8_t width = terms_.Width(TermId(term.b));
      const Interval high = Of(TermId(term.a)), low = Of(TermId(term.b));
      one.low = high.low << width | low.low;
      one.high = high.high << width | low.high;
      return one;
    }
    case TermKind::kExtract: {
      const TermId of(term.a);
      if (terms_.Width(of) > kWidest) return AnyOf(term.width);
      return OfPart(Of(of), static_cast<uint8_t>(term.b), terms_.Width(of), term.width);
    }
    case TermKind::kAnd:
    case TermKind::kOr:
    case TermKind::kXor:
    case TermKind::kAdd:
    case TermKind::kSub:
    case TermKind::kMul:
    case TermKind::kUdiv:
    case TermKind::kUrem:
    case TermKind::kSdiv:
    case TermKind::kSrem:
    case TermKind::kShl:
    case TermKind::kLshr:
    case TermKind::kAshr:
    case TermKind::kEq:
    case TermKind::kUlt:
    case TermKind::kSlt: {
      if (terms_.Width(TermId(term.a)) > kWidest) return AnyOf(term.width);
      const Interval a = Of(TermId(term.a));
      return IntervalOfBinary(term.kind, a, Of(TermId(term.b)), term.width);
    }
  }
  return AnyOf(term.width);
}

Interval Intervals::Of(TermId id) {
  if (const auto known = known_.find(id.index); known != known_.end()) return known->second;
  const uint8_t width = terms_.Width(id);
  Interval one = Fitted(Compute(id), width);
  if (const auto assumed = assumed_.find(id.index); assumed != assumed_.end()) {
    const Interval both = Fitted(Common(one, assumed->second), width);
    if (IsEmpty(both)) {
      contradicts_ = true;
    } else {
      one = both;
    }
  }
  known_.insert_or_assign(id.index, one);
  return one;
}

void Intervals::Restrict(TermId id, const Interval& bounds) {
  const auto [at, is_new] = assumed_.try_emplace(id.index, AnyOf(terms_.Width(id)));
  const Interval old = at->second;
  const Interval now = Common(old, bounds);
  if (now == old) return;
  before_.emplace_back(id.index, old);
  at->second = now;
}

bool Intervals::Assume(TermId condition, bool value) {
  if (++steps_ > kMostComputed) return !contradicts_;
  const Term term = terms_[condition];
  const TermId a(term.a), b(term.b);
  const Interval here = Of(condition);
  if (here.low == here.high && (here.low != 0) != value) contradicts_ = true;
  switch (term.kind) {
    case TermKind::kNot:
      return Assume(a, !value);
    case TermKind::kAnd:
    case TermKind::kOr:
      if (term.width == 1 && value == (term.kind == TermKind::kAnd)) {
        Assume(a, value);
        Assume(b, value);
      }
      break;
    case TermKind::kUlt: {
      if (terms_.Width(a) > kWidest) break;
      const Interval one = Of(a), other = Of(b);
      Interval of_a = AnyOf(terms_.Width(a)), of_b = of_a;
      if (value) {  // a < b
        of_a.high = other.high == 0 ? 0 : other.high - 1;
        of_b.low = one.low + (one.low < of_b.high ? 1 : 0);
      } else {
        of_a.low = other.low;
        of_b.high = one.high;
      }
      Restrict(a, of_a);
      Restrict(b, of_b);
      break;
    }
    case TermKind::kSlt: {
      if (terms_.Width(a) > kWidest) break;
      const Interval one = Of(a), other = Of(b);
      Interval of_a = AnyOf(terms_.Width(a)), of_b = of_a;
      if (value) {
        of_a.greatest = std::max(of_a.least, other.greatest - 1);
        of_b.least = std::min(of_b.greatest, one.least + 1);
      } else {
        of_a.least = other.least;
        of_b.greatest = one.greatest;
      }
      Restrict(a, of_a);
      Restrict(b, of_b);
      break;
    }
    case TermKind::kEq:
      if (value && terms_.Width(a) <= kWidest) {
        const Interval one = Of(a), other = Of(b);
        Restrict(a, other);
        Restrict(b, one);
      }
      break;
    case TermKind::kExtract:
      if (term.width == 1 && term.b == terms_.Width(a) - 1U && terms_.Width(a) <= kWidest) {
        Interval of_a = AnyOf(terms_.Width(a));
        if (value) {
          of_a.greatest = -1;
        } else {
          of_a.least = 0;
        }
        Restrict(a, of_a);
      }
      break;
    case TermKind::kConst:
    case TermKind::kVariable:
    case TermKind::kXor:
    case TermKind::kAdd:
    case TermKind::kSub:
    case TermKind::kMul:
    case TermKind::kUdiv:
    case TermKind::kUrem:
    case TermKind::kSdiv:
    case TermKind::kSrem:
    case TermKind::kShl:
    case TermKind::kLshr:
    case TermKind::kAshr:
    case TermKind::kIte:
    case TermKind::kConcat:
    case TermKind::kApply:
      break;
  }
  if (depth_ == 0) known_.clear();
  return !contradicts_;
}

namespace {

/// All of `parts` at once.
bool NeverTogether(Terms& terms, std::vector<TermId> parts, int alternatives) {
  for (size_t i = 0; i < parts.size() && parts.size() < kMostConjuncts;) {
    const Term term = terms[parts[i]];
    if (term.kind != TermKind::kAnd) {
      ++i;
      continue;
    }
    parts[i] = TermId(term.a);
    parts.emplace_back(term.b);
  }
  Intervals intervals(terms);
  for (int round = 0; round < kRounds; ++round) {
    for (const TermId part : parts) {
      if (!intervals.Assume(part, true)) return true;
    }
  }
  for (size_t i = 0; i < parts.size() && alternatives > 0; ++i) {
    const Term term = terms[parts[i]];
    const Term negated = term.kind == TermKind::kNot ? terms[TermId(term.a)] : Term();
    if (term.kind != TermKind::kOr && negated.kind != TermKind::kAnd) continue;
    const std::array one_of = term.kind == TermKind::kOr
                                  ? std::array{TermId(term.a), TermId(term.b)}
                                  : std::array{terms.Not(TermId(negated.a)), terms.Not(TermId(negated.b))};
    return std::ranges::all_of(one_of, [&](TermId one) {
      parts[i] = one;
      return NeverTogether(terms, parts, alternatives - 1);
    });
  }
  return false;
}

}  // namespace

bool NeverHolds(Terms& terms, TermId condition) { return NeverTogether(terms, {condition}, kMostAlternatives); }

}  // namespace plcxx::terms
