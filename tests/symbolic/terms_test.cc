// Every simplification of terms against plain evaluation: terms are built at random through the functions that
// simplify, beside the values that the same operations give for a few assignments of the variables.
#include "transpiler/symbolic/terms/terms.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::prove {
namespace {

constexpr size_t kAssignments = 8;
using Values = std::array<uint64_t, kAssignments>;

/// A term and what it must be.
struct Expected {
  terms::TermId term;
  uint8_t width = 1;
  Values values{};
};

uint64_t Ones(int width) { return width == 64 ? ~uint64_t{0} : (uint64_t{1} << width) - 1; }

/// The operations once more, as SMT-LIB defines them, by sign and magnitude and bit by bit.
uint64_t Reference(terms::TermKind kind, uint64_t a, uint64_t b, int width) {
  const uint64_t ones = Ones(width), top = uint64_t{1} << (width - 1);
  const bool negative_a = (a & top) != 0, negative_b = (b & top) != 0;
  const uint64_t size_a = negative_a ? (0 - a) & ones : a, size_b = negative_b ? (0 - b) & ones : b;
  const auto negated_if = [ones](bool negative, uint64_t x) { return negative ? (0 - x) & ones : x; };
  const auto shifted = [&](auto source) {
    uint64_t result = 0;
    for (int i = 0; i < width; ++i) result |= (source(i) ? uint64_t{1} : uint64_t{0}) << i;
    return result;
  };
  const auto bit = [a](uint64_t i) { return ((a >> i) & 1) != 0; };
  const auto end = static_cast<uint64_t>(width);
  switch (kind) {
    case terms::TermKind::kAnd:
      return a & b;
    case terms::TermKind::kOr:
      return a | b;
    case terms::TermKind::kXor:
      return a ^ b;
    case terms::TermKind::kAdd:
      return (a + b) & ones;
    case terms::TermKind::kSub:
      return (a - b) & ones;
    case terms::TermKind::kMul:
      return (a * b) & ones;
    case terms::TermKind::kUdiv:
      return b == 0 ? ones : a / b;
    case terms::TermKind::kUrem:
      return b == 0 ? a : a % b;
    case terms::TermKind::kSdiv:
      return negated_if(negative_a != negative_b, size_b == 0 ? ones : size_a / size_b);
    case terms::TermKind::kSrem:
      return negated_if(negative_a, size_b == 0 ? size_a : size_a % size_b);
    case terms::TermKind::kShl:
      return shifted([&](int i) { return static_cast<uint64_t>(i) >= b && bit(static_cast<uint64_t>(i) - b); });
    case terms::TermKind::kLshr:
      return shifted([&](int i) { return b < end && static_cast<uint64_t>(i) + b < end && bit(i + b); });
    case terms::TermKind::kAshr:
      return shifted([&](int i) { return b < end && static_cast<uint64_t>(i) + b < end ? bit(i + b) : negative_a; });
    case terms::TermKind::kEq:
      return a == b ? 1 : 0;
    case terms::TermKind::kUlt:
      return a < b ? 1 : 0;
    case terms::TermKind::kSlt:
      return (a ^ top) < (b ^ top) ? 1 : 0;
    default:
      ADD_FAILURE() << "not an operation of two operands";
      return 0;
  }
}

using Make = terms::TermId (terms::Terms::*)(terms::TermId, terms::TermId);
struct Operation {
  terms::TermKind kind;
  Make make;
};
constexpr Operation kOfWidth[] = {
    {terms::TermKind::kAnd, &terms::Terms::And},   {terms::TermKind::kOr, &terms::Terms::Or},
    {terms::TermKind::kXor, &terms::Terms::Xor},   {terms::TermKind::kAdd, &terms::Terms::Add},
    {terms::TermKind::kSub, &terms::Terms::Sub},   {terms::TermKind::kMul, &terms::Terms::Mul},
    {terms::TermKind::kUdiv, &terms::Terms::Udiv}, {terms::TermKind::kUrem, &terms::Terms::Urem},
    {terms::TermKind::kSdiv, &terms::Terms::Sdiv}, {terms::TermKind::kSrem, &terms::Terms::Srem},
    {terms::TermKind::kShl, &terms::Terms::Shl},   {terms::TermKind::kLshr, &terms::Terms::Lshr},
    {terms::TermKind::kAshr, &terms::Terms::Ashr},
};
constexpr Operation kComparisons[] = {{terms::TermKind::kEq, &terms::Terms::Eq},
                                      {terms::TermKind::kUlt, &terms::Terms::Ult},
                                      {terms::TermKind::kSlt, &terms::Terms::Slt}};

class RandomTerms {
 public:
  explicit RandomTerms(uint64_t seed) : random_(seed) {}

