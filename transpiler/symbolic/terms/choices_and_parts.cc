// Comparisons, choices, and parts of terms: what memory, bits in words and joins of branches are made of.
#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <utility>

#include "transpiler/symbolic/terms/division.h"
#include "transpiler/symbolic/terms/magnitude.h"
#include "transpiler/symbolic/terms/sign_extended.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {
namespace {

/// As operands of a term that is to be rebuilt: none that is there, so that it is made anew, by the rules of its kind.
constexpr uint32_t kNoOperand = 0xFFFFFFFF;

}  // namespace

TermId Terms::EqOfConst(TermId a, TermId constant) {
  const Term term = terms_[a.index];
  const uint64_t value = Value(constant);
  if (term.width == 1) return value == 1 ? a : Not(a);
  switch (term.kind) {
    case TermKind::kNot:
      return Eq(TermId(term.a), Const(~value, term.width));
    case TermKind::kConcat: {
      // A table that is read by an index of single bits asks this for each element, in each execution: the answers are
      // kept beside those of Extract, whose questions are of another kind.
      const Term question{TermKind::kEq, 1, a.index, constant.index};
      if (const uint32_t known = extract_index_.Find(extract_questions_, question); known != Index::kNowhere)
        return extracts_[known];
      const TermId rest(term.b);
      const uint8_t low = Width(rest);
      // The sign above a number: if it is that of the constant's part, that part says all.
      const Term above = terms_[term.a];
      TermId answer;
      if (above.kind == TermKind::kIte && TermId(above.a) == Extract(rest, static_cast<uint8_t>(low - 1), 1) &&
          IsConst(TermId(above.b)) && IsConst(TermId(above.c))) {
        const TermId sign(value >> (low - 1) & 1 ? above.b : above.c);
        answer = Value(sign) == value >> low ? Eq(rest, Const(value, low)) : zero_;
      } else {
        answer = And(Eq(TermId(term.a), Const(value >> low, Width(TermId(term.a)))), Eq(rest, Const(value, low)));
      }
      // What was asked meanwhile is of parts, never of the row itself.
      extract_index_.FindOrAdd(extract_questions_, question);
      extract_questions_.push_back(question);
      extracts_.push_back(answer);
      return answer;
    }
    case TermKind::kIte:
      // A choice between constants is a question about its condition.
      if (IsConst(TermId(term.b)) && IsConst(TermId(term.c))) {
        return Ite(TermId(term.a), Bit(Value(TermId(term.b)) == value), Bit(Value(TermId(term.c)) == value));
      }
      break;
    case TermKind::kAdd:
      if (IsConst(TermId(term.a))) return Eq(TermId(term.b), Const(value - Value(TermId(term.a)), term.width));
      if (IsConst(TermId(term.b))) return Eq(TermId(term.a), Const(value - Value(TermId(term.b)), term.width));
      break;
    case TermKind::kXor:
      if (IsConst(TermId(term.a))) return Eq(TermId(term.b), Const(value ^ Value(TermId(term.a)), term.width));
      if (IsConst(TermId(term.b))) return Eq(TermId(term.a), Const(value ^ Value(TermId(term.b)), term.width));
      break;
    case TermKind::kConst:
    case TermKind::kVariable:
    case TermKind::kAnd:
    case TermKind::kOr:
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
    case TermKind::kExtract:
    case TermKind::kApply:
      break;
  }
  return Binary(TermKind::kEq, a, constant, 1);
}

TermId Terms::Eq(TermId a, TermId b) {
  PLCXX_CHECK(Width(a) == Width(b));
  if (a == b) return one_;
  if (IsConst(a) && IsConst(b)) return zero_;
  if (IsConst(a)) return EqOfConst(b, a);
  if (IsConst(b)) return EqOfConst(a, b);
  if (Width(a) == 1) return Not(Xor(a, b));
  if (IsNotOf(a, b) || IsNotOf(b, a)) return zero_;
  const Term one = terms_[a.index], other = terms_[b.index];
  if (one.kind == TermKind::kConcat && other.kind == TermKind::kConcat &&
      Width(TermId(one.b)) == Width(TermId(other.b))) {
    return And(Eq(TermId(one.a), TermId(other.a)), Eq(TermId(one.b), TermId(other.b)));
  }
  // Two distances from one term.
  const auto without_constant = [this](TermId sum) -> std::pair<TermId, uint64_t> {
    const Term term = terms_[sum.index];
    if (term.kind != TermKind::kAdd) return {sum, 0};
    if (IsConst(TermId(term.a))) return {TermId(term.b), Value(TermId(term.a))};
    if (IsConst(TermId(term.b))) return {TermId(term.a), Value(TermId(term.b))};
    return {sum, 0};
  };
  const auto [of_a, more_a] = without_constant(a);
  const auto [of_b, more_b] = without_constant(b);
  if (of_a == of_b) return Bit(more_a == more_b);
  if (b < a) std::swap(a, b);
  return Binary(TermKind::kEq, a, b, 1);
}

