#include "transpiler/symbolic/terms/terms.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "transpiler/symbolic/terms/division.h"
#include "transpiler/symbolic/terms/magnitude.h"

namespace plcxx::terms {

namespace {

uint32_t HashOf(const Term& term) {
  uint64_t hash = (uint64_t{term.a} << 32 | term.b) * 0x9E3779B97F4A7C15;
  hash ^= (uint64_t{term.c} << 16 | static_cast<uint64_t>(term.kind) << 8 | term.width) * 0xC2B2AE3D27D4EB4F;
  return static_cast<uint32_t>(hash ^ hash >> 31);
}

/// A number of fewer bits, without a sign.
bool IsWidenedByZeros(const Terms& terms, TermId id) {
  return terms[id].kind == TermKind::kConcat && terms.IsZero(TermId(terms[id].a));
}

}  // namespace

size_t Terms::Index::SlotOf(std::span<const Term> keys, const Term& term, uint32_t hash) const {
  const size_t mask = slots_.size() - 1;
  size_t at = hash & mask;
  while (slots_[at].at != kNowhere && (slots_[at].hash != hash || keys[slots_[at].at] != term)) at = (at + 1) & mask;
  return at;
}

void Terms::Index::Grow() {
  const std::vector<Slot> before = std::exchange(slots_, {});
  slots_.resize(std::max<size_t>(1024, 2 * before.size()));
  const size_t mask = slots_.size() - 1;
  for (const Slot& slot : before) {
    if (slot.at == kNowhere) continue;
    size_t at = slot.hash & mask;
    while (slots_[at].at != kNowhere) at = (at + 1) & mask;
    slots_[at] = slot;
  }
}

uint32_t Terms::Index::FindOrAdd(std::span<const Term> keys, const Term& term) {
  if (4 * (used_ + 1) > 3 * slots_.size()) Grow();
  const uint32_t hash = HashOf(term);
  Slot& slot = slots_[SlotOf(keys, term, hash)];
  if (slot.at != kNowhere) return slot.at;
  slot = {.hash = hash, .at = static_cast<uint32_t>(keys.size())};
  ++used_;
  return kNowhere;
}

uint32_t Terms::Index::Find(std::span<const Term> keys, const Term& term) const {
  return slots_.empty() ? kNowhere : slots_[SlotOf(keys, term, HashOf(term))].at;
}

Terms::Terms() {
  zero_ = Const(0, 1);
  one_ = Const(1, 1);
}

TermId Terms::Add(Term term) {
  const uint32_t known = index_.FindOrAdd(terms_, term);
  if (known != Index::kNowhere) return TermId(known);
  terms_.push_back(term);
  return TermId(size() - 1);
}

TermId Terms::Const(uint64_t value, uint8_t width) {
  PLCXX_CHECK(width >= 1 && width <= 64);
  value = Masked(value, width);
  return Add({TermKind::kConst, width, static_cast<uint32_t>(value), static_cast<uint32_t>(value >> 32)});
}

TermId Terms::Variable(std::string name, uint8_t width) {
  PLCXX_CHECK(width >= 1 && width <= 64);
  variables_.push_back(std::move(name));
  return Add({TermKind::kVariable, width, variable_count() - 1});
}

bool Terms::IsNotOf(TermId a, TermId b) const {
  const Term& term = terms_[a.index];
  return term.kind == TermKind::kNot && TermId(term.a) == b;
}

TermId Terms::Not(TermId a) {
  const Term term = terms_[a.index];
  if (term.kind == TermKind::kNot) return TermId(term.a);
  if (IsConst(a)) return Const(~Value(a), term.width);
  // Part by part: a bit in a byte that is negated stays a bit below zeros that are known.
  if (term.kind == TermKind::kConcat) return Concat(Not(TermId(term.a)), Not(TermId(term.b)));
  return Add({TermKind::kNot, term.width, a.index});
}

TermId Terms::Binary(TermKind kind, TermId a, TermId b, uint8_t width) {
  PLCXX_CHECK(Width(a) == Width(b));
  if (IsConst(a) && IsConst(b)) return Const(EvaluateBinary(kind, Value(a), Value(b), Width(a)), width);
  return Add({kind, width, a.index, b.index});
}

TermId Terms::ByParts(TermKind kind, TermId a, TermId b) {
  const auto is_row = [this](TermId id) {
    return terms_[id.index].kind == TermKind::kConcat || terms_[id.index].kind == TermKind::kConst;
  };
  if (!is_row(a) || !is_row(b)) return {};
  for (const TermId split : {a, b}) {
    if (IsConst(split)) continue;
    const uint8_t low = Width(TermId(terms_[split.index].b));
    const auto high = static_cast<uint8_t>(Width(a) - low);
    const TermId high_a = Extract(a, low, high), high_b = Extract(b, low, high);
    const TermId low_a = Extract(a, 0, low), low_b = Extract(b, 0, low);
    const auto is_simple = [this](TermId x, TermId y) { return x == y || IsConst(x) || IsConst(y); };
    if (!is_simple(high_a, high_b) && !is_simple(low_a, low_b)) continue;
    if (kind == TermKind::kAnd) return Concat(And(high_a, high_b), And(low_a, low_b));
    if (kind == TermKind::kOr) return Concat(Or(high_a, high_b), Or(low_a, low_b));
    return Concat(Xor(high_a, high_b), Xor(low_a, low_b));
  }
  return {};
}

TermId Terms::MaskedParts(TermId a, uint64_t mask) {
  constexpr int kMostParts = 3;
  const uint8_t width = Width(a);
  TermId result;
  int parts = 0;
  for (uint8_t low = 0; low < width; ++parts) {
    const uint64_t rest = mask >> low;
    const int run = (rest & 1) != 0 ? std::countr_one(rest) : std::countr_zero(rest);
    const auto count = static_cast<uint8_t>(std::min<int>(run, width - low));
    if (parts == kMostParts) return {};
    const TermId part = (rest & 1) != 0 ? Extract(a, low, count) : Const(0, count);
    result = result.valid() ? Concat(part, result) : part;
    low = static_cast<uint8_t>(low + count);
  }
  return result;
}

TermId Terms::And(TermId a, TermId b) {
  if (b < a) std::swap(a, b);  // constants are not always lower: both places are looked at
  if (a == b) return a;
  const uint8_t width = Width(a);
  for (const auto& [constant, other] : {std::pair(a, b), std::pair(b, a)}) {
    if (!IsConst(constant)) continue;
    if (Value(constant) == 0) return constant;
    if (Value(constant) == Masked(~uint64_t{0}, width)) return other;
  }
  if (IsNotOf(a, b) || IsNotOf(b, a)) return Const(0, width);
  // x & (x & y), x & (x | y)
  for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
    const Term term = terms_[other.index];
    const bool contains = term.a == one.index || term.b == one.index;
    if (term.kind == TermKind::kAnd && contains) return other;
    if (term.kind == TermKind::kOr && contains) return one;
  }
  if (const TermId parts = ByParts(TermKind::kAnd, a, b); parts.valid()) return parts;
  for (const auto& [constant, other] : {std::pair(a, b), std::pair(b, a)}) {
    if (!IsConst(constant) || IsConst(other)) continue;
    if (const TermId parts = MaskedParts(other, Value(constant)); parts.valid()) return parts;
  }
  return Binary(TermKind::kAnd, a, b, width);
}