  terms::Terms& terms() { return terms_; }
  const std::vector<Expected>& made() const { return made_; }
  /// By number of the variable, for one assignment.
  std::vector<uint64_t> Variables(size_t assignment) const {
    std::vector<uint64_t> values;
    for (const Values& variable : variables_) values.push_back(variable[assignment]);
    return values;
  }

  Expected Term(int width, int depth) {
    // What is there already, so that operands are shared and alike.
    if (Chance(25)) {
      std::vector<const Expected*> alike;
      for (const Expected& one : made_) {
        if (one.width == width) alike.push_back(&one);
      }
      if (!alike.empty()) return *alike[Below(alike.size())];
    }
    Expected result = depth == 0 ? Leaf(width) : Operator(width, depth - 1);
    result.width = static_cast<uint8_t>(width);
    made_.push_back(result);
    return result;
  }

 private:
  uint64_t Below(uint64_t limit) { return random_() % limit; }
  bool Chance(uint64_t percent) { return Below(100) < percent; }
  uint64_t Number(int width) {
    switch (Below(6)) {
      case 0:
        return Below(4) & Ones(width);
      case 1:
        return (0 - Below(4)) & Ones(width);
      case 2:
        return (uint64_t{1} << Below(static_cast<uint64_t>(width))) & Ones(width);
      case 3:
        return Ones(1 + static_cast<int>(Below(static_cast<uint64_t>(width))));
      case 4:
        return (Ones(width) >> 1) + Below(2);
      default:
        return random_() & Ones(width);
    }
  }

  /// Mostly one that is there already, so that terms meet.
  int SomeWidth() {
    if (made_.empty() || Chance(20)) return 1 + static_cast<int>(Below(64));
    return made_[Below(made_.size())].width;
  }

  Expected Leaf(int width) {
    Expected leaf;
    if (Chance(40)) {
      const uint64_t value = Number(width);
      leaf.values.fill(value);
      leaf.term = terms_.Const(value, static_cast<uint8_t>(width));
    } else {
      for (uint64_t& value : leaf.values) value = Number(width);
      leaf.term = terms_.Variable("v" + std::to_string(variables_.size()), static_cast<uint8_t>(width));
      variables_.push_back(leaf.values);
    }
    return leaf;
  }

  template <class Value>
  Expected Made(terms::TermId term, Value&& value) {
    Expected result{.term = term};
    for (size_t i = 0; i < kAssignments; ++i) result.values[i] = value(i);
    return result;
  }

