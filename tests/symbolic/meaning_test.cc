// Every row of ops.def as terms against the function of runtime_support, which was written for itself: by concrete
// evaluation of the terms, over variables and over constants.
#include "transpiler/symbolic/meaning/meaning.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

// The functions by name, those of the rows without a header first.
#include "plcxx/bcd.h"
#include "plcxx/c_integers.h"
#include "plcxx/doubles.h"
#include "plcxx/floats.h"
#include "plcxx/logic.h"
#include "plcxx/registers.h"
#include "plcxx/rings.h"
#include "transpiler/sim/evaluate.h"
#include "transpiler/sim/instances.h"
#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::prove {
namespace {

using namespace sim::operand_types;
using Vector = std::vector<uint64_t>;

/// One row: the runtime's function on raw operands. A step works on the fields, in the order of the table.
struct RuntimeRow {
  ir::OpKind op;
  std::function<uint64_t(Vector& fields, const Vector& operands)> call;
};

// --- fields of the runtime's structs ------------------------------------------------------------------------------

template <class Field, class Visit>
void VisitElements(Field& field, Visit&& visit) {
  if constexpr (std::is_array_v<Field>) {
    for (auto& element : field) visit(element);
  } else {
    visit(field);
  }
}

template <class State, class Visit>
void ForEachField(State& state, Visit&& visit) {
#define PLCXX_STATE(...)
#define PLCXX_FIELD(Kind, Field, ...) \
  if constexpr (std::is_same_v<State, plcxx::Kind>) VisitElements(state.Field, visit);
#define PLCXX_HIDDEN(Kind, Field, ...) \
  if constexpr (std::is_same_v<State, plcxx::Kind>) VisitElements(state.Field, visit);
#include "transpiler/ir/states.def"
#undef PLCXX_STATE
#undef PLCXX_FIELD
#undef PLCXX_HIDDEN
}

template <class State>
State FromFields(const Vector& fields) {
  State state{};
  size_t i = 0;
  ForEachField(state, [&](auto& field) { field = static_cast<std::remove_cvref_t<decltype(field)>>(fields[i++]); });
  return state;
}

template <class State>
Vector ToFields(State state) {
  Vector fields;
  ForEachField(state, [&](const auto& field) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(field)>, char>) {
      fields.push_back(static_cast<unsigned char>(field));
    } else {
      fields.push_back(static_cast<uint64_t>(field));
    }
  });
  return fields;
}

template <class Signature, class Function>
uint64_t Call(const Vector& operands, Function&& function) {
  return sim::Apply(std::type_identity<Signature>{}, [&](size_t i) { return operands[i]; }, function);
}

const std::vector<RuntimeRow>& PureRows() {
  static const std::vector<RuntimeRow> kRows = {
#define PLCXX_PURE(Kind, Text, Operands, Result, Spelling, Precedence, Function, Cost)                \
  {ir::OpKind::k##Kind, [](Vector&, const Vector& operands) {                                         \
     return Call<Result Operands>(operands, [](auto... value) { return plcxx::Function(value...); }); \
   }},
#define PLCXX_STEP(...)
#define PLCXX_CORE(...)
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
  };
  return kRows;
}

const std::vector<RuntimeRow>& StepRows() {
  static const std::vector<RuntimeRow> kRows = {
#define PLCXX_PURE(...)
#define PLCXX_STEP(Kind, Text, State, Operands, Result, Spelling, Function, Cost)                          \
  {ir::OpKind::k##Kind, [](Vector& fields, const Vector& operands) {                                       \
     auto state = FromFields<plcxx::State>(fields);                                                        \
     const uint64_t result =                                                                               \
         Call<Result Operands>(operands, [&](auto... value) { return plcxx::Function(state, value...); }); \
     fields = ToFields(state);                                                                             \
     return result;                                                                                        \
   }},
#define PLCXX_CORE(...)
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
  };
  return kRows;
}

// --- values that are worth trying ---------------------------------------------------------------------------------

class RandomNumbers {
 public:
  uint64_t Of(ir::Type type) {
    switch (type) {
      case ir::Type::kF32:
        return std::bit_cast<uint32_t>(static_cast<float>(Float(23, 31))) ^ (Below(8) == 0 ? Below(2) : 0);
      case ir::Type::kF64:
        return std::bit_cast<uint64_t>(Float(52, 63)) ^ (Below(8) == 0 ? Below(2) : 0);
      case ir::Type::kNone:
        return 0;
      case ir::Type::kBit:
      case ir::Type::kI8:
      case ir::Type::kI16:
      case ir::Type::kI32:
      case ir::Type::kI64:
        break;
    }
    return terms::Masked(Integer(meaning::WidthOf(type)), meaning::WidthOf(type));
  }

