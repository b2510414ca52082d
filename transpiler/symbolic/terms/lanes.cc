#include "transpiler/symbolic/terms/lanes.h"

#include <algorithm>
#include <map>

#include "transpiler/support/check.h"
#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::terms {
namespace {

constexpr uint32_t kScratch = 0x80000000;  // in the number of a plane: not a variable's

Plane Majority(const Plane& a, const Plane& b, const Plane& c) { return (a & b) | (c & (a ^ b)); }

/// to = a + b + carry
void AddTo(Plane* to, const Plane* a, const Plane* b, uint32_t width) {
  Plane carry;
  for (uint32_t i = 0; i < width; ++i) {
    const Plane one = a[i], other = b[i];
    to[i] = one ^ other ^ carry;
    carry = Majority(one, other, carry);
  }
}

/// to = a - b, as a + ~b + 1; gives where there was no borrow: a >= b
Plane SubtractTo(Plane* to, const Plane* a, const Plane* b, uint32_t width) {
  Plane carry;
  carry.Fill(true);
  for (uint32_t i = 0; i < width; ++i) {
    const Plane one = a[i], other = ~b[i];
    to[i] = one ^ other ^ carry;
    carry = Majority(one, other, carry);
  }
  return carry;
}

Plane Less(const Plane* a, const Plane* b, uint32_t width, bool is_signed) {
  Plane less;
  for (uint32_t i = 0; i < width; ++i) {
    const bool swaps = is_signed && i + 1 == width;  // a sign counts downwards
    const Plane &one = swaps ? b[i] : a[i], &other = swaps ? a[i] : b[i];
    less = Choice(one ^ other, other, less);
  }
  return less;
}

void NegateWhere(const Plane& where, Plane* value, uint32_t width) {
  Plane carry = where;
  for (uint32_t i = 0; i < width; ++i) {
    const Plane flipped = value[i] ^ where;
    value[i] = flipped ^ carry;
    carry = flipped & carry;
  }
}

void MultiplyTo(Plane* to, const Plane* a, const Plane* b, uint32_t width) {
  std::array<Plane, 64> sum{}, row{};
  for (uint32_t i = 0; i < width; ++i) {
    if (b[i].IsZero()) continue;
    for (uint32_t k = i; k < width; ++k) row[k] = a[k - i] & b[i];
    AddTo(&sum[i], &sum[i], &row[i], width - i);
  }
  std::copy_n(sum.begin(), width, to);
}

/// Restoring division, the highest bit first. A divisor of 0 gives what SMT-LIB says by itself: all ones, and a.
void Divide(const Plane* a, const Plane* b, uint32_t width, Plane* quotient, Plane* remainder) {
  std::array<Plane, 64> rest{}, less{};
  for (uint32_t i = width; i-- > 0;) {
    const Plane high = rest[width - 1];
    for (uint32_t k = width; k-- > 1;) rest[k] = rest[k - 1];
    rest[0] = a[i];
    const Plane fits = SubtractTo(less.data(), rest.data(), b, width) | high;
    for (uint32_t k = 0; k < width; ++k) rest[k] = Choice(fits, less[k], rest[k]);
    quotient[i] = fits;
  }
  std::copy_n(rest.begin(), width, remainder);
}

void DivideTo(TermKind kind, Plane* to, const Plane* a, const Plane* b, uint32_t width) {
  std::array<Plane, 64> one{}, other{}, quotient{}, remainder{};
  std::copy_n(a, width, one.begin());
  std::copy_n(b, width, other.begin());
  const bool is_signed = kind == TermKind::kSdiv || kind == TermKind::kSrem;
  const Plane a_sign = one[width - 1], b_sign = other[width - 1];
  if (is_signed) {
    NegateWhere(a_sign, one.data(), width);
    NegateWhere(b_sign, other.data(), width);
  }
  Divide(one.data(), other.data(), width, quotient.data(), remainder.data());
  if (is_signed) {
    NegateWhere(a_sign ^ b_sign, quotient.data(), width);
    NegateWhere(a_sign, remainder.data(), width);
  }
  const bool is_quotient = kind == TermKind::kUdiv || kind == TermKind::kSdiv;
  std::copy_n(is_quotient ? quotient.begin() : remainder.begin(), width, to);
}

/// By the powers of two of which `by` is made; more than the width shifts everything out.
void ShiftTo(TermKind kind, Plane* to, const Plane* a, const Plane* by, uint32_t width) {
  std::array<Plane, 64> now{};
  std::copy_n(a, width, now.begin());
  const Plane fill = kind == TermKind::kAshr ? a[width - 1] : Plane();
  Plane everything;
  for (uint32_t bit = 0; bit < width; ++bit) {
    if (bit >= 6 || (uint32_t{1} << bit) >= width) {
      everything = everything | by[bit];
      continue;
    }
    const uint32_t count = uint32_t{1} << bit;
    std::array<Plane, 64> next{};
    for (uint32_t i = 0; i < width; ++i) {
      const bool is_left = kind == TermKind::kShl;
      const bool is_inside = is_left ? i >= count : i + count < width;
      next[i] = Choice(by[bit], is_inside ? now[is_left ? i - count : i + count] : fill, now[i]);
    }
    std::copy_n(next.begin(), width, now.begin());
  }
  for (uint32_t i = 0; i < width; ++i) to[i] = Choice(everything, fill, now[i]);
}

}  // namespace