  Expected Operator(int width, int depth) {
    const auto bits = static_cast<uint8_t>(width);
    switch (Below(width == 1 ? 10 : 8)) {
      case 0: {
        const Expected a = Term(width, depth);
        return Made(terms_.Not(a.term), [&](size_t i) { return ~a.values[i] & Ones(width); });
      }
      case 1: {
        const Expected c = Term(1, depth), a = Term(width, depth), b = Term(width, depth);
        return Made(terms_.Ite(c.term, a.term, b.term),
                    [&](size_t i) { return c.values[i] != 0 ? a.values[i] : b.values[i]; });
      }
      case 2: {
        if (width == 1) return Leaf(width);
        const int low = 1 + static_cast<int>(Below(static_cast<uint64_t>(width - 1)));
        const Expected a = Term(width - low, depth), b = Term(low, depth);
        return Made(terms_.Concat(a.term, b.term), [&](size_t i) { return a.values[i] << low | b.values[i]; });
      }
      case 3: {
        const int wide = width + static_cast<int>(Below(static_cast<uint64_t>(65 - width)));
        const int low = static_cast<int>(Below(static_cast<uint64_t>(wide - width + 1)));
        const Expected a = Term(wide, depth);
        return Made(terms_.Extract(a.term, static_cast<uint8_t>(low), bits),
                    [&](size_t i) { return (a.values[i] >> low) & Ones(width); });
      }
      case 4: {
        const int narrow = 1 + static_cast<int>(Below(static_cast<uint64_t>(width)));
        const Expected a = Term(narrow, depth);
        if (Chance(50)) return Made(terms_.Zext(a.term, bits), [&](size_t i) { return a.values[i]; });
        return Made(terms_.Sext(a.term, bits), [&](size_t i) {
          const bool negative = (a.values[i] >> (narrow - 1)) != 0;
          return negative ? (a.values[i] | ~Ones(narrow)) & Ones(width) : a.values[i];
        });
      }
      case 5:
      case 6:
      case 7: {
        const Operation& operation = kOfWidth[Below(std::size(kOfWidth))];
        const Expected a = Term(width, depth), b = Chance(20) ? Leaf(width) : Term(width, depth);
        return Made((terms_.*operation.make)(a.term, b.term),
                    [&](size_t i) { return Reference(operation.kind, a.values[i], b.values[i], width); });
      }
      default: {
        const Operation& operation = kComparisons[Below(std::size(kComparisons))];
        const int operand_width = SomeWidth();
        const Expected a = Term(operand_width, depth), b = Term(operand_width, depth);
        return Made((terms_.*operation.make)(a.term, b.term),
                    [&](size_t i) { return Reference(operation.kind, a.values[i], b.values[i], operand_width); });
      }
    }
  }

