#include "transpiler/symbolic/terms/known_bits.h"

#include <algorithm>
#include <bit>

#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::terms {
namespace {

constexpr KnownBits kFalse{.zeros = 1}, kTrue{.ones = 1};

KnownBits InBoth(KnownBits a, KnownBits b) { return {.zeros = a.zeros & b.zeros, .ones = a.ones & b.ones}; }

KnownBits OfEq(KnownBits a, KnownBits b, uint8_t width) {
  if (((a.ones & b.zeros) | (a.zeros & b.ones)) != 0) return kFalse;
  return IsKnown(a, width) && IsKnown(b, width) ? kTrue : KnownBits{};
}

KnownBits OfUlt(KnownBits a, KnownBits b, uint8_t width) {
  if (Masked(~a.zeros, width) < b.ones) return kTrue;
  return a.ones >= Masked(~b.zeros, width) ? kFalse : KnownBits{};
}

/// Sums and differences: a digit follows from those below.
KnownBits LowDigits(TermKind kind, KnownBits a, KnownBits b, uint8_t width) {
  const int known = std::countr_one((a.zeros | a.ones) & (b.zeros | b.ones));
  const auto digits = static_cast<uint8_t>(std::min<int>(known, width));
  if (digits == 0) return {};
  return AllKnown(Masked(EvaluateBinary(kind, a.ones, b.ones, width), digits), digits);
}

KnownBits OfShift(TermKind kind, KnownBits a, KnownBits by, uint8_t width) {
  if (!IsKnown(by, width)) return {};
  const uint64_t all = Masked(~uint64_t{0}, width);
  if (by.ones >= width) return AllKnown(0, width);
  const auto moved = [&](uint64_t bits) { return kind == TermKind::kShl ? bits << by.ones : bits >> by.ones; };
  return {.zeros = (moved(a.zeros) | ~moved(all)) & all, .ones = moved(a.ones) & all};
}

}  // namespace

KnownBits KnownBitsOf(const Terms& terms, const Term& term, const std::function<KnownBits(TermId)>& of,
                      const std::function<KnownBits(uint32_t)>& of_variable) {
  const auto a = [&] { return of(TermId(term.a)); };
  const auto b = [&] { return of(TermId(term.b)); };
  const auto width = [&] { return terms.Width(TermId(term.a)); };
  switch (term.kind) {
    case TermKind::kConst:
      return AllKnown((uint64_t{term.b} << 32) | term.a, term.width);
    case TermKind::kVariable:
      return of_variable(term.a);
    case TermKind::kNot:
      return {.zeros = a().ones, .ones = a().zeros};
    case TermKind::kAnd:
      return {.zeros = a().zeros | b().zeros, .ones = a().ones & b().ones};
    case TermKind::kOr:
      return {.zeros = a().zeros & b().zeros, .ones = a().ones | b().ones};
    case TermKind::kXor: {
      const KnownBits one = a(), other = b();
      return {.zeros = (one.zeros & other.zeros) | (one.ones & other.ones),
              .ones = (one.zeros & other.ones) | (one.ones & other.zeros)};
    }
    case TermKind::kAdd:
    case TermKind::kSub:
      return LowDigits(term.kind, a(), b(), term.width);
    case TermKind::kShl:
    case TermKind::kLshr:
      return OfShift(term.kind, a(), b(), term.width);
    case TermKind::kEq:
      return OfEq(a(), b(), width());
    case TermKind::kUlt:
      return OfUlt(a(), b(), width());
    case TermKind::kIte:
      return a() == kTrue ? b() : a() == kFalse ? of(TermId(term.c)) : InBoth(b(), of(TermId(term.c)));
    case TermKind::kConcat: {
      const uint8_t low = terms.Width(TermId(term.b));
      return {.zeros = a().zeros << low | b().zeros, .ones = a().ones << low | b().ones};
    }
    case TermKind::kExtract:
      return {.zeros = Masked(a().zeros >> term.b, term.width), .ones = Masked(a().ones >> term.b, term.width)};
    case TermKind::kApply:
      return {};
    case TermKind::kMul:
    case TermKind::kUdiv:
    case TermKind::kUrem:
    case TermKind::kSdiv:
    case TermKind::kSrem:
    case TermKind::kAshr:
    case TermKind::kSlt:
      break;
  }
  if (!IsKnown(a(), width()) || !IsKnown(b(), terms.Width(TermId(term.b)))) return {};
  return AllKnown(EvaluateBinary(term.kind, a().ones, b().ones, width()), term.width);
}

}  // namespace plcxx::terms