TermId Terms::Or(TermId a, TermId b) {
  if (b < a) std::swap(a, b);
  if (a == b) return a;
  const uint8_t width = Width(a);
  const uint64_t ones = Masked(~uint64_t{0}, width);
  for (const auto& [constant, other] : {std::pair(a, b), std::pair(b, a)}) {
    if (!IsConst(constant)) continue;
    if (Value(constant) == ones) return constant;
    if (Value(constant) == 0) return other;
  }
  if (IsNotOf(a, b) || IsNotOf(b, a)) return Const(ones, width);
  for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
    const Term term = terms_[other.index];
    const bool contains = term.a == one.index || term.b == one.index;
    if (term.kind == TermKind::kOr && contains) return other;
    if (term.kind == TermKind::kAnd && contains) return one;
  }
  if (const TermId parts = ByParts(TermKind::kOr, a, b); parts.valid()) return parts;
  return Binary(TermKind::kOr, a, b, width);
}

TermId Terms::Xor(TermId a, TermId b) {
  if (b < a) std::swap(a, b);
  const uint8_t width = Width(a);
  const uint64_t ones = Masked(~uint64_t{0}, width);
  if (a == b) return Const(0, width);
  for (const auto& [constant, other] : {std::pair(a, b), std::pair(b, a)}) {
    if (!IsConst(constant)) continue;
    if (Value(constant) == 0) return other;
    if (Value(constant) == ones) return Not(other);
  }
  // Complements go outside: !x ^ y = !(x ^ y).
  if (terms_[a.index].kind == TermKind::kNot) return Not(Xor(TermId(terms_[a.index].a), b));
  if (terms_[b.index].kind == TermKind::kNot) return Not(Xor(a, TermId(terms_[b.index].a)));
  if (const TermId parts = ByParts(TermKind::kXor, a, b); parts.valid()) return parts;
  // (x ^ c) ^ d = x ^ (c ^ d)
  for (const auto& [constant, other] : {std::pair(a, b), std::pair(b, a)}) {
    const Term term = terms_[other.index];
    if (!IsConst(constant) || term.kind != TermKind::kXor) continue;
    const TermId one(term.a), two(term.b);
    if (IsConst(one)) return Xor(two, Binary(TermKind::kXor, one, constant, width));
    if (IsConst(two)) return Xor(one, Binary(TermKind::kXor, two, constant, width));
  }
  return Binary(TermKind::kXor, a, b, width);
}