  std::mt19937_64 random_;
  terms::Terms terms_;
  std::vector<Values> variables_;
  std::vector<Expected> made_;
};

/// Checks every term that was made, the parts that its making left behind included.
void ExpectAll(RandomTerms& random, uint64_t seed) {
  const terms::Terms& terms = random.terms();
  for (size_t i = 0; i < kAssignments; ++i) {
    const std::vector<uint64_t> values =
        terms::EvaluateAll(terms, random.Variables(i), terms::TermId(terms.size() - 1));
    for (const Expected& expected : random.made()) {
      ASSERT_EQ(terms.Width(expected.term), expected.width) << "seed " << seed;
      ASSERT_EQ(values[expected.term.index], expected.values[i])
          << "seed " << seed << ", assignment " << i << ", term " << expected.term.index;
    }
  }
}

TEST(Terms, MeanWhatTheirOperationsMean) {
  for (uint64_t seed = 1; seed <= 6000; ++seed) {
    RandomTerms random(seed);
    const int width = static_cast<int>(seed % 64) + 1;
    const int depth = static_cast<int>(seed % 7);
    for (int i = 0; i < 4; ++i) random.Term(width, depth);
    ExpectAll(random, seed);
    if (HasFatalFailure()) return;
  }
}

/// All pairs of the forms that the simplifications look for, at a width where every value can be tried.
TEST(Terms, PairsOfAllFormsWithAllValues) {
  constexpr uint8_t kWidth = 4;
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", kWidth), y = terms.Variable("y", 2), bit = terms.Variable("bit", 1);
  std::vector<terms::TermId> forms = {x,
                                      terms.Not(x),
                                      terms.Zext(y, kWidth),
                                      terms.Sext(y, kWidth),
                                      terms.Zext(bit, kWidth),
                                      terms.Sext(bit, kWidth),
                                      terms.Concat(y, terms.Const(0, 2)),
                                      terms.Concat(y, terms.Const(2, 2)),
                                      terms.Concat(terms.Const(1, 2), y),
                                      terms.Concat(y, y),
                                      terms.Concat(bit, terms.Extract(x, 0, 3)),
                                      terms.Ite(bit, x, terms.Zext(y, kWidth)),
                                      terms.Ite(bit, terms.Const(3, kWidth), terms.Const(9, kWidth)),
                                      terms.Ite(terms.Extract(y, 0, 1), x, terms.Const(6, kWidth)),
                                      terms.Ite(terms.Extract(x, 0, 1), terms.Const(1, kWidth), terms.Zext(y, kWidth)),
                                      terms.Ite(terms.And(bit, terms.Extract(y, 0, 1)), x, terms.Sext(y, kWidth)),
                                      terms.Ite(terms.Or(bit, terms.Extract(x, 0, 1)), terms.Sext(y, kWidth), x),
                                      terms.Add(x, terms.Const(3, kWidth)),
                                      terms.Xor(x, terms.Const(5, kWidth)),
                                      terms.Sub(x, terms.Sext(y, kWidth)),
                                      terms.And(x, terms.Sext(y, kWidth)),
                                      terms.Or(x, terms.Sext(y, kWidth))};
  for (uint64_t value = 0; value < 16; ++value) forms.push_back(terms.Const(value, kWidth));
  for (uint8_t high = 0; high < 3; ++high) {
    for (uint8_t low = 0; low < 3; ++low)
      forms.push_back(terms.Concat(terms.Extract(x, high, 2), terms.Extract(x, low, 2)));
  }
  struct Pair {
    terms::TermId result;
    terms::TermKind kind;
    terms::TermId a, b;
  };
  std::vector<Pair> pairs;
  struct Choice {
    terms::TermId result, condition, then, otherwise;
  };
  std::vector<Choice> choices;
  const terms::TermId low_x = terms.Extract(x, 0, 1), low_y = terms.Extract(y, 0, 1);
  const std::array conditions = {bit,
                                 terms.Not(bit),
                                 terms.Eq(x, terms.Zext(y, kWidth)),
                                 low_y,
                                 terms.And(bit, low_y),
                                 terms.Or(low_x, low_y),
                                 terms.And(terms.Not(low_x), bit),
                                 terms.Or(terms.Not(low_y), terms.And(low_x, bit))};
  for (const terms::TermId a : forms) {
    for (const terms::TermId b : forms) {
      for (const Operation& operation : kOfWidth)
        pairs.push_back({(terms.*operation.make)(a, b), operation.kind, a, b});
      for (const Operation& operation : kComparisons) {
        pairs.push_back({(terms.*operation.make)(a, b), operation.kind, a, b});
      }
      pairs.push_back({terms.Concat(a, b), terms::TermKind::kConcat, a, b});
      for (const terms::TermId condition : conditions) {
        choices.push_back({terms.Ite(condition, a, b), condition, a, b});
        const terms::TermId bit_a = terms.Extract(a, 1, 1), bit_b = terms.Extract(b, 1, 1);
        choices.push_back({terms.Ite(condition, bit_a, bit_b), condition, bit_a, bit_b});
      }
    }
  }
  struct Slice {
    terms::TermId result, of;
    uint8_t low, width;
  };
  std::vector<Slice> slices;
  for (size_t i = 0; i < pairs.size(); i += 3) {
    const uint8_t width = terms.Width(pairs[i].result);
    const auto low = static_cast<uint8_t>(i / 3 % width);
    const auto count = static_cast<uint8_t>(1 + i / 7 % static_cast<size_t>(width - low));
    slices.push_back({terms.Extract(pairs[i].result, low, count), pairs[i].result, low, count});
  }
  for (uint64_t assignment = 0; assignment < 128; ++assignment) {
    const std::array variables = {assignment & 15, (assignment >> 4) & 3, assignment >> 6};
    const std::vector<uint64_t> values = terms::EvaluateAll(terms, variables, terms::TermId(terms.size() - 1));
    const auto value = [&](terms::TermId id) { return values[id.index]; };
    for (const Pair& pair : pairs) {
      const uint64_t a = value(pair.a), b = value(pair.b);
      const uint64_t expected =
          pair.kind == terms::TermKind::kConcat ? a << kWidth | b : Reference(pair.kind, a, b, kWidth);
      ASSERT_EQ(value(pair.result), expected)
          << static_cast<int>(pair.kind) << " of terms " << pair.a.index << " and " << pair.b.index;
    }
    for (const Choice& choice : choices) {
      ASSERT_EQ(value(choice.result), value(choice.condition) != 0 ? value(choice.then) : value(choice.otherwise));
    }
    for (const Slice& slice : slices) {
      ASSERT_EQ(value(slice.result), (value(slice.of) >> slice.low) & Ones(slice.width));
    }
  }
}

TEST(Terms, RowsOfAnyTwoParts) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 6);
  const auto of_each_part = [](auto visit) {
    for (uint8_t low = 0; low < 6; ++low) {
      for (uint8_t width = 1; low + width <= 6; ++width) visit(low, width);
    }
  };
  of_each_part([&](uint8_t high, uint8_t high_width) {
    of_each_part([&](uint8_t low, uint8_t low_width) {
      const terms::TermId row = terms.Concat(terms.Extract(x, high, high_width), terms.Extract(x, low, low_width));
      for (uint64_t value = 0; value < 64; ++value) {
        ASSERT_EQ(terms::Evaluate(terms, row, {&value, 1}),
                  ((value >> high) & Ones(high_width)) << low_width | ((value >> low) & Ones(low_width)));
      }
    });
  });
}

