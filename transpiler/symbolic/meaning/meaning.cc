#include "transpiler/symbolic/meaning/meaning.h"

#include <array>
#include <bit>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "transpiler/support/check.h"
#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {
namespace {

using meaning::Value;

template <class... Operand>
terms::TermId CallPure(Value (*row)(Operand...), terms::Terms& terms, std::span<const terms::TermId> operands) {
  PLCXX_CHECK(operands.size() == sizeof...(Operand));
  return [&]<size_t... kIndex>(std::index_sequence<kIndex...>) {
    return row(Value{&terms, operands[kIndex]}...).id;
  }(std::index_sequence_for<Operand...>{});
}

/// The fields as a struct, and back: it is a row of values and nothing else.
template <class State>
using Row = std::array<Value, sizeof(State) / sizeof(Value)>;

template <class State>
State Load(terms::Terms& terms, std::span<const terms::TermId> fields) {
  static_assert(std::is_trivially_copyable_v<State> && sizeof(Row<State>) == sizeof(State));
  Row<State> row;
  PLCXX_CHECK(fields.size() == row.size());
  for (size_t i = 0; i < row.size(); ++i) row[i] = {&terms, fields[i]};
  return std::bit_cast<State>(row);
}

template <class State>
void Save(const State& state, const terms::Terms& terms, std::span<terms::TermId> fields) {
  const auto row = std::bit_cast<Row<State>>(state);
  for (size_t i = 0; i < row.size(); ++i) {
    PLCXX_CHECK(terms.Width(row[i].id) == terms.Width(fields[i]));
    fields[i] = row[i].id;
  }
}

template <class Result, class State, class... Operand>
terms::TermId CallStep(Result (*row)(State&, Operand...), terms::Terms& terms, std::span<terms::TermId> fields,
                       std::span<const terms::TermId> operands) {
  PLCXX_CHECK(operands.size() == sizeof...(Operand));
  State state = Load<State>(terms, fields);
  const terms::TermId result = [&]<size_t... kIndex>(std::index_sequence<kIndex...>) {
    if constexpr (std::is_void_v<Result>) {
      row(state, Value{&terms, operands[kIndex]}...);
      return terms::TermId();
    } else {
      return row(state, Value{&terms, operands[kIndex]}...).id;
    }
  }(std::index_sequence_for<Operand...>{});
  Save(state, terms, fields);
  return result;
}

}  // namespace

terms::TermId MeaningOf(terms::Terms& terms, ir::OpKind op, std::span<const terms::TermId> operands) {
  switch (op) {
#define PLCXX_PURE(Kind, ...) \
  case ir::OpKind::k##Kind:   \
    return CallPure(meaning::Kind, terms, operands);
#define PLCXX_STEP(Kind, ...) case ir::OpKind::k##Kind:
#define PLCXX_CORE(Kind, ...) case ir::OpKind::k##Kind:
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
    break;  // not pure
  }
  PLCXX_UNREACHABLE();
}

terms::TermId StepMeaning(terms::Terms& terms, ir::OpKind op, std::span<terms::TermId> fields,
                          std::span<const terms::TermId> operands) {
  switch (op) {
#define PLCXX_PURE(Kind, ...) case ir::OpKind::k##Kind:
#define PLCXX_STEP(...)
#define PLCXX_CORE(Kind, ...) case ir::OpKind::k##Kind:
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
    break;  // not a step
#define PLCXX_PURE(...)
#define PLCXX_STEP(Kind, ...) \
  case ir::OpKind::k##Kind:   \
    return CallStep(meaning::Kind, terms, fields, operands);
#define PLCXX_CORE(...)
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
  }
  PLCXX_UNREACHABLE();
}

uint32_t FieldTermIndex(ir::StateKind kind, uint8_t field) {
  uint32_t index = 0;
  for (const ir::FieldInfo& before : ir::Info(kind).fields.first(field)) index += before.count;
  return index;
}

uint32_t FieldTerms(ir::StateKind kind) {
  return FieldTermIndex(kind, static_cast<uint8_t>(ir::Info(kind).fields.size()));
}

void UpdateTextMeaning(terms::Terms& terms, std::span<terms::TermId> flag, std::span<terms::TermId> inbox,
                       std::string_view text) {
  auto values = Load<meaning::TextFlagValues>(terms, flag);
  meaning::UpdateText(values, Load<meaning::TextInboxValues>(terms, inbox), text);
  Save(values, terms, flag);
}

}  // namespace plcxx::meaning