TermId Terms::Ult(TermId a, TermId b) {
  if (a == b || IsZero(b)) return zero_;
  if (Width(a) == 1) return And(Not(a), b);
  if (IsZero(a)) return Ne(a, b);
  const uint64_t ones = Masked(~uint64_t{0}, Width(a));
  if (IsConst(a) && Value(a) == ones) return zero_;
  if (IsConst(b) && Value(b) == 1) return Eq(a, Const(0, Width(a)));
  // One spelling of a comparison with a constant: it stands on the right.
  if (IsConst(a)) return IsConst(b) ? Bit(Value(a) < Value(b)) : Not(Ult(b, Const(Value(a) + 1, Width(a))));
  // Zeros above both: compare what is below them.
  const Term one = terms_[a.index], other = terms_[b.index];
  if (one.kind == TermKind::kConcat && IsZero(TermId(one.a))) {
    const uint8_t low = Width(TermId(one.b));
    if (other.kind == TermKind::kConcat && IsZero(TermId(other.a)) && Width(TermId(other.b)) == low) {
      return Ult(TermId(one.b), TermId(other.b));
    }
    if (IsConst(b)) {
      return Value(b) > Masked(~uint64_t{0}, low) ? one_ : Ult(TermId(one.b), Const(Value(b), low));
    }
  }
  // The sign above a number leaves a gap between the numbers that are not negative and those that are.
  if (const TermId number = SignExtended(*this, a); number.valid() && IsConst(b)) {
    const uint8_t low = Width(number);
    const uint64_t half = uint64_t{1} << (low - 1);
    if (Value(b) <= half || Value(b) >= ones - half + 1) return Ult(number, Const(Value(b), low));
    return Not(Extract(number, static_cast<uint8_t>(low - 1), 1));
  }
  return Binary(TermKind::kUlt, a, b, 1);
}

TermId Terms::Slt(TermId a, TermId b) {
  if (a == b) return zero_;
  const uint8_t width = Width(a);
  if (width == 1) return And(a, Not(b));
  // Numbers that cannot be negative compare alike in both readings.
  const auto is_positive = [this, width](TermId id) {
    const Term term = terms_[id.index];
    if (term.kind == TermKind::kConst) return (Value(id) >> (width - 1)) == 0;
    return term.kind == TermKind::kConcat && IsZero(TermId(term.a));
  };
  if (is_positive(a) && is_positive(b)) return Ult(a, b);
  if (IsZero(b)) return Extract(a, static_cast<uint8_t>(width - 1), 1);
  if (IsConst(a) && IsConst(b)) return Bit(AsSigned(Value(a), width) < AsSigned(Value(b), width));
  const uint64_t greatest = Masked(~uint64_t{0}, width) >> 1;
  if (IsConst(a)) return Value(a) == greatest ? zero_ : Not(Slt(b, Const(Value(a) + 1, width)));
  if (IsConst(b) && Value(b) == greatest + 1) return zero_;
  if (const TermId number = SignExtended(*this, a); number.valid()) {
    const uint8_t low = Width(number);
    if (const TermId other = SignExtended(*this, b); other.valid() && Width(other) == low) return Slt(number, other);
    if (IsConst(b)) {
      const uint64_t shortened = Masked(Value(b), low);
      if (AsSigned(shortened, low) == AsSigned(Value(b), width)) return Slt(number, Const(shortened, low));
      return Bit(AsSigned(Value(b), width) > 0);
    }
  }
  return Binary(TermKind::kSlt, a, b, 1);
}