TEST(Terms, RebuiltTermsAreTheSameOnes) {
  for (uint64_t seed = 1; seed <= 2000; ++seed) {
    RandomTerms random(seed);
    for (int i = 0; i < 4; ++i) random.Term(1 + static_cast<int>((seed * 7 + static_cast<uint64_t>(i)) % 64), 4);
    terms::Terms& terms = random.terms();
    const uint32_t count = terms.size();
    for (uint32_t i = 0; i < count; ++i) {
      const terms::Term term = terms[terms::TermId(i)];
      std::vector<terms::TermId> operands;
      terms.ForEachOperand(term, [&](terms::TermId operand) { operands.push_back(operand); });
      ASSERT_EQ(terms.Rebuild(term, operands), terms::TermId(i))
          << "seed " << seed << ", kind " << static_cast<int>(term.kind);
    }
  }
}

TEST(Terms, RebuildWithOtherOperandsIsSubstitution) {
  for (uint64_t seed = 1; seed <= 1000; ++seed) {
    RandomTerms random(seed);
    for (int i = 0; i < 3; ++i) random.Term(1 + static_cast<int>(seed % 64), 5);
    terms::Terms& terms = random.terms();
    // Constants in place of the variables: everything must become a constant, the right one.
    for (size_t assignment = 0; assignment < 2; ++assignment) {
      const std::vector<uint64_t> variables = random.Variables(assignment);
      std::vector<terms::TermId> replaced;
      const uint32_t count = terms.size();
      for (uint32_t i = 0; i < count; ++i) {
        const terms::Term term = terms[terms::TermId(i)];
        if (term.kind == terms::TermKind::kVariable) {
          replaced.push_back(terms.Const(variables[term.a], term.width));
          continue;
        }
        std::vector<terms::TermId> operands;
        terms.ForEachOperand(term, [&](terms::TermId operand) { operands.push_back(replaced[operand.index]); });
        replaced.push_back(terms.Rebuild(term, operands));
      }
      for (const Expected& expected : random.made()) {
        const terms::TermId result = replaced[expected.term.index];
        ASSERT_TRUE(terms.IsConst(result)) << "seed " << seed;
        ASSERT_EQ(terms.Value(result), expected.values[assignment]) << "seed " << seed;
      }
    }
  }
}