  uint64_t Below(uint64_t limit) { return random_() % limit; }

 private:
  uint64_t Integer(uint8_t width) {
    const uint64_t top = uint64_t{1} << (width - 1);
    switch (Below(9)) {
      case 0:
        return Below(4);
      case 1:
        return 0 - Below(4);
      case 2:
        return top - 1 + Below(3);
      case 3:
        return Below(41);  // counts of shifts
      case 4:
        return uint64_t{1} << Below(width);
      case 5: {
        uint64_t digits = 0;
        for (int i = 0; i < 16; ++i) digits = digits << 4 | Below(Below(4) == 0 ? 16 : 10);
        return digits >> 4 * Below(16);
      }
      case 6:
        return std::array<uint64_t, 12>{
                   99, 100, 199, 255, 256, 999, 1000, 9999, 10000, 60000, 65535, 80'000'000}[Below(12)] *
               (Below(3) == 0 ? ~uint64_t{0} : 1);
      case 7:
        return last_ + Below(3) - 1;  // near the one before
      default:
        return last_ = random_();
    }
  }

  /// Where a format ends to have fractions, and where an integer ends.
  double Float(int fraction_bits, int integer_bits) {
    const double sign = Below(2) == 0 ? 1.0 : -1.0;
    switch (Below(10)) {
      case 0:
        return sign * std::array{0.0, 0.5, 1.0, 1.5, 2.5, 0.49999997, 4e9, 1e-310, 1e300, 3e38}[Below(10)];
      case 1:
        return sign * std::array{INFINITY, NAN, 1e-40F, 3.4e38F}[Below(4)];
      case 2:
        return sign * (std::ldexp(1.0, fraction_bits) + static_cast<double>(Below(5)) / 2.0 - 1.0);
      case 3:
        return sign * (std::ldexp(1.0, integer_bits) + static_cast<double>(Below(3)) * 1024.0 - 1024.0);
      case 4:
        return sign * static_cast<double>(Below(100)) / 2.0;
      case 5:
        return sign * static_cast<double>(Below(100000)) / 1000.0;
      case 6:
        return sign * std::ldexp(static_cast<double>(random_() >> 12), static_cast<int>(Below(80)) - 60);
      case 7:
        return last_float_;
      case 8:
        return std::bit_cast<double>(random_());
      default:
        return last_float_ = static_cast<double>(std::bit_cast<float>(static_cast<uint32_t>(random_())));
    }
  }

  std::mt19937_64 random_{20};
  uint64_t last_ = 0;
  double last_float_ = 1.0;
};

/// What must be equal of a value: which NaN it is does not count.
uint64_t Comparable(uint64_t value, ir::Type type) {
  if (type == ir::Type::kF32 && std::isnan(std::bit_cast<float>(static_cast<uint32_t>(value)))) return 0x7FC00000;
  if (type == ir::Type::kF64 && std::isnan(std::bit_cast<double>(value))) return 0x7FF8000000000000;
  return value;
}

std::vector<ir::Type> OperandTypes(ir::OpKind op) {
  const ir::OpInfo& info = ir::Info(op);
  return {info.operands, info.operands + info.operand_count};
}

std::string Text(const Vector& values) {
  std::string text;
  for (const uint64_t value : values) text += " " + std::to_string(value);
  return text;
}

std::vector<terms::TermId> Variables(terms::Terms& terms, const std::vector<ir::Type>& types) {
  std::vector<terms::TermId> variables;
  for (const ir::Type type : types) variables.push_back(terms.Variable("operand", meaning::WidthOf(type)));
  return variables;
}

std::vector<terms::TermId> Constants(terms::Terms& terms, const std::vector<ir::Type>& types, const Vector& values) {
  std::vector<terms::TermId> constants;
  for (size_t i = 0; i < types.size(); ++i) constants.push_back(terms.Const(values[i], meaning::WidthOf(types[i])));
  return constants;
}

// --- pure operations ----------------------------------------------------------------------------------------------

class PureMeaning {
 public:
  explicit PureMeaning(const RuntimeRow& row)
      : row_(row), types_(OperandTypes(row.op)), result_(ir::Info(row.op).result) {
    term_ = meaning::MeaningOf(terms_, row.op, Variables(terms_, types_));
  }

  const std::vector<ir::Type>& types() const { return types_; }
  void ExpectWidth() const { EXPECT_EQ(terms_.Width(term_), meaning::WidthOf(result_)); }
  void Expect(const Vector& operands) {
    Vector none;
    const uint64_t expected = Comparable(row_.call(none, operands), result_);
    ASSERT_EQ(Comparable(terms::Evaluate(terms_, term_, operands), result_), expected)
        << ir::Info(row_.op).text << " of" << Text(operands);
  }
  void ExpectOfConstants(const Vector& operands) {
    Vector none;
    const terms::TermId result = meaning::MeaningOf(terms_, row_.op, Constants(terms_, types_, operands));
    ASSERT_TRUE(terms_.IsConst(result)) << ir::Info(row_.op).text << " of" << Text(operands);
    ASSERT_EQ(Comparable(terms_.Value(result), result_), Comparable(row_.call(none, operands), result_))
        << ir::Info(row_.op).text << " of the constants" << Text(operands);
  }

