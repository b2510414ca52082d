#include "transpiler/symbolic/terms/justify.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <map>

namespace plcxx::terms {
namespace {

constexpr uint32_t kMostCost = 1'000'000'000;

uint32_t Sum(uint32_t a, uint32_t b) { return std::min(a + b, kMostCost); }

/// The lowest bits up to the highest one of `bits`: on which a sum depends.
uint64_t UpTo(uint64_t bits) { return bits == 0 ? 0 : ~uint64_t{0} >> std::countl_zero(bits); }

uint64_t All(uint8_t width) { return Masked(~uint64_t{0}, width); }

}  // namespace

Justification::Justification(const Terms& terms, std::span<const TermId> cone, const std::vector<uint64_t>& values)
    : Justification(terms, cone, values, {}, {}) {}

Justification::Justification(const Terms& terms, std::span<const TermId> cone, const std::vector<uint64_t>& values,
                             std::span<const TermId> definitions,
                             std::function<UnknownFunction(const TermFunction&)> unknown)
    : terms_(terms), values_(values), definitions_(definitions), unknown_(std::move(unknown)), costs_(terms.size()) {
  for (const TermId id : cone) costs_[id.index] = CostOf(terms[id], values[id.index]);
}

uint32_t Justification::CostOf(const Term& term, uint64_t value) const {
  switch (term.kind) {
    case TermKind::kConst:
      return 0;
    case TermKind::kVariable: {
      const bool is_defined = term.a < definitions_.size() && definitions_[term.a].valid();
      return is_defined ? costs_[definitions_[term.a].index] : 1;
    }
    case TermKind::kAnd:
    case TermKind::kOr: {
      // Of words the sum is what may be needed.
      const bool decided_by_one = term.width == 1 && (value != 0) == (term.kind == TermKind::kOr);
      const uint32_t a = costs_[term.a], b = costs_[term.b];
      if (!decided_by_one) return Sum(a, b);
      if (Value(term.a) != value) return b;
      return Value(term.b) != value ? a : std::min(a, b);
    }
    case TermKind::kIte:
      return Sum(costs_[term.a], costs_[Value(term.a) != 0 ? term.b : term.c]);
    case TermKind::kNot:
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
    case TermKind::kSlt:
    case TermKind::kConcat:
    case TermKind::kExtract:
    case TermKind::kApply:
      break;
  }
  uint32_t sum = term.kind == TermKind::kApply ? 1 : 0;
  if (IsUnknown(term) && UnknownOf(term) != UnknownFunction::kWithArguments) {
    return UnknownOf(term) == UnknownFunction::kAvoided ? kMostCost : 1;
  }
  terms_.ForEachOperand(term, [&](TermId operand) { sum = Sum(sum, costs_[operand.index]); });
  return sum;
}

template <class Need>
void Justification::Operands(const Term& term, uint64_t bits, Need&& need) const {
  const uint64_t a = Value(term.kind == TermKind::kConst || term.kind == TermKind::kVariable ? 0 : term.a);
  switch (term.kind) {
    case TermKind::kConst:
    case TermKind::kVariable:
      return;
    case TermKind::kNot:
      need(term.a, bits);
      return;
    case TermKind::kXor:
      need(term.a, bits);
      need(term.b, bits);
      return;
    case TermKind::kAnd:
    case TermKind::kOr: {
      // Bit by bit: where the operands' values decide alone, the cheaper of those that do.
      const uint64_t b = Value(term.b);
      const uint64_t deciding_a = bits & (term.kind == TermKind::kAnd ? ~a : a);
      const uint64_t deciding_b = bits & (term.kind == TermKind::kAnd ? ~b : b);
      const uint64_t both = bits & ~deciding_a & ~deciding_b;
      const bool prefers_a = costs_[term.a] <= costs_[term.b];
      need(term.a, both | (prefers_a ? deciding_a : deciding_a & ~deciding_b));
      need(term.b, both | (prefers_a ? deciding_b & ~deciding_a : deciding_b));
      return;
    }
    case TermKind::kAdd:
    case TermKind::kSub:
    case TermKind::kMul:
      need(term.a, UpTo(bits));
      need(term.b, UpTo(bits));
      return;
    case TermKind::kIte:
      need(term.a, 1);
      need(a != 0 ? term.b : term.c, bits);
      return;
    case TermKind::kConcat: {
      const uint8_t low = terms_.Width(TermId(term.b));
      need(term.a, bits >> low);
      need(term.b, bits & All(low));
      return;
    }
    case TermKind::kExtract:
      need(term.a, bits << term.b);
      return;
    case TermKind::kEq: {
      const uint64_t differing = a ^ Value(term.b);
      const uint64_t enough = differing == 0 ? All(terms_.Width(TermId(term.a))) : differing & (~differing + 1);
      need(term.a, enough);
      need(term.b, enough);
      return;
    }
    case TermKind::kUlt:
    case TermKind::kSlt: {
      // From the top down to where they differ first; the sign of kSlt is the top one, too.
      const uint64_t all = All(terms_.Width(TermId(term.a))), differing = a ^ Value(term.b);
      const uint64_t enough = differing == 0 ? all : all & ~(UpTo(differing) >> 1);
      need(term.a, enough);
      need(term.b, enough);
      return;
    }
    case TermKind::kUdiv:
    case TermKind::kUrem:
    case TermKind::kSdiv:
    case TermKind::kSrem:
    case TermKind::kShl:
    case TermKind::kLshr:
    case TermKind::kAshr:
    case TermKind::kApply:
      terms_.ForEachOperand(term, [&](TermId operand) { need(operand.index, All(terms_.Width(operand))); });
      return;
  }
}

std::vector<Reason> Justification::ReasonsFor(TermId term) const {
  const Reason wanted{.term = term, .bits = All(terms_.Width(term))};
  return ReasonsFor({&wanted, 1});
}

std::vector<Reason> Justification::ReasonsFor(std::span<const Reason> wanted) const {
  std::vector<Reason> reasons;
  std::map<uint32_t, uint64_t, std::greater<>> needed;
  for (const Reason& one : wanted) needed[one.term.index] |= one.bits;
  while (!needed.empty()) {
    // Operands are older than what is made of them: nothing that comes later needs more of this one.
    const auto [index, bits] = *needed.begin();
    needed.erase(needed.begin());
    const Term& what = terms_[TermId(index)];
    const bool unknown = IsUnknown(what);
    if (what.kind == TermKind::kVariable || unknown) reasons.push_back({TermId(index), bits});
    if (unknown && UnknownOf(what) != UnknownFunction::kWithArguments) continue;
    Operands(what, bits, [&needed](uint32_t operand, uint64_t part) {
      if (part != 0) needed[operand] |= part;
    });
  }
  return reasons;
}

}  // namespace plcxx::terms