TEST(Terms, EqualConstructionsAreOneTerm) {
  const auto build = [](terms::Terms& terms, terms::TermId x, terms::TermId y) {
    const terms::TermId sum = terms.Add(terms.And(x, y), terms.Mul(x, terms.Const(8, 32)));
    const terms::FunctionId unknown = terms.Function("unknown", 32);
    const std::array arguments{sum, terms.Not(y)};
    return terms.Ite(terms.Ult(x, y), terms.Apply(unknown, arguments), terms.Shl(sum, y));
  };
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 32), y = terms.Variable("y", 32);
  const terms::TermId first = build(terms, x, y);
  const uint32_t count = terms.size();
  EXPECT_EQ(build(terms, x, y), first);
  EXPECT_EQ(terms.size(), count);
  EXPECT_EQ(terms.And(x, y), terms.And(y, x));
  EXPECT_EQ(terms.Add(x, terms.Add(y, x)), terms.Add(terms.Add(x, y), x));
}

TEST(Terms, PartsOfMaskedWordsAreParts) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 32), bit = terms.Variable("bit", 1), other = terms.Variable("other", 1);
  EXPECT_EQ(terms.And(x, terms.Const(0xFF, 32)), terms.Zext(terms.Extract(x, 0, 8), 32));
  EXPECT_EQ(terms.Ne(terms.And(x, terms.Const(0x10, 32)), terms.Const(0, 32)), terms.Extract(x, 4, 1));
  // Signals that are kept as bytes.
  const terms::TermId byte = terms.Zext(bit, 8), another = terms.Zext(other, 8);
  EXPECT_EQ(terms.And(byte, another), terms.Zext(terms.And(bit, other), 8));
  EXPECT_EQ(terms.Or(byte, another), terms.Zext(terms.Or(bit, other), 8));
  EXPECT_EQ(terms.Xor(byte, terms.Const(1, 8)), terms.Zext(terms.Not(bit), 8));
  EXPECT_EQ(terms.Ne(terms.And(byte, another), terms.Const(0, 8)), terms.And(bit, other));
}

/// Branches in branches, as a program writes them, and as a compiler joins them: all at once, each under all that leads
/// to it, and with what their operations have of constants computed before.
TEST(Terms, BranchesInBranchesAreOneTerm) {
  terms::Terms terms;
  const terms::TermId one = terms.Variable("one", 1), two = terms.Variable("two", 1);
  const terms::TermId x = terms.Variable("x", 32), y = terms.Variable("y", 32), z = terms.Variable("z", 32);
  const terms::TermId zero = terms.Const(0, 32), thousand = terms.Const(1000, 32), both = terms.And(one, two);
  const terms::TermId nested = terms.Ite(one, terms.Ite(two, x, y), z);
  EXPECT_EQ(terms.Ite(both, x, terms.Ite(one, y, z)), nested);
  EXPECT_EQ(terms.Ite(both, terms.Ite(one, x, z), terms.Ite(one, y, z)), nested);
  EXPECT_EQ(terms.Ite(terms.Or(one, two), terms.Ite(one, x, y), z), terms.Ite(one, x, terms.Ite(two, y, z)));
  EXPECT_EQ(terms.Ite(one, two, both), both);
  EXPECT_EQ(terms.Ite(one, terms.Ite(both, x, y), z), nested);
  const terms::TermId chosen = terms.Ite(one, x, zero);
  EXPECT_EQ(terms.Udiv(chosen, thousand), terms.Ite(one, terms.Udiv(x, thousand), zero));
  EXPECT_EQ(terms.Srem(chosen, thousand), terms.Ite(one, terms.Srem(x, thousand), zero));
  EXPECT_EQ(terms.Neg(chosen), terms.Ite(one, terms.Neg(x), zero));
  EXPECT_EQ(terms.Add(chosen, thousand), terms.Ite(one, terms.Add(x, thousand), thousand));
}