 private:
  const RuntimeRow& row_;
  std::vector<ir::Type> types_;
  ir::Type result_;
  terms::Terms terms_;
  terms::TermId term_;
};

TEST(Meaning, OfPureOperationsIsThatOfTheRuntime) {
  RandomNumbers numbers;
  for (const RuntimeRow& row : PureRows()) {
    PureMeaning meaning(row);
    meaning.ExpectWidth();
    for (int i = 0; i < 3000; ++i) {
      Vector operands;
      for (const ir::Type type : meaning.types()) operands.push_back(numbers.Of(type));
      meaning.Expect(operands);
      if (i < 300) meaning.ExpectOfConstants(operands);
      if (testing::Test::HasFatalFailure()) break;
    }
  }
}

TEST(Meaning, OfPureOperationsForAllOperandsOfOneOrTwoBytes) {
  for (const RuntimeRow& row : PureRows()) {
    PureMeaning meaning(row);
    uint32_t bits = 0;
    for (const ir::Type type : meaning.types()) bits += meaning::WidthOf(type);
    if (bits > 16) continue;
    for (uint64_t all = 0; all < uint64_t{1} << bits; ++all) {
      Vector operands;
      uint64_t rest = all;
      for (const ir::Type type : meaning.types()) {
        operands.push_back(terms::Masked(rest, meaning::WidthOf(type)));
        rest >>= meaning::WidthOf(type);
      }
      meaning.Expect(operands);
      if (testing::Test::HasFatalFailure()) break;
    }
  }
}

// --- steps --------------------------------------------------------------------------------------------------------

std::vector<ir::Type> FieldTypes(ir::StateKind kind) {
  std::vector<ir::Type> types;
  for (const ir::FieldInfo& field : ir::Info(kind).fields) types.insert(types.end(), field.count, field.type);
  return types;
}

class StepMeanings {
 public:
  explicit StepMeanings(const RuntimeRow& row)
      : row_(row), kind_(*ir::Info(row.op).state), operand_types_(OperandTypes(row.op)), types_(FieldTypes(kind_)) {
    fields_ = Variables(terms_, types_);
    result_ = meaning::StepMeaning(terms_, row.op, fields_, Variables(terms_, operand_types_));
  }

  ir::StateKind kind() const { return kind_; }
  const std::vector<ir::Type>& types() const { return types_; }
  const std::vector<ir::Type>& operand_types() const { return operand_types_; }
  void ExpectShape() const {
    EXPECT_EQ(meaning::FieldTerms(kind_), types_.size());
    for (size_t i = 0; i < types_.size(); ++i) EXPECT_EQ(terms_.Width(fields_[i]), meaning::WidthOf(types_[i]));
    const ir::Type result = ir::Info(row_.op).result;
    EXPECT_EQ(result_.valid(), result != ir::Type::kNone) << ir::Info(row_.op).text;
    if (!result_.valid()) return;
    EXPECT_EQ(terms_.Width(result_), meaning::WidthOf(result)) << ir::Info(row_.op).text;
  }

  /// Steps both, the runtime's instance being `fields`.
  void Step(Vector& fields, const Vector& operands) {
    Vector variables = fields;
    variables.insert(variables.end(), operands.begin(), operands.end());
    const Vector before = fields;
    const uint64_t expected = row_.call(fields, operands);
    const std::vector<uint64_t> values = terms::EvaluateAll(terms_, variables, terms::TermId(terms_.size() - 1));
    for (size_t i = 0; i < types_.size(); ++i) {
      ASSERT_EQ(values[fields_[i].index], fields[i])
          << ir::Info(row_.op).text << " of" << Text(operands) << ": field " << i << " behind" << Text(before);
    }
    if (result_.valid()) {
      ASSERT_EQ(values[result_.index], expected)
          << ir::Info(row_.op).text << " of" << Text(operands) << ": result behind" << Text(before);
    }
  }

 private:
  const RuntimeRow& row_;
  ir::StateKind kind_;
  std::vector<ir::Type> operand_types_, types_;
  terms::Terms terms_;
  std::vector<terms::TermId> fields_;
  terms::TermId result_;
};

