#include "transpiler/prove/verify/llvm_ir/value_range.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "transpiler/support/low_bits.h"

namespace plcxx::prove::verify::llvm_ir {
namespace {

using support::LowBits;

ValueRange All(uint8_t width, uint64_t step = 1) {
  const uint64_t ones = LowBits(width);
  return {0, step > ones ? 0 : ones / step * step, step > ones ? 0 : step};
}

bool AddFits(uint64_t a, uint64_t b, uint8_t width) { return b <= LowBits(width) && a <= LowBits(width) - b; }
bool MulFits(uint64_t a, uint64_t b, uint8_t width) { return a == 0 || b <= LowBits(width) / a; }

/// The greatest power of two that divides all values.
uint64_t PowerIn(ValueRange range) {
  const uint64_t bits = range.low | range.step;
  return bits == 0 ? uint64_t{1} << 63 : uint64_t{1} << std::countr_zero(bits);
}

}  // namespace

ValueRange ValueRanges::Of(terms::TermId id) {
  const auto found = known_.find(id.index);
  if (found != known_.end()) return found->second;
  ValueRange range = Compute(terms_[id]);
  if (range.low == range.high) range.step = 0;
  known_.emplace(id.index, range);
  return range;
}

ValueRange ValueRanges::OfProduct(const terms::Term& term, ValueRange a, ValueRange b) const {
  if (b.step != 0) std::swap(a, b);
  if (b.step == 0 && MulFits(a.high, b.low, term.width)) return {a.low * b.low, a.high * b.low, a.step * b.low};
  // It may wrap: powers of two stay, because they divide the modulus.
  const uint64_t pa = PowerIn(a), pb = PowerIn(b);
  return All(term.width, std::countl_zero(pa) <= 63 - std::countl_zero(pb) ? 1 : pa * pb);
}

ValueRange ValueRanges::OfMask(const terms::Term& term, ValueRange a, ValueRange b) const {
  if (b.step != 0) std::swap(a, b);
  if (b.step != 0) return {0, std::min(a.high, b.high), 1};
  const uint64_t mask = b.low;
  if (mask == 0) return {};
  const uint64_t low_zeros = uint64_t{1} << std::countr_zero(mask);
  // A mask that keeps all that there is.
  const auto bits = static_cast<uint8_t>(std::bit_width(a.high));
  const uint64_t below = PowerIn(a);
  if (((mask | (below - 1)) & LowBits(bits)) == LowBits(bits)) return a;
  const uint64_t step = std::max(low_zeros, below);
  return {0, std::min(mask, a.high) / step * step, step > LowBits(term.width) ? 0 : step};
}

ValueRange ValueRanges::Compute(const terms::Term& term) {
  const auto a = [&] { return Of(terms::TermId(term.a)); };
  const auto b = [&] { return Of(terms::TermId(term.b)); };
  switch (term.kind) {
    case terms::TermKind::kConst: {
      const uint64_t value = (uint64_t{term.b} << 32) | term.a;
      return {value, value, 0};
    }
    case terms::TermKind::kAdd: {
      const ValueRange x = a(), y = b();
      if (AddFits(x.high, y.high, term.width)) return {x.low + y.low, x.high + y.high, std::gcd(x.step, y.step)};
      // Minus a constant, of what is never less.
      for (const auto& [one, other] : {std::pair(x, y), std::pair(y, x)}) {
        const uint64_t minus = terms::Masked(~other.low + 1, term.width);
        if (other.step == 0 && one.low >= minus) return {one.low - minus, one.high - minus, one.step};
      }
      return All(term.width, std::min(PowerIn(x), PowerIn(y)));
    }
    case terms::TermKind::kMul:
      return OfProduct(term, a(), b());
    case terms::TermKind::kShl: {
      const ValueRange by = b();
      if (by.step == 0 && by.low < 64) return OfProduct(term, a(), {uint64_t{1} << by.low, uint64_t{1} << by.low, 0});
      return All(term.width);
    }
    case terms::TermKind::kLshr: {
      const ValueRange x = a(), by = b();
      return by.step == 0 && by.low < 64 ? ValueRange{x.low >> by.low, x.high >> by.low, 1} : ValueRange{0, x.high, 1};
    }
    case terms::TermKind::kAnd:
      return OfMask(term, a(), b());
    case terms::TermKind::kUdiv: {
      const ValueRange by = b();
      return by.low != 0 ? ValueRange{0, a().high / by.low, 1} : All(term.width);
    }
    case terms::TermKind::kUrem: {
      const ValueRange by = b();
      return by.low != 0 ? ValueRange{0, std::min(a().high, by.high - 1), 1} : All(term.width);
    }
    case terms::TermKind::kIte: {
      const ValueRange x = b(), y = Of(terms::TermId(term.c));
      const uint64_t apart = x.low > y.low ? x.low - y.low : y.low - x.low;
      const uint64_t step = std::gcd(std::gcd(x.step, y.step), apart);
      return {std::min(x.low, y.low), std::max(x.high, y.high), step};
    }
    case terms::TermKind::kConcat: {
      const ValueRange high = a(), low = b();
      const uint8_t by = terms_.Width(terms::TermId(term.b));
      if (high.step == 0 && high.low == 0) return low;
      return {(high.low << by) + low.low, (high.high << by) + low.high, std::gcd(high.step << by, low.step)};
    }
    case terms::TermKind::kExtract: {
      const ValueRange x = a();
      if (term.b == 0 && x.high <= LowBits(term.width)) return x;
      return term.b == 0 ? All(term.width, std::min(PowerIn(x), LowBits(term.width))) : All(term.width);
    }
    case terms::TermKind::kVariable:
    case terms::TermKind::kNot:
    case terms::TermKind::kOr:
    case terms::TermKind::kXor:
    case terms::TermKind::kSub:
    case terms::TermKind::kSdiv:
    case terms::TermKind::kSrem:
    case terms::TermKind::kAshr:
    case terms::TermKind::kEq:
    case terms::TermKind::kUlt:
    case terms::TermKind::kSlt:
    case terms::TermKind::kApply:
      break;
  }
  return All(term.width);
}

}  // namespace plcxx::prove::verify::llvm_ir