/// A table of constants stays a table: a long row of choices is not made anew for each operation, nor on the
/// processor's stack.
TEST(Terms, LongRowsOfChoicesAreKept) {
  terms::Terms terms;
  const terms::TermId index = terms.Variable("index", 32);
  terms::TermId row = terms.Const(0, 32);
  for (uint64_t i = 0; i < 100'000; ++i)
    row = terms.Ite(terms.Eq(index, terms.Const(i, 32)), terms.Const(i * 7 % 1000, 32), row);
  const uint32_t before = terms.size();
  const terms::TermId sum = terms.Add(row, terms.Const(1, 32));
  EXPECT_EQ(terms[sum].kind, terms::TermKind::kAdd);
  EXPECT_LE(terms.size() - before, 2U);
}

// The magnitude of a magnitude is that magnitude, of the lowest number, too.
TEST(Terms, MagnitudesOfMagnitudesAreOneTerm) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 8);
  const auto sign = [&](terms::TermId of) { return terms.Extract(of, 7, 1); };
  const auto magnitude = [&](terms::TermId of) { return terms.Ite(sign(of), terms.Neg(of), of); };
  const terms::TermId once = magnitude(x);
  EXPECT_EQ(magnitude(once), once);
  EXPECT_EQ(terms.Neg(terms.Neg(x)), x);
  EXPECT_EQ(terms.Neg(terms.Neg(once)), once);
  for (uint64_t value = 0; value < 256; ++value) {
    const uint64_t size = value < 128 ? value : 256 - value;
    EXPECT_EQ(terms::Evaluate(terms, once, {&value, 1}), size);
    EXPECT_EQ(terms::Evaluate(terms, terms.Neg(once), {&value, 1}), (256 - size) & 255);
  }
}

/// As C divides, and as a program says it that means no other thing for the least number divided by -1.
TEST(Terms, SignedQuotientsByConstantsAreThoseOfMagnitudes) {
  terms::Terms terms;
  const terms::TermId x = terms.Variable("x", 8);
  const terms::TermId is_negative = terms.Extract(x, 7, 1);
  const terms::TermId magnitude = terms.Ite(is_negative, terms.Neg(x), x);
  const auto with_sign = [&](terms::TermId of) { return terms.Ite(is_negative, terms.Neg(of), of); };
  for (int divisor = 1; divisor < 128; ++divisor) {
    const terms::TermId by = terms.Const(static_cast<uint64_t>(divisor), 8);
    const terms::TermId quotient = terms.Sdiv(x, by), rest = terms.Srem(x, by);
    EXPECT_EQ(quotient, with_sign(terms.Udiv(magnitude, by)));
    EXPECT_EQ(rest, with_sign(terms.Urem(magnitude, by)));
    for (uint64_t value = 0; value < 256; ++value) {
      const int number = static_cast<int8_t>(value);
      EXPECT_EQ(terms::Evaluate(terms, quotient, {&value, 1}), static_cast<uint8_t>(number / divisor));
      EXPECT_EQ(terms::Evaluate(terms, rest, {&value, 1}), static_cast<uint8_t>(number % divisor));
    }
  }
}