TermId Terms::Where(TermId term, TermId condition, bool value) {
  // What is known follows from what is asked: the first few parts of it, for a condition may be as long as the program.
  constexpr size_t kMostKnown = 8;
  std::array<std::pair<TermId, bool>, kMostKnown> known{std::pair(condition, value)};
  size_t count = 1;
  const auto is_known = [this](TermId id, TermId fact, bool holds) -> std::optional<bool> {
    if (id == fact) return holds;
    if (IsNotOf(id, fact)) return !holds;
    return std::nullopt;
  };
  // Of "and" and "or" the operand that is left, or the constant.
  const auto of_two = [&](TermId id, TermId fact, bool holds) {
    const Term found = terms_[id.index];
    if (found.width != 1 || (found.kind != TermKind::kAnd && found.kind != TermKind::kOr)) return id;
    for (const auto& [one, other] : {std::pair(found.a, found.b), std::pair(found.b, found.a)}) {
      const std::optional<bool> operand = is_known(TermId(one), fact, holds);
      if (operand) return *operand == (found.kind == TermKind::kAnd) ? TermId(other) : Bit(*operand);
    }
    return id;
  };
  for (size_t i = 0; i < count; ++i) {
    const auto [fact, holds] = known[i];
    if (const std::optional<bool> all = is_known(term, fact, holds)) return Bit(*all);
    const Term found = terms_[term.index];
    if (found.kind == TermKind::kIte) {
      const TermId choice = of_two(TermId(found.a), fact, holds);
      if (TermId(found.a) == fact) {
        term = TermId(holds ? found.b : found.c);
      } else if (choice.index != found.a) {
        term = Ite(choice, TermId(found.b), TermId(found.c));
      }
    } else {
      term = of_two(term, fact, holds);
    }
    const Term asked = terms_[fact.index];
    if (asked.kind == TermKind::kNot && count < kMostKnown) known[count++] = {TermId(asked.a), !holds};
    if (asked.kind != (holds ? TermKind::kAnd : TermKind::kOr)) continue;
    for (const uint32_t part : {asked.a, asked.b}) {
      if (count < kMostKnown) known[count++] = {TermId(part), holds};
    }
  }
  return term;
}

TermId Terms::OfChoice(TermKind kind, TermId a, TermId b) {
  constexpr int kMostChoices = 16;  // a table of constants is a longer row of them
  const bool first = IsConst(b);
  if (!first && !IsConst(a)) return {};
  const auto has_constant = [this](const Term& term) {
    return term.kind == TermKind::kIte && (IsConst(TermId(term.b)) || IsConst(TermId(term.c)));
  };
  const Term choice = terms_[(first ? a : b).index];
  if (!has_constant(choice)) return {};
  int choices = 0;
  for (Term next = choice; has_constant(next); next = terms_[IsConst(TermId(next.b)) ? next.c : next.b]) {
    if (++choices == kMostChoices) return {};
  }
  const auto of = [&](uint32_t branch) {
    const std::array operands = {first ? TermId(branch) : a, first ? b : TermId(branch)};
    return Rebuild({kind, choice.width, kNoOperand, kNoOperand}, operands);
  };
  return Ite(TermId(choice.a), of(choice.b), of(choice.c));
}

TermId Terms::OfSharedOperand(TermId condition, TermId then, TermId otherwise) {
  const Term one = terms_[then.index], other = terms_[otherwise.index];
  if (one.kind != other.kind) return {};
  if (one.kind == TermKind::kExtract) {
    if (one.b != other.b || terms_[one.a].width != terms_[other.a].width) return {};
    const TermId whole = OfSharedOperand(condition, TermId(one.a), TermId(other.a));
    return whole.valid() ? Extract(whole, static_cast<uint8_t>(one.b), one.width) : TermId();
  }
  const bool is_product = one.kind == TermKind::kMul;
  if (!is_product && !IsDivision(one.kind)) return {};
  const auto with = [&](uint32_t shared, uint32_t first, uint32_t second, bool is_left) -> TermId {
    // A factor that is known costs far less than one that is chosen.
    if (IsConst(TermId(first)) || IsConst(TermId(second))) return {};
    const TermId chosen = Ite(condition, TermId(first), TermId(second));
    const std::array operands = {is_left ? TermId(shared) : chosen, is_left ? chosen : TermId(shared)};
    return Rebuild({one.kind, one.width, kNoOperand, kNoOperand}, operands);
  };
  if (one.a == other.a) return with(one.a, one.b, other.b, true);
  if (one.b == other.b) return with(one.b, one.a, other.a, false);
  if (is_product && one.a == other.b) return with(one.a, one.b, other.a, true);
  if (is_product && one.b == other.a) return with(one.b, one.a, other.b, true);
  return {};
}