TermId Terms::Add(TermId a, TermId b) {
  if (Width(a) == 1) return Xor(a, b);
  if (b < a) std::swap(a, b);
  if (IsZero(a)) return b;
  if (IsZero(b)) return a;
  if (const TermId rest = RemainderOfSum(*this, a, b); rest.valid()) return rest;
  // (x + c) + d = x + (c + d)
  for (const auto& [constant, other] : {std::pair(a, b), std::pair(b, a)}) {
    const Term term = terms_[other.index];
    if (!IsConst(constant) || term.kind != TermKind::kAdd) continue;
    if (IsConst(TermId(term.a)))
      return Add(TermId(term.b), Binary(TermKind::kAdd, TermId(term.a), constant, term.width));
    if (IsConst(TermId(term.b)))
      return Add(TermId(term.a), Binary(TermKind::kAdd, TermId(term.b), constant, term.width));
  }
  if (const TermId choice = OfChoice(TermKind::kAdd, a, b); choice.valid()) return choice;
  return Binary(TermKind::kAdd, a, b, Width(a));
}

TermId Terms::Sub(TermId a, TermId b) {
  if (Width(a) == 1) return Xor(a, b);
  if (a == b) return Const(0, Width(a));
  // One spelling of x - c, which compilers write as x + (-c).
  if (IsConst(b)) return Add(a, Const(uint64_t{0} - Value(b), Width(b)));
  if (const Term negated = terms_[b.index]; IsZero(a)) {
    if (negated.kind == TermKind::kSub && IsZero(TermId(negated.a))) return TermId(negated.b);
    // A magnitude: its two branches change places.
    if (const TermId one(negated.b), other(negated.c);
        negated.kind == TermKind::kIte && (IsNegOf(*this, one, other) || IsNegOf(*this, other, one))) {
      return Ite(TermId(negated.a), other, one);
    }
  }
  if (const TermId choice = OfChoice(TermKind::kSub, a, b); choice.valid()) return choice;
  return Binary(TermKind::kSub, a, b, Width(a));
}

TermId Terms::Mul(TermId a, TermId b) {
  if (Width(a) == 1) return And(a, b);
  if (b < a) std::swap(a, b);
  for (const auto& [constant, other] : {std::pair(a, b), std::pair(b, a)}) {
    if (!IsConst(constant)) continue;
    if (Value(constant) == 0) return constant;
    if (Value(constant) == 1) return other;
    // One spelling of x * 2^n.
    if (!IsConst(other) && (Value(constant) & (Value(constant) - 1)) == 0) {
      return Shl(other, Const(static_cast<uint64_t>(std::countr_zero(Value(constant))), Width(a)));
    }
  }
  if (const TermId choice = OfChoice(TermKind::kMul, a, b); choice.valid()) return choice;
  return Binary(TermKind::kMul, a, b, Width(a));
}

TermId Terms::Udiv(TermId a, TermId b) {
  if (IsConst(b) && Value(b) != 0 && (Value(b) & (Value(b) - 1)) == 0) {
    return Lshr(a, Const(static_cast<uint64_t>(std::countr_zero(Value(b))), Width(a)));
  }
  const uint8_t width = Width(a);
  if (!IsConst(b) || IsZero(b) || IsConst(a)) return Binary(TermKind::kUdiv, a, b, width);
  // What is known to be 0 says so: above the number, and above what the divisor leaves of it.
  if (const Term term = terms_[a.index]; term.kind == TermKind::kConcat && IsZero(TermId(term.a))) {
    const TermId number(term.b);
    if (Value(b) > Masked(~uint64_t{0}, Width(number))) return Const(0, width);
    return Zext(Udiv(number, Const(Value(b), Width(number))), width);
  }
  const uint64_t greatest = GreatestOf(*this, a);
  if (Value(b) > greatest) return Const(0, width);
  if (const uint8_t narrow = WidthOfDivision(greatest); narrow < width)
    return Zext(Udiv(Extract(a, 0, narrow), Const(Value(b), narrow)), width);
  // After the bound, which may be what a choice says as a whole.
  if (const TermId choice = OfChoice(TermKind::kUdiv, a, b); choice.valid()) return choice;
  const auto bits = static_cast<uint8_t>(std::bit_width(Masked(~uint64_t{0}, width) / Value(b)));
  return Zext(Extract(Binary(TermKind::kUdiv, a, b, width), 0, bits), width);
}