uint64_t ValueInLane(std::span<const Plane> planes, uint32_t lane) {
  uint64_t value = 0;
  for (size_t i = 0; i < planes.size(); ++i) value |= uint64_t{planes[i].Get(lane)} << i;
  return value;
}

void SetInLane(std::span<Plane> planes, uint32_t lane, uint64_t value) {
  for (size_t i = 0; i < planes.size(); ++i) planes[i].Set(lane, (value >> i & 1) != 0);
}

/// Gives each term its planes, and those of a term that is not needed any more to another one.
class LaneProgram::Compiler {
 public:
  Compiler(LaneProgram& program, std::span<const VariableAt> variables, std::span<const TermId> roots)
      : program_(program),
        terms_(program.terms_),
        cone_(ConeOf(terms_, roots)),
        at_(terms_.size(), kNowhere),
        uses_(terms_.size()),
        owner_(terms_.size()),
        is_computed_(terms_.size()) {
    for (const VariableAt& variable : variables) at_[variable.variable.index] = variable.plane;
    for (const TermId id : cone_) {
      terms_.ForEachOperand(terms_[id], [this](TermId operand) { ++uses_[operand.index]; });
    }
    for (const TermId root : roots) ++uses_[root.index];  // never let go
  }

  void Compile(std::span<const TermId> roots) {
    for (const TermId id : cone_) AddConstant(id);
    for (const TermId id : cone_) AddTerm(id);
    program_.scratch_.resize(planes_);
    for (const TermId root : roots) {
      program_.roots_.push_back(at_[root.index]);
      program_.root_widths_.push_back(terms_.Width(root));
    }
  }

 private:
  static constexpr uint32_t kNowhere = 0xFFFFFFFF;

  uint32_t Allocate(uint8_t width) {
    std::vector<uint32_t>& free = free_[width];
    if (!free.empty()) {
      const uint32_t at = free.back();
      free.pop_back();
      return at;
    }
    const uint32_t at = planes_ | kScratch;
    planes_ += width;
    return at;
  }

  void AddConstant(TermId id) {
    if (!terms_.IsConst(id)) return;
    const uint8_t width = terms_.Width(id);
    at_[id.index] = planes_ | kScratch;
    for (uint8_t i = 0; i < width; ++i) {
      program_.scratch_.emplace_back().Fill((terms_.Value(id) >> i & 1) != 0);
    }
    planes_ += width;
  }

  /// A term that is a part of another one, or two that lie beside each other, has its planes there; `owner` then keeps
  /// them.
  void Alias(TermId id, uint32_t at, TermId owner) {
    at_[id.index] = at;
    owner_[id.index] = owner;
    ++uses_[owner.index];
  }

  void Release(TermId id) {
    if (--uses_[id.index] != 0) return;
    if (owner_[id.index].valid()) {
      Release(owner_[id.index]);
    } else if (is_computed_[id.index]) {
      free_[terms_.Width(id)].push_back(at_[id.index]);
    }
  }

  void AddTerm(TermId id) {
    const Term& term = terms_[id];
    if (term.kind == TermKind::kConst) return;
    if (term.kind == TermKind::kVariable) {
      PLCXX_CHECK(at_[id.index] != kNowhere);
      return;
    }
    const auto at = [this](uint32_t operand) { return at_[operand]; };
    const bool lies_together = term.kind == TermKind::kConcat && (at(term.b) & kScratch) == 0 &&
                               at(term.b) + terms_.Width(TermId(term.b)) == at(term.a);
    if (term.kind == TermKind::kExtract) {
      Alias(id, at(term.a) + term.b, TermId(term.a));
    } else if (lies_together) {
      Alias(id, at(term.b), TermId(term.b));  // variables: they stay where they are
    } else {
      Step step{.kind = term.kind, .width = term.width};
      switch (term.kind) {
        case TermKind::kConst:
        case TermKind::kVariable:
        case TermKind::kExtract:
          break;
        case TermKind::kApply: {
          Application application{.function = FunctionId(term.a), .from = {}, .widths = {}};
          for (const TermId argument : terms_.Arguments(term)) {
            application.from.push_back(at(argument.index));
            application.widths.push_back(terms_.Width(argument));
          }
          step.from[0] = static_cast<uint32_t>(program_.applications_.size());
          program_.applications_.push_back(std::move(application));
          break;
        }
        case TermKind::kConcat:
          step.from = {at(term.a), at(term.b), terms_.Width(TermId(term.b))};
          break;
        case TermKind::kIte:
          step.from = {at(term.a), at(term.b), at(term.c)};
          break;
        case TermKind::kNot:
          step.from = {at(term.a)};
          break;
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
        case TermKind::kSlt:
          step.width = terms_.Width(TermId(term.a));
          step.from = {at(term.a), at(term.b)};
          break;
      }
      // Before the operands are let go: a result never overwrites what it is computed from.
      step.to = Allocate(term.width);
      at_[id.index] = step.to;
      is_computed_[id.index] = true;
      program_.steps_.push_back(step);
    }
    terms_.ForEachOperand(term, [this](TermId operand) { Release(operand); });
  }

