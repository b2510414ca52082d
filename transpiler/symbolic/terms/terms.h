// What is computed, as terms over bit vectors: the one language in which the typed IR, compiled code and properties
// are compared.
//
// A term is an id into a table without duplicates: terms that are built alike are one, so that equality of equal parts
// costs nothing. Every function below that makes a term folds constants and applies the identities that need no
// search; Solver (symbolic/solver) decides the rest. Widths are 1..64 bits. Not its job: memory, control flow, IR.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "transpiler/support/ids.h"

namespace plcxx::terms {

using TermId = support::Id<struct TermTag>;
using FunctionId = support::Id<struct TermFunctionTag>;

/// The meaning is SMT-LIB's of the bit-vector operation of that name: x / 0 is all ones and x % 0 is x (unsigned);
/// shifts by the width or more give 0, or the sign for kAshr.
enum class TermKind : uint8_t {
  kConst,     // a, b = low and high half of the value
  kVariable,  // a = number of the variable
  kNot,
  kAnd,
  kOr,
  kXor,
  kAdd,
  kSub,
  kMul,
  kUdiv,
  kUrem,
  kSdiv,
  kSrem,
  kShl,
  kLshr,
  kAshr,
  kEq,       // width 1
  kUlt,      // width 1
  kSlt,      // width 1
  kIte,      // a of width 1 ? b : c
  kConcat,   // a above b
  kExtract,  // of a the bits from b on
  kApply     // a = FunctionId, b = first argument in the pool, c = their number
};

struct Term {
  TermKind kind{};
  uint8_t width = 1;
  uint32_t a = 0, b = 0, c = 0;
  bool operator==(const Term&) const = default;
};

/// A function of which only its name is known to a solver: equal arguments give equal results. With `evaluate` it has a
/// value for concrete arguments (floating point); without, Evaluate makes one up from name and arguments.
struct TermFunction {
  std::string name;  // "f32.add"
  uint8_t width = 1;
  uint64_t (*evaluate)(std::span<const uint64_t> arguments) = nullptr;
};

class Terms {
 public:
  Terms();

  TermId Const(uint64_t value, uint8_t width);
  TermId Bit(bool value) { return value ? one_ : zero_; }
  /// A new variable each time; names are for solvers' texts and counterexamples and should differ.
  TermId Variable(std::string name, uint8_t width);

  TermId Not(TermId a);
  TermId And(TermId a, TermId b);
  TermId Or(TermId a, TermId b);
  TermId Xor(TermId a, TermId b);
  TermId Add(TermId a, TermId b);
  TermId Sub(TermId a, TermId b);
  TermId Neg(TermId a) { return Sub(Const(0, Width(a)), a); }
  TermId Mul(TermId a, TermId b);
  TermId Udiv(TermId a, TermId b);
  TermId Urem(TermId a, TermId b);
  TermId Sdiv(TermId a, TermId b);
  TermId Srem(TermId a, TermId b);
  TermId Shl(TermId a, TermId b);
  TermId Lshr(TermId a, TermId b);
  TermId Ashr(TermId a, TermId b);
  TermId Eq(TermId a, TermId b);
  TermId Ne(TermId a, TermId b) { return Not(Eq(a, b)); }
  TermId Ult(TermId a, TermId b);
  TermId Ule(TermId a, TermId b) { return Not(Ult(b, a)); }
  TermId Slt(TermId a, TermId b);
  TermId Sle(TermId a, TermId b) { return Not(Slt(b, a)); }
  TermId Ite(TermId condition, TermId then, TermId otherwise);
  TermId Concat(TermId high, TermId low);
  /// `width` bits of `a`, from bit `low` on.
  TermId Extract(TermId a, uint8_t low, uint8_t width);
  /// To `width`, which may be the term's own: zeros or the sign above.
  TermId Zext(TermId a, uint8_t width);
  TermId Sext(TermId a, uint8_t width);
  /// The low bits of a wider term, or zeros above a narrower one.
  TermId Resize(TermId a, uint8_t width) { return width < Width(a) ? Extract(a, 0, width) : Zext(a, width); }

  /// The function of this name; width and evaluation of the first call count.
  FunctionId Function(std::string_view name, uint8_t width,
                      uint64_t (*evaluate)(std::span<const uint64_t> arguments) = nullptr);
  TermId Apply(FunctionId function, std::span<const TermId> arguments);

  const Term& operator[](TermId id) const { return terms_[id.index]; }
  uint8_t Width(TermId id) const { return terms_[id.index].width; }
  uint32_t size() const { return static_cast<uint32_t>(terms_.size()); }
  bool IsConst(TermId id) const { return terms_[id.index].kind == TermKind::kConst; }
  /// Of a constant.
  uint64_t Value(TermId id) const {
    const Term& term = terms_[id.index];
    return (uint64_t{term.b} << 32) | term.a;
  }
  bool IsZero(TermId id) const { return IsConst(id) && Value(id) == 0; }
  bool IsTrue(TermId id) const { return id == one_; }
  bool IsFalse(TermId id) const { return id == zero_; }

  const std::string& VariableName(uint32_t variable) const { return variables_[variable]; }
  uint32_t variable_count() const { return static_cast<uint32_t>(variables_.size()); }
  const TermFunction& Info(FunctionId function) const { return functions_[function.index]; }
  uint32_t function_count() const { return static_cast<uint32_t>(functions_.size()); }
  std::span<const TermId> Arguments(const Term& apply) const { return {pool_.data() + apply.b, apply.c}; }