TermId Terms::Urem(TermId a, TermId b) {
  if (IsConst(b) && Value(b) != 0 && (Value(b) & (Value(b) - 1)) == 0) {
    return And(a, Const(Value(b) - 1, Width(a)));
  }
  const uint8_t width = Width(a);
  if (!IsConst(b) || IsZero(b) || IsConst(a)) return Binary(TermKind::kUrem, a, b, width);
  if (const Term term = terms_[a.index]; term.kind == TermKind::kConcat && IsZero(TermId(term.a))) {
    const TermId number(term.b);
    if (Value(b) > Masked(~uint64_t{0}, Width(number))) return a;
    return Zext(Urem(number, Const(Value(b), Width(number))), width);
  }
  const uint64_t greatest = GreatestOf(*this, a);
  if (Value(b) > greatest) return a;
  if (const uint8_t narrow = WidthOfDivision(greatest); narrow < width)
    return Zext(Urem(Extract(a, 0, narrow), Const(Value(b), narrow)), width);
  if (const TermId choice = OfChoice(TermKind::kUrem, a, b); choice.valid()) return choice;
  const auto bits = static_cast<uint8_t>(std::bit_width(Value(b) - 1));
  return Zext(Extract(Binary(TermKind::kUrem, a, b, width), 0, bits), width);
}

TermId Terms::OfMagnitude(TermKind kind, TermId a, TermId divisor) {
  const TermId is_negative = Extract(a, static_cast<uint8_t>(Width(a) - 1), 1);
  const TermId magnitude = Ite(is_negative, Neg(a), a);
  const TermId result = kind == TermKind::kSdiv ? Udiv(magnitude, divisor) : Urem(magnitude, divisor);
  return Ite(is_negative, Neg(result), result);
}

TermId Terms::Sdiv(TermId a, TermId b) {
  if (const TermId choice = OfChoice(TermKind::kSdiv, a, b); choice.valid()) return choice;
  if ((IsPositiveConst(b) || IsWidenedByZeros(*this, b)) && !IsConst(a)) return OfMagnitude(TermKind::kSdiv, a, b);
  return Binary(TermKind::kSdiv, a, b, Width(a));
}

TermId Terms::Srem(TermId a, TermId b) {
  if (const TermId choice = OfChoice(TermKind::kSrem, a, b); choice.valid()) return choice;
  if ((IsPositiveConst(b) || IsWidenedByZeros(*this, b)) && !IsConst(a)) return OfMagnitude(TermKind::kSrem, a, b);
  return Binary(TermKind::kSrem, a, b, Width(a));
}

TermId Terms::Shl(TermId a, TermId b) {
  const uint8_t width = Width(a);
  if (IsConst(b)) {
    const uint64_t by = Value(b);
    if (by == 0) return a;
    if (by >= width) return Const(0, width);
    const auto zeros = static_cast<uint8_t>(by);
    return Concat(Extract(a, 0, static_cast<uint8_t>(width - zeros)), Const(0, zeros));
  }
  return Binary(TermKind::kShl, a, b, width);
}

TermId Terms::Lshr(TermId a, TermId b) {
  const uint8_t width = Width(a);
  if (IsConst(b)) {
    const uint64_t by = Value(b);
    if (by == 0) return a;
    if (by >= width) return Const(0, width);
    if (const TermId quotient = QuotientOfProduct(*this, a, static_cast<uint8_t>(by)); quotient.valid())
      return quotient;
    return Zext(Extract(a, static_cast<uint8_t>(by), static_cast<uint8_t>(width - by)), width);
  }
  return Binary(TermKind::kLshr, a, b, width);
}

TermId Terms::Ashr(TermId a, TermId b) {
  const uint8_t width = Width(a);
  if (IsConst(b)) {
    const uint64_t by = std::min<uint64_t>(Value(b), width - 1);
    return Sext(Extract(a, static_cast<uint8_t>(by), static_cast<uint8_t>(width - by)), width);
  }
  return Binary(TermKind::kAshr, a, b, width);
}