TermId Terms::Ite(TermId condition, TermId then, TermId otherwise) {
  PLCXX_CHECK(Width(condition) == 1 && Width(then) == Width(otherwise));
  if (IsTrue(condition) || then == otherwise) return then;
  if (IsFalse(condition)) return otherwise;
  if (terms_[condition.index].kind == TermKind::kNot) {
    return Ite(TermId(terms_[condition.index].a), otherwise, then);
  }
  // What a branch knows of its own condition.
  const TermId known_then = Where(then, condition, true), known_otherwise = Where(otherwise, condition, false);
  if (known_then != then || known_otherwise != otherwise) return Ite(condition, known_then, known_otherwise);
  // One condition after the other, as branches in branches ask them.
  if (const Term both = terms_[condition.index], rest = terms_[otherwise.index];
      both.kind == TermKind::kAnd && rest.kind == TermKind::kIte && (rest.a == both.a || rest.a == both.b)) {
    const TermId next(rest.a == both.a ? both.b : both.a);
    return Ite(TermId(rest.a), Ite(next, then, TermId(rest.b)), TermId(rest.c));
  }
  if (const Term one_of = terms_[condition.index], first = terms_[then.index];
      one_of.kind == TermKind::kOr && first.kind == TermKind::kIte && (first.a == one_of.a || first.a == one_of.b)) {
    const TermId next(first.a == one_of.a ? one_of.b : one_of.a);
    return Ite(TermId(first.a), TermId(first.b), Ite(next, TermId(first.c), otherwise));
  }
  // What the other side is anyway where this one is taken.
  if (IsWhere(otherwise, then, condition, true)) return otherwise;
  if (IsWhere(then, otherwise, condition, false)) return then;
  // The magnitude of a magnitude: where both x and -x are negative, they are one number.
  if (const Term inner = terms_[then.index];
      inner.kind == TermKind::kIte && IsSignOf(*this, condition, otherwise) && TermId(inner.b) == otherwise &&
      IsNegOf(*this, TermId(inner.c), otherwise) && IsSignOf(*this, TermId(inner.a), TermId(inner.c))) {
    return Ite(condition, TermId(inner.c), otherwise);
  }
  if (Width(then) == 1) {
    if (then == condition || IsTrue(then)) return Or(condition, otherwise);
    if (otherwise == condition || IsFalse(otherwise)) return And(condition, then);
    if (IsFalse(then)) return And(Not(condition), otherwise);
    if (IsTrue(otherwise)) return Or(Not(condition), then);
    if (IsNotOf(then, otherwise) || IsNotOf(otherwise, then)) return Xor(Not(condition), then);
  }
  // Parts that both sides share, as when one bit of a word is written.
  const Term one = terms_[then.index], other = terms_[otherwise.index];
  if (one.kind == TermKind::kConcat && other.kind == TermKind::kConcat &&
      Width(TermId(one.b)) == Width(TermId(other.b)) && (one.a == other.a || one.b == other.b)) {
    return Concat(Ite(condition, TermId(one.a), TermId(other.a)), Ite(condition, TermId(one.b), TermId(other.b)));
  }
  // A row of which one part is the constant's, as a bit below zeros or 0.
  for (const auto& [row, constant] : {std::pair(then, otherwise), std::pair(otherwise, then)}) {
    const Term term = terms_[row.index];
    if (!IsConst(constant) || term.kind != TermKind::kConcat) continue;
    const uint8_t low = Width(TermId(term.b));
    const TermId high_part = Const(Value(constant) >> low, static_cast<uint8_t>(term.width - low));
    const TermId low_part = Const(Value(constant), low);
    if (high_part.index != term.a && low_part.index != term.b) continue;
    const TermId high(term.a), rest(term.b);
    if (row == then) return Concat(Ite(condition, high, high_part), Ite(condition, rest, low_part));
    return Concat(Ite(condition, high_part, high), Ite(condition, low_part, rest));
  }
  if (const TermId one_operation = OfSharedOperand(condition, then, otherwise); one_operation.valid())
    return one_operation;
  return Add({TermKind::kIte, one.width, condition.index, then.index, otherwise.index});
}