  LaneProgram& program_;
  const Terms& terms_;
  std::vector<TermId> cone_;
  std::vector<uint32_t> at_, uses_;                // by term
  std::vector<TermId> owner_;                      // by term: none, or whose planes it has
  std::vector<bool> is_computed_;                  // by term: its planes are its own, in the scratch
  std::map<uint8_t, std::vector<uint32_t>> free_;  // by width
  uint32_t planes_ = 0;
};

LaneProgram::LaneProgram(const Terms& terms, std::span<const VariableAt> variables, std::span<const TermId> roots)
    : terms_(terms) {
  Compiler(*this, variables, roots).Compile(roots);
}

void LaneProgram::Run(std::span<const Plane> variables) {
  bases_ = {variables.data(), scratch_.data()};
  for (const Step& step : steps_) Execute(step);
}

std::span<const Plane> LaneProgram::Root(size_t root) const { return {At(roots_[root]), root_widths_[root]}; }

void LaneProgram::Apply(const Step& step) {
  const Application& application = applications_[step.from[0]];
  const TermFunction& function = terms_.Info(application.function);
  std::vector<uint64_t> arguments(application.from.size());
  for (uint32_t lane = 0; lane < Plane::kLanes; ++lane) {
    for (size_t i = 0; i < arguments.size(); ++i)
      arguments[i] = ValueInLane({At(application.from[i]), application.widths[i]}, lane);
    const uint64_t value =
        function.evaluate != nullptr ? function.evaluate(arguments) : MadeUpValue(function, arguments);
    SetInLane({To(step), step.width}, lane, value);
  }
}

void LaneProgram::Execute(const Step& step) {
  Plane* const to = To(step);
  const uint32_t width = step.width;
  const Plane* const a = step.kind == TermKind::kApply ? nullptr : At(step.from[0]);
  const Plane* const b = step.kind == TermKind::kApply || step.kind == TermKind::kNot ? nullptr : At(step.from[1]);
  switch (step.kind) {
    case TermKind::kConst:
    case TermKind::kVariable:
    case TermKind::kExtract:
      PLCXX_UNREACHABLE();
    case TermKind::kNot:
      for (uint32_t i = 0; i < width; ++i) to[i] = ~a[i];
      return;
    case TermKind::kAnd:
      for (uint32_t i = 0; i < width; ++i) to[i] = a[i] & b[i];
      return;
    case TermKind::kOr:
      for (uint32_t i = 0; i < width; ++i) to[i] = a[i] | b[i];
      return;
    case TermKind::kXor:
      for (uint32_t i = 0; i < width; ++i) to[i] = a[i] ^ b[i];
      return;
    case TermKind::kAdd:
      AddTo(to, a, b, width);
      return;
    case TermKind::kSub:
      SubtractTo(to, a, b, width);
      return;
    case TermKind::kMul:
      MultiplyTo(to, a, b, width);
      return;
    case TermKind::kUdiv:
    case TermKind::kUrem:
    case TermKind::kSdiv:
    case TermKind::kSrem:
      DivideTo(step.kind, to, a, b, width);
      return;
    case TermKind::kShl:
    case TermKind::kLshr:
    case TermKind::kAshr:
      ShiftTo(step.kind, to, a, b, width);
      return;
    case TermKind::kEq: {
      Plane unequal;
      for (uint32_t i = 0; i < width; ++i) unequal = unequal | (a[i] ^ b[i]);
      *to = ~unequal;
      return;
    }
    case TermKind::kUlt:
    case TermKind::kSlt:
      *to = Less(a, b, width, step.kind == TermKind::kSlt);
      return;
    case TermKind::kIte: {
      const Plane* const c = At(step.from[2]);
      for (uint32_t i = 0; i < width; ++i) to[i] = Choice(*a, b[i], c[i]);
      return;
    }
    case TermKind::kConcat: {
      const uint32_t low = step.from[2];
      std::copy_n(b, low, to);
      std::copy_n(a, width - low, to + low);
      return;
    }
    case TermKind::kApply:
      Apply(step);
      return;
  }
}

}  // namespace plcxx::terms