TermId Terms::Zext(TermId a, uint8_t width) {
  PLCXX_CHECK(width >= Width(a) && width <= 64);
  if (width == Width(a)) return a;
  return Concat(Const(0, static_cast<uint8_t>(width - Width(a))), a);
}

TermId Terms::Sext(TermId a, uint8_t width) {
  PLCXX_CHECK(width >= Width(a) && width <= 64);
  const uint8_t own = Width(a);
  if (width == own) return a;
  if (IsConst(a)) return Const(static_cast<uint64_t>(AsSigned(Value(a), own)), width);
  const auto above = static_cast<uint8_t>(width - own);
  const TermId sign = Extract(a, static_cast<uint8_t>(own - 1), 1);
  return Concat(Ite(sign, Const(~uint64_t{0}, above), Const(0, above)), a);
}

FunctionId Terms::Function(std::string_view name, uint8_t width,
                           uint64_t (*evaluate)(std::span<const uint64_t> arguments)) {
  const auto [at, added] = function_index_.try_emplace(std::string(name), function_count());
  if (added) functions_.push_back({.name = std::string(name), .width = width, .evaluate = evaluate});
  return FunctionId(at->second);
}

TermId Terms::Apply(FunctionId function, std::span<const TermId> arguments) {
  const TermFunction& info = functions_[function.index];
  if (info.evaluate != nullptr && std::ranges::all_of(arguments, [this](TermId id) { return IsConst(id); })) {
    std::vector<uint64_t> values;
    for (const TermId argument : arguments) values.push_back(Value(argument));
    return Const(info.evaluate(values), info.width);
  }
  uint64_t hash = function.index;
  for (const TermId argument : arguments) hash = (hash ^ argument.index) * 0x9E3779B97F4A7C15;
  std::vector<uint32_t>& candidates = applications_[hash];
  for (const uint32_t candidate : candidates) {
    const Term& term = terms_[candidate];
    if (term.a == function.index && std::ranges::equal(Arguments(term), arguments)) return TermId(candidate);
  }
  // The arguments may be a span of the pool itself.
  const std::vector<TermId> copy(arguments.begin(), arguments.end());
  const auto begin = static_cast<uint32_t>(pool_.size());
  pool_.insert(pool_.end(), copy.begin(), copy.end());
  terms_.push_back({TermKind::kApply, info.width, function.index, begin, static_cast<uint32_t>(copy.size())});
  candidates.push_back(size() - 1);
  return TermId(size() - 1);
}

TermId Terms::Rebuild(const Term& term, std::span<const TermId> operands) {
  // A quotient is made as the part of it that need not be 0 (Udiv, Urem); of the whole there is this term alone.
  const bool divides = term.kind == TermKind::kUdiv || term.kind == TermKind::kUrem;
  if (divides && operands[0].index == term.a && operands[1].index == term.b) return Add(term);
  switch (term.kind) {
    case TermKind::kConst:
    case TermKind::kVariable:
      return Add(term);
    case TermKind::kNot:
      return Not(operands[0]);
    case TermKind::kAnd:
      return And(operands[0], operands[1]);
    case TermKind::kOr:
      return Or(operands[0], operands[1]);
    case TermKind::kXor:
      return Xor(operands[0], operands[1]);
    case TermKind::kAdd:
      return Add(operands[0], operands[1]);
    case TermKind::kSub:
      return Sub(operands[0], operands[1]);
    case TermKind::kMul:
      return Mul(operands[0], operands[1]);
    case TermKind::kUdiv:
      return Udiv(operands[0], operands[1]);
    case TermKind::kUrem:
      return Urem(operands[0], operands[1]);
    case TermKind::kSdiv:
      return Sdiv(operands[0], operands[1]);
    case TermKind::kSrem:
      return Srem(operands[0], operands[1]);
    case TermKind::kShl:
      return Shl(operands[0], operands[1]);
    case TermKind::kLshr:
      return Lshr(operands[0], operands[1]);
    case TermKind::kAshr:
      return Ashr(operands[0], operands[1]);
    case TermKind::kEq:
      return Eq(operands[0], operands[1]);
    case TermKind::kUlt:
      return Ult(operands[0], operands[1]);
    case TermKind::kSlt:
      return Slt(operands[0], operands[1]);
    case TermKind::kIte:
      return Ite(operands[0], operands[1], operands[2]);
    case TermKind::kConcat:
      return Concat(operands[0], operands[1]);
    case TermKind::kExtract:
      return Extract(operands[0], static_cast<uint8_t>(term.b), term.width);
    case TermKind::kApply:
      return Apply(FunctionId(term.a), operands);
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::terms