TermId Terms::Concat(TermId high, TermId low) {
  const auto width = static_cast<uint8_t>(Width(high) + Width(low));
  PLCXX_CHECK(width <= 64);
  if (IsConst(high) && IsConst(low)) return Const((Value(high) << Width(low)) | Value(low), width);
  const Term top = terms_[high.index];
  // Nested to the right, so that equal rows of parts are one term.
  if (top.kind == TermKind::kConcat) return Concat(TermId(top.a), Concat(TermId(top.b), low));
  const Term rest = terms_[low.index];
  const bool nested = rest.kind == TermKind::kConcat;
  const TermId next = nested ? TermId(rest.a) : low;  // the part right below `high`
  const auto join = [&](TermId joined) { return nested ? Concat(joined, TermId(rest.b)) : joined; };
  if (nested && IsConst(high) && IsConst(next)) return join(Concat(high, next));
  // Signs above signs: a number that was widened twice is one that was widened once.
  if (const Term below = terms_[next.index]; top.kind == TermKind::kIte && below.kind == TermKind::kIte &&
                                             top.a == below.a && IsConst(TermId(top.b)) && IsConst(TermId(top.c)) &&
                                             IsConst(TermId(below.b)) && IsConst(TermId(below.c))) {
    return join(Ite(TermId(top.a), Concat(TermId(top.b), TermId(below.b)), Concat(TermId(top.c), TermId(below.c))));
  }
  if (const Term below = terms_[next.index]; top.kind == TermKind::kExtract && below.kind == TermKind::kExtract &&
                                             top.a == below.a && below.b + below.width == top.b) {
    return join(Extract(TermId(top.a), static_cast<uint8_t>(below.b), static_cast<uint8_t>(top.width + below.width)));
  }
  return Add({TermKind::kConcat, width, high.index, low.index});
}

Terms::Part Terms::Innermost(Part part) const {
  while (true) {
    const Term& term = terms_[part.of.index];
    if (term.kind == TermKind::kExtract) {
      part.low = static_cast<uint8_t>(part.low + term.b);
      part.of = TermId(term.a);
    } else if (term.kind == TermKind::kConcat && part.low >= Width(TermId(term.b))) {
      part.low = static_cast<uint8_t>(part.low - Width(TermId(term.b)));
      part.of = TermId(term.a);
    } else if (term.kind == TermKind::kConcat && part.low + part.width <= Width(TermId(term.b))) {
      part.of = TermId(term.b);
    } else {
      return part;
    }
  }
}

TermId Terms::FindPart(const Part& part) const {
  if (part.width == Width(part.of)) return part.of;
  const uint32_t found = extract_index_.Find(extract_questions_, QuestionOf(part));
  return found == Index::kNowhere ? TermId() : extracts_[found];
}

TermId Terms::Extract(TermId a, uint8_t low, uint8_t width) {
  PLCXX_CHECK(width >= 1 && low + width <= Width(a));
  const Part asked = Innermost({a, low, width});
  if (const TermId found = FindPart(asked); found.valid()) return found;
  // Parts are made from below, on a stack of our own: a chain of choices may be longer than the processor's stack. Each
  // is made once: without it the work would double with every shared operand.
  std::vector<Part> open{asked};
  while (!open.empty()) {
    const Part part = open.back();
    if (FindPart(part).valid()) {
      open.pop_back();
      continue;
    }
    const size_t before = open.size();
    ForEachPartBelow(part, [this, &open](const Part& below) {
      const Part innermost = Innermost(below);
      if (!FindPart(innermost).valid()) open.push_back(innermost);
    });
    if (open.size() > before) continue;
    open.pop_back();
    const TermId result = ExtractNew(part.of, part.low, part.width);
    if (extract_index_.FindOrAdd(extract_questions_, QuestionOf(part)) != Index::kNowhere) continue;
    extract_questions_.push_back(QuestionOf(part));
    extracts_.push_back(result);
  }
  return FindPart(asked);
}

