#include "transpiler/symbolic/terms/aimed_values.h"

namespace plcxx::terms {
namespace {

constexpr size_t kMostAims = 5000;

}  // namespace

void AimedValues::AimAt(TermId term, uint64_t value) {
  variables_.clear();
  open_.clear();
  Add(term.index, ~uint64_t{0}, value);
  for (size_t steps = 0; !open_.empty() && steps < kMostAims; ++steps) {
    const Aim next = open_.back();
    open_.pop_back();
    Meet(next);
  }
}

uint64_t AimedValues::Of(TermId variable, uint64_t otherwise) const {
  const auto at = variables_.find(variable.index);
  return at == variables_.end() ? otherwise : (otherwise & ~at->second.mask) | at->second.bits;
}

void AimedValues::Add(uint32_t term, uint64_t mask, uint64_t bits) {
  mask = Masked(mask, terms_.Width(TermId(term)));
  if (mask != 0) open_.push_back({TermId(term), mask, bits & mask});
}

void AimedValues::Fix(TermId variable, const Aim& aim) {
  Aim& known = variables_.emplace(variable.index, Aim{variable}).first->second;
  const uint64_t fresh = aim.mask & ~known.mask;
  known.mask |= fresh;
  known.bits |= aim.bits & fresh;
}

/// Looks only at the term itself and, of a variable, at what is fixed.
bool AimedValues::MayBe(TermId term, const Aim& aim) const {
  if (terms_.IsConst(term)) return ((terms_.Value(term) ^ aim.bits) & aim.mask) == 0;
  const auto at = variables_.find(term.index);
  return at == variables_.end() || ((at->second.bits ^ aim.bits) & aim.mask & at->second.mask) == 0;
}

void AimedValues::MeetAndOr(const Term& term, const Aim& aim) {
  // 1 of a conjunction and 0 of a disjunction need both; the other value one of them, bit by bit.
  const bool is_and = term.kind == TermKind::kAnd;
  const uint64_t both = aim.mask & (is_and ? aim.bits : ~aim.bits), one = aim.mask & ~both;
  const uint64_t of_one = is_and ? 0 : one;
  const bool a_may = MayBe(TermId(term.a), {{}, one, of_one}), b_may = MayBe(TermId(term.b), {{}, one, of_one});
  const bool takes_a = a_may && (!b_may || random_.OneIn(2));
  Add(term.a, both | (takes_a ? one : 0), (aim.bits & both) | of_one);
  Add(term.b, both | (takes_a ? 0 : one), (aim.bits & both) | of_one);
}

void AimedValues::MeetUnequal(TermId a, TermId b) {
  const bool is_const = terms_.IsConst(b);
  const TermId changed = is_const ? a : b;
  const uint64_t other = is_const ? terms_.Value(b) : terms_.IsConst(a) ? terms_.Value(a) : random_.Next();
  if (terms_.Width(a) == 1) {
    Add(changed.index, 1, ~other);
    if (!is_const && !terms_.IsConst(a)) Add(a.index, 1, other);
    return;
  }
  Add(changed.index, ~uint64_t{0}, other + 1 + random_.Next() % 3);
  if (!is_const && !terms_.IsConst(a)) Add(a.index, ~uint64_t{0}, other);
}

void AimedValues::MeetComparison(const Term& term, bool holds) {
  const TermId a(term.a), b(term.b);
  const uint8_t width = terms_.Width(a);
  if (term.kind == TermKind::kEq) {
    if (!holds) {
      MeetUnequal(a, b);
      return;
    }
    const uint64_t value = terms_.IsConst(b)   ? terms_.Value(b)
                           : terms_.IsConst(a) ? terms_.Value(a)
                                               : random_.Next() % 4;
    Add(a.index, ~uint64_t{0}, value);
    Add(b.index, ~uint64_t{0}, value);
    return;
  }
  // Near the border, or at the end of what the width has.
  const bool is_signed = term.kind == TermKind::kSlt;
  const uint64_t sign = uint64_t{1} << (width - 1);
  const uint64_t least = is_signed ? sign : 0, most = is_signed ? sign - 1 : ~uint64_t{0};
  const bool is_far = random_.OneIn(2);
  const uint64_t step = random_.Next() % 2;
  if (terms_.IsConst(b)) {
    const uint64_t border = terms_.Value(b);
    Add(a.index, ~uint64_t{0}, holds ? (is_far ? least : border - 1 - step) : (is_far ? most : border + step));
  } else if (terms_.IsConst(a)) {
    const uint64_t border = terms_.Value(a);
    Add(b.index, ~uint64_t{0}, holds ? (is_far ? most : border + 1 + step) : (is_far ? least : border - step));
  } else {
    const uint64_t middle = random_.Next() % 8 + 1;
    Add(a.index, ~uint64_t{0}, middle);
    Add(b.index, ~uint64_t{0}, holds ? middle + 1 + step : middle - step);
  }
}

void AimedValues::Meet(const Aim& aim) {
  const Term& term = terms_[aim.term];
  switch (term.kind) {
    case TermKind::kConst:
      return;
    case TermKind::kVariable:
      Fix(aim.term, aim);
      return;
    case TermKind::kNot:
      Add(term.a, aim.mask, ~aim.bits);
      return;
    case TermKind::kAnd:
    case TermKind::kOr:
      MeetAndOr(term, aim);
      return;
    case TermKind::kXor: {
      const uint64_t of_a = terms_.IsConst(TermId(term.a))   ? terms_.Value(TermId(term.a))
                            : terms_.IsConst(TermId(term.b)) ? aim.bits ^ terms_.Value(TermId(term.b))
                                                             : random_.Next();
      Add(term.a, aim.mask, of_a);
      Add(term.b, aim.mask, aim.bits ^ of_a);
      return;
    }
    case TermKind::kAdd:
    case TermKind::kSub: {
      const bool is_sum = term.kind == TermKind::kAdd;
      const TermId a(term.a), b(term.b);
      if (terms_.IsConst(a)) {
        Add(term.b, ~uint64_t{0}, is_sum ? aim.bits - terms_.Value(a) : terms_.Value(a) - aim.bits);
        return;
      }
      const uint64_t of_b = terms_.IsConst(b) ? terms_.Value(b) : random_.Next() % 4;
      Add(term.b, ~uint64_t{0}, of_b);
      Add(term.a, ~uint64_t{0}, is_sum ? aim.bits - of_b : aim.bits + of_b);
      return;
    }
    case TermKind::kEq:
    case TermKind::kUlt:
    case TermKind::kSlt:
      MeetComparison(term, aim.bits != 0);
      return;
    case TermKind::kIte: {
      const bool then_may = MayBe(TermId(term.b), aim), else_may = MayBe(TermId(term.c), aim);
      const bool takes_then = MayBe(TermId(term.a), {{}, 1, 1}) && then_may && (!else_may || random_.OneIn(2));
      Add(takes_then ? term.b : term.c, aim.mask, aim.bits);
      Add(term.a, 1, takes_then ? 1 : 0);
      return;
    }
    case TermKind::kConcat: {
      const uint8_t low = terms_.Width(TermId(term.b));
      Add(term.a, aim.mask >> low, aim.bits >> low);
      Add(term.b, aim.mask, aim.bits);
      return;
    }
    case TermKind::kExtract:
      Add(term.a, aim.mask << term.b, aim.bits << term.b);
      return;
    case TermKind::kMul:
    case TermKind::kUdiv:
    case TermKind::kUrem:
    case TermKind::kSdiv:
    case TermKind::kSrem:
    case TermKind::kShl:
    case TermKind::kLshr:
    case TermKind::kAshr:
    case TermKind::kApply:
      return;  // nothing is known that is as simple
  }
}

}  // namespace plcxx::terms