// From any fields: no restriction to those that a program can reach.
TEST(Meaning, OfStepsIsThatOfTheRuntime) {
  RandomNumbers numbers;
  for (const RuntimeRow& row : StepRows()) {
    StepMeanings meaning(row);
    meaning.ExpectShape();
    for (int i = 0; i < 800; ++i) {
      Vector fields;
      for (const ir::Type type : meaning.types()) fields.push_back(numbers.Of(type));
      for (int step = 0; step < 5; ++step) {
        Vector operands;
        for (const ir::Type type : meaning.operand_types()) operands.push_back(numbers.Of(type));
        meaning.Step(fields, operands);
        if (HasFatalFailure()) return;
      }
    }
  }
}

// From power-on, with presets and periods in the range of programs: the long way through a delay or round a ring, all
// operations of the kind mixed.
TEST(Meaning, OfStepsInTheirOrdinaryCourse) {
  RandomNumbers numbers;
  for (uint32_t kind = 0; kind < ir::StateKindCount(); ++kind) {
    std::vector<StepMeanings> meanings;
    for (const RuntimeRow& row : StepRows()) {
      if (*ir::Info(row.op).state == static_cast<ir::StateKind>(kind)) meanings.emplace_back(row);
    }
    if (meanings.empty()) continue;
    for (int run = 0; run < 30; ++run) {
      Vector fields(meaning::FieldTerms(static_cast<ir::StateKind>(kind)));
      Vector operands(3);
      StepMeanings* meaning = &meanings[numbers.Below(meanings.size())];
      for (int step = 0; step < 200; ++step) {
        if (numbers.Below(6) == 0) meaning = &meanings[numbers.Below(meanings.size())];
        Vector next;
        for (size_t i = 0; i < meaning->operand_types().size(); ++i) {
          const ir::Type type = meaning->operand_types()[i];
          const uint64_t near = i < operands.size() ? operands[i] + numbers.Below(40) : 0;
          next.push_back(terms::Masked(type == ir::Type::kBit  ? numbers.Below(4)
                                       : numbers.Below(3) == 0 ? near
                                                               : 5 * i,
                                       meaning::WidthOf(type)));
        }
        operands = next;
        meaning->Step(fields, operands);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(Meaning, FieldsStandWhereTheTableHasThem) {
  for (uint32_t i = 0; i < ir::StateKindCount(); ++i) {
    const auto kind = static_cast<ir::StateKind>(i);
    const auto& fields = ir::Info(kind).fields;
    uint32_t index = 0;
    for (uint8_t field = 0; field < fields.size(); ++field) {
      EXPECT_EQ(meaning::FieldTermIndex(kind, field), index);
      index += fields[field].count;
    }
    EXPECT_EQ(meaning::FieldTerms(kind), index);
  }
}

TEST(Meaning, OfTextsIsThatOfTheRuntime) {
  RandomNumbers numbers;
  const std::string longest(32, 'x'), too_long(33, 'x');
  for (const std::string& text : {std::string(), std::string("A"), std::string("TEXT\xFF"), longest, too_long}) {
    terms::Terms terms;
    const std::vector<ir::Type> flag_types = FieldTypes(ir::StateKind::kTextFlag);
    const std::vector<ir::Type> inbox_types = FieldTypes(ir::StateKind::kTextInbox);
    std::vector<terms::TermId> flag = Variables(terms, flag_types), inbox = Variables(terms, inbox_types);
    const std::vector<terms::TermId> inbox_before = inbox;
    meaning::UpdateTextMeaning(terms, flag, inbox, text);
    EXPECT_EQ(inbox, inbox_before);
    for (int i = 0; i < 3000; ++i) {
      Vector flag_fields, inbox_fields;
      for (const ir::Type type : flag_types) flag_fields.push_back(numbers.Of(type));
      for (const ir::Type type : inbox_types) inbox_fields.push_back(numbers.Of(type));
      // Mostly the text itself, or nearly.
      const size_t length = numbers.Below(4) == 0 ? numbers.Below(256) : text.size();
      inbox_fields[32] = length;
      for (size_t at = 0; at < text.size() && at < 32; ++at) inbox_fields[at] = static_cast<unsigned char>(text[at]);
      if (numbers.Below(3) == 0) inbox_fields[numbers.Below(32)] ^= 1;
      Vector variables = flag_fields;
      variables.insert(variables.end(), inbox_fields.begin(), inbox_fields.end());
      auto expected = FromFields<plcxx::TextFlag>(flag_fields);
      plcxx::UpdateText(expected, FromFields<plcxx::TextInbox>(inbox_fields), text.c_str());
      const Vector expected_fields = ToFields(expected);
      for (size_t field = 0; field < flag.size(); ++field) {
        ASSERT_EQ(terms::Evaluate(terms, flag[field], variables), expected_fields[field]) << text << " " << field;
      }
    }
  }
}

}  // namespace
}  // namespace plcxx::prove