/// The parts of operands that ExtractNew asks for.
template <class Visit>
void Terms::ForEachPartBelow(const Part& part, Visit&& visit) const {
  const Term term = terms_[part.of.index];
  switch (term.kind) {
    case TermKind::kConcat: {
      // Innermost has seen to it that the part reaches into both.
      const uint8_t border = Width(TermId(term.b));
      visit({TermId(term.a), 0, static_cast<uint8_t>(part.low + part.width - border)});
      visit({TermId(term.b), part.low, static_cast<uint8_t>(border - part.low)});
      return;
    }
    case TermKind::kNot:
      visit({TermId(term.a), part.low, part.width});
      return;
    case TermKind::kAnd:
    case TermKind::kOr:
    case TermKind::kXor:
      visit({TermId(term.a), part.low, part.width});
      visit({TermId(term.b), part.low, part.width});
      return;
    case TermKind::kIte:
      visit({TermId(term.b), part.low, part.width});
      visit({TermId(term.c), part.low, part.width});
      return;
    case TermKind::kAdd:
    case TermKind::kSub:
    case TermKind::kMul:
      if (part.low != 0) return;
      visit({TermId(term.a), 0, part.width});
      visit({TermId(term.b), 0, part.width});
      return;
    case TermKind::kConst:
    case TermKind::kVariable:
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
    case TermKind::kExtract:
    case TermKind::kApply:
      return;
  }
}

TermId Terms::ExtractNew(TermId a, uint8_t low, uint8_t width) {
  const Term term = terms_[a.index];
  switch (term.kind) {
    case TermKind::kConst:
      return Const(Value(a) >> low, width);
    case TermKind::kConcat: {
      const TermId high(term.a), rest(term.b);
      const uint8_t border = Width(rest);
      return Concat(Extract(high, 0, static_cast<uint8_t>(low + width - border)),
                    Extract(rest, low, static_cast<uint8_t>(border - low)));
    }
    // Bit by bit: the bits of a word that is masked or chosen are terms of their own.
    case TermKind::kNot:
      return Not(Extract(TermId(term.a), low, width));
    case TermKind::kAnd:
      return And(Extract(TermId(term.a), low, width), Extract(TermId(term.b), low, width));
    case TermKind::kOr:
      return Or(Extract(TermId(term.a), low, width), Extract(TermId(term.b), low, width));
    case TermKind::kXor:
      return Xor(Extract(TermId(term.a), low, width), Extract(TermId(term.b), low, width));
    case TermKind::kIte:
      return Ite(TermId(term.a), Extract(TermId(term.b), low, width), Extract(TermId(term.c), low, width));
    // The low bits of a sum are the sum of the low bits.
    case TermKind::kAdd:
      if (low == 0) return Add(Extract(TermId(term.a), 0, width), Extract(TermId(term.b), 0, width));
      break;
    case TermKind::kSub:
      if (low == 0) return Sub(Extract(TermId(term.a), 0, width), Extract(TermId(term.b), 0, width));
      break;
    case TermKind::kMul:
      if (low == 0) return Mul(Extract(TermId(term.a), 0, width), Extract(TermId(term.b), 0, width));
      break;
    // Above a remainder, and above what a bounded number is divided to, there are zeros.
    case TermKind::kUdiv:
    case TermKind::kUrem: {
      const auto bits = static_cast<uint8_t>(std::bit_width(GreatestOf(*this, a)));
      if (bits <= low) return Const(0, width);
      if (bits < low + width) return Zext(Extract(a, low, static_cast<uint8_t>(bits - low)), width);
      break;
    }
    case TermKind::kVariable:
    case TermKind::kSdiv:
    case TermKind::kSrem:
    case TermKind::kShl:
    case TermKind::kLshr:
    case TermKind::kAshr:
    case TermKind::kEq:
    case TermKind::kUlt:
    case TermKind::kSlt:
    case TermKind::kExtract:
    case TermKind::kApply:
      break;
  }
  return Add({TermKind::kExtract, width, a.index, low});
}

}  // namespace plcxx::terms