  /// Calls `visit(TermId)` for the operands of a term, in order.
  template <class Visit>
  void ForEachOperand(const Term& term, Visit&& visit) const {
    switch (term.kind) {
      case TermKind::kConst:
      case TermKind::kVariable:
        return;
      case TermKind::kNot:
      case TermKind::kExtract:
        visit(TermId(term.a));
        return;
      case TermKind::kIte:
        visit(TermId(term.a));
        visit(TermId(term.b));
        visit(TermId(term.c));
        return;
      case TermKind::kApply:
        for (const TermId argument : Arguments(term)) visit(argument);
        return;
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
      case TermKind::kConcat:
        visit(TermId(term.a));
        visit(TermId(term.b));
        return;
    }
  }

  /// The term with the same kind over other operands, made by the functions above: what Substitute and sweeping use.
  TermId Rebuild(const Term& term, std::span<const TermId> operands);

 private:
  TermId Add(Term term);  // the one that is there, or a new one
  TermId Binary(TermKind kind, TermId a, TermId b, uint8_t width);
  bool IsNotOf(TermId a, TermId b) const;
  TermId EqOfConst(TermId a, TermId constant);
  /// The same where `condition` has the value; looks only at what is asked first in the term.
  TermId Where(TermId term, TermId condition, bool value);
  /// Whether `choice`, choices one in the other, is `leaf` wherever `condition` has the value: as far as the parts of
  /// conditions tell.
  bool IsWhere(TermId choice, TermId leaf, TermId condition, bool value) const;
  /// An operation of a choice and a constant as the choice of two operations, where one of them is of constants.
  TermId OfChoice(TermKind kind, TermId a, TermId b);
  /// A choice of two products or quotients that have an operand in common, as one of a choice: c ? x * y : x * z is
  /// x * (c ? y : z), which a solver has to look at once. None where they have none.
  TermId OfSharedOperand(TermId condition, TermId then, TermId otherwise);
  bool IsPositiveConst(TermId id) const { return IsConst(id) && !IsZero(id) && Value(id) >> (Width(id) - 1) == 0; }
  /// A quotient or remainder of signed numbers, by a positive constant, as that of magnitudes: programs that say what
  /// the least number divided by -1 is write it so, and one spelling is one term.
  TermId OfMagnitude(TermKind kind, TermId a, TermId divisor);
  /// Two words that are put together alike, part by part where that makes a part simpler; else none.
  TermId ByParts(TermKind kind, TermId a, TermId b);
  /// The bits of `a` that are 1 in the constant, between zeros; none where they are scattered.
  TermId MaskedParts(TermId a, uint64_t mask);

  /// What Extract is asked for.
  struct Part {
    TermId of;
    uint8_t low, width;
  };
  /// The same bits of the part or the operand of a row that they are in.
  Part Innermost(Part part) const;
  /// The term of an innermost part; none when it is not made yet.
  TermId FindPart(const Part& part) const;
  template <class Visit>
  void ForEachPartBelow(const Part& part, Visit&& visit) const;
  TermId ExtractNew(TermId a, uint8_t low, uint8_t width);
  static Term QuestionOf(const Part& part) { return {TermKind::kExtract, part.width, part.of.index, part.low}; }

  /// Finds a term in a list, by open addressing; never walked. Most of the time of an execution goes into this, so it
  /// holds the hashes only, and what is not in the list costs one look.
  class Index {
   public:
    /// Where `keys` has the term; kNowhere.
    uint32_t Find(std::span<const Term> keys, const Term& term) const;
    /// The same; without, the term counts as the next of `keys`, where the caller puts it.
    uint32_t FindOrAdd(std::span<const Term> keys, const Term& term);

    static constexpr uint32_t kNowhere = 0xFFFFFFFF;

   private:
    struct Slot {
      uint32_t hash = 0;
      uint32_t at = kNowhere;
    };
    size_t SlotOf(std::span<const Term> keys, const Term& term, uint32_t hash) const;  // where it is, or would be
    void Grow();

    std::vector<Slot> slots_;  // a power of two; at most three quarters of them are used
    size_t used_ = 0;
  };

  std::vector<Term> terms_;
  Index index_;
  std::vector<Term> extract_questions_;
  std::vector<TermId> extracts_;  // what Extract gave for each of them
  Index extract_index_;
  std::vector<std::string> variables_;
  std::vector<TermFunction> functions_;
  std::unordered_map<std::string, uint32_t> function_index_;
  std::vector<TermId> pool_;
  std::unordered_map<uint64_t, std::vector<uint32_t>> applications_;  // by hash of function and arguments
  TermId zero_, one_;
};

/// The low `width` bits.
constexpr uint64_t Masked(uint64_t value, uint8_t width) {
  return width >= 64 ? value : value & ((uint64_t{1} << width) - 1);
}
/// As two's complement of `width` bits.
constexpr int64_t AsSigned(uint64_t value, uint8_t width) {
  return static_cast<int64_t>(value << (64 - width)) >> (64 - width);
}
/// What an operation of two operands of `width` bits gives; not for kConcat.
uint64_t EvaluateBinary(TermKind kind, uint64_t a, uint64_t b, uint8_t width);

}  // namespace plcxx::terms