/// One product or quotient of a choice, in place of a choice of two, where an operand is the same.
TEST(Terms, ChoicesOfOperationsAreOperationsOfChoices) {
  terms::Terms terms;
  constexpr uint8_t kWidth = 3;
  const terms::TermId c = terms.Variable("c", 1);
  const std::array numbers = {terms.Variable("x", kWidth), terms.Variable("y", kWidth), terms.Variable("z", kWidth)};
  const auto [x, y, z] = numbers;
  const terms::TermId chosen = terms.Ite(c, x, y);
  EXPECT_EQ(terms.Ite(c, terms.Mul(x, z), terms.Mul(z, y)), terms.Mul(chosen, z));
  EXPECT_EQ(terms.Ite(c, terms.Mul(x, y), terms.Mul(z, x)), terms.Mul(x, terms.Ite(c, y, z)));
  EXPECT_EQ(terms.Ite(c, terms.Sdiv(x, z), terms.Sdiv(y, z)), terms.Sdiv(chosen, z));
  EXPECT_EQ(terms.Ite(c, terms.Urem(z, x), terms.Urem(z, y)), terms.Urem(z, chosen));
  // A constant is left where it is: it costs far less than a factor that is chosen.
  const terms::TermId three = terms.Const(3, kWidth), five = terms.Const(5, kWidth);
  const terms::TermId kept = terms.Ite(c, terms.Mul(x, three), terms.Mul(x, five));
  EXPECT_EQ(terms[kept].kind, terms::TermKind::kIte);
  // Whatever is made of them means the same, parts and constants included.
  const std::array operands = {x, y, z, three, terms.Const(6, kWidth)};
  for (const Operation& row : kOfWidth) {
    for (const terms::TermId a : operands) {
      for (const terms::TermId b : operands) {
        for (const terms::TermId d : operands) {
          const terms::TermId one = (terms.*row.make)(a, b), other = (terms.*row.make)(d, b);
          const terms::TermId third = (terms.*row.make)(b, d);
          for (const auto& [then, otherwise] : {std::pair(one, other), std::pair(one, third), std::pair(third, one)}) {
            const terms::TermId choice = terms.Ite(c, then, otherwise);
            for (uint64_t number = 0; number < 1024; number += 7) {
              const std::array<uint64_t, 4> values = {number & 1, number >> 1 & 7, number >> 4 & 7, number >> 7 & 7};
              ASSERT_EQ(terms::Evaluate(terms, choice, values),
                        terms::Evaluate(terms, values[0] != 0 ? then : otherwise, values));
            }
          }
        }
      }
    }
  }
}

TEST(Terms, UnknownFunctionsAreFunctions) {
  terms::Terms terms;
  const terms::FunctionId f = terms.Function("f", 16), g = terms.Function("g", 16);
  const terms::TermId x = terms.Variable("x", 8);
  const terms::TermId applied = terms.Apply(f, {&x, 1});
  EXPECT_EQ(terms.Apply(f, {&x, 1}), applied);
  EXPECT_NE(terms.Apply(g, {&x, 1}), applied);
  EXPECT_EQ(terms.Function("f", 16), f);
  const uint64_t one = 1, two = 2;
  EXPECT_EQ(terms::Evaluate(terms, applied, {&one, 1}), terms::Evaluate(terms, applied, {&one, 1}));
  EXPECT_NE(terms::Evaluate(terms, applied, {&one, 1}), terms::Evaluate(terms, applied, {&two, 1}));
  EXPECT_LE(terms::Evaluate(terms, applied, {&one, 1}), 0xFFFFU);
}

// Arguments may be those of another application, which stand where the new ones are put.
TEST(Terms, ArgumentsMayBeThoseOfAnotherTerm) {
  terms::Terms terms;
  const terms::FunctionId f = terms.Function("f", 8), g = terms.Function("g", 8);
  std::vector<terms::TermId> arguments;
  for (int i = 0; i < 100; ++i) arguments.push_back(terms.Variable("v" + std::to_string(i), 8));
  terms::TermId last = terms.Apply(f, arguments);
  for (int i = 0; i < 50; ++i) {
    last = terms.Apply(terms.Function("h" + std::to_string(i), 8), terms.Arguments(terms[last]));
  }
  const terms::TermId again = terms.Apply(g, terms.Arguments(terms[last]));
  ASSERT_EQ(terms.Arguments(terms[again]).size(), arguments.size());
  for (size_t i = 0; i < arguments.size(); ++i) EXPECT_EQ(terms.Arguments(terms[again])[i], arguments[i]);
}

}  // namespace
}  // namespace plcxx::prove
