#include "transpiler/ir/op.h"

#include <array>
#include <vector>

#include "transpiler/support/check.h"

namespace plcxx::ir {
namespace {

constexpr Type kTypeBit = Type::kBit, kTypeI8 = Type::kI8, kTypeI16 = Type::kI16, kTypeI32 = Type::kI32;

struct TypeList {
  uint8_t count = 0;
  Type types[3] = {Type::kNone, Type::kNone, Type::kNone};
};
// Names as the tables write them, so that a row reads "(Bit, I32)".
namespace names {
// NOLINTNEXTLINE(readability-identifier-naming)
constexpr Type None = Type::kNone, Bit = kTypeBit, I8 = kTypeI8, I16 = kTypeI16, I32 = kTypeI32, I64 = Type::kI64,
               F32 = Type::kF32, F64 = Type::kF64;
template <class... T>
constexpr TypeList Types(T... types) {
  return TypeList{sizeof...(T), {types...}};
}
}  // namespace names

constexpr OpInfo Row(std::string_view text, Shape shape, Effect effect, Type result, TypeList operands,
                     std::string_view spelling, std::string_view function, std::string_view header,
                     Precedence precedence, CostClass cost, std::optional<StateKind> state) {
  return OpInfo{
      text,     shape,    effect, result,     operands.count, {operands.types[0], operands.types[1], operands.types[2]},
      spelling, function, header, precedence, cost,           state};
}

constexpr uint32_t kOpCount = 0
#define PLCXX_PURE(...) +1
#define PLCXX_STEP(...) +1
#define PLCXX_CORE(...) +1
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
    ;

constexpr auto MakeOps() {
  using namespace names;
  std::array<OpInfo, kOpCount> ops{};
  std::string_view header;
  size_t next = 0;
#define PLCXX_HEADER(Header) header = Header;
#define PLCXX_PURE(Kind, TextName, Operands, Result, Spelling, Prec, Function, Cost)                            \
  ops[next++] = Row(TextName, Shape::kPure, Effect::kPure, Result, Types Operands, Spelling, #Function, header, \
                    Precedence::Prec, CostClass::Cost, std::nullopt);
#define PLCXX_STEP(Kind, TextName, State, Operands, Result, Spelling, Function, Cost)                         \
  ops[next++] = Row(TextName, Shape::kStep, Effect::kWrites, Result, Types Operands, Spelling, #Function, "", \
                    Precedence::kPrimary, CostClass::Cost, StateKind::k##State);
#define PLCXX_CORE(Kind, TextName, ShapeName, EffectName, Cost)                                          \
  ops[next++] = Row(TextName, Shape::ShapeName, Effect::EffectName, Type::kNone, TypeList{}, "", "", "", \
                    Precedence::kPrimary, CostClass::Cost, std::nullopt);
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
  return ops;
}
constexpr auto kOps = MakeOps();

constexpr auto MakeFields() {
  using namespace names;
  struct Row {
    StateKind kind;
    FieldInfo info;
  };
  return std::to_array<Row>({
#define PLCXX_STATE(...)
#define PLCXX_FIELD(Kind, Field, FieldType) Row{StateKind::k##Kind, {#Field, FieldType, 1, false}},
#define PLCXX_HIDDEN(Kind, Field, FieldType, Count) Row{StateKind::k##Kind, {#Field, FieldType, Count, true}},
#include "transpiler/ir/states.def"
#undef PLCXX_STATE
#undef PLCXX_FIELD
#undef PLCXX_HIDDEN
  });
}

struct StateTable {
  std::vector<FieldInfo> fields;
  std::vector<StateInfo> states;
};

StateTable MakeStates() {
  StateTable table;
  constexpr auto kRows = MakeFields();
  struct Head {
    StateKind kind;
    std::string_view name, text, header;
  };
  constexpr auto kHeads = std::to_array<Head>({
#define PLCXX_STATE(Kind, TextName, Header) Head{StateKind::k##Kind, #Kind, TextName, Header},
#define PLCXX_FIELD(...)
#define PLCXX_HIDDEN(...)
#include "transpiler/ir/states.def"
#undef PLCXX_STATE
#undef PLCXX_FIELD
#undef PLCXX_HIDDEN
  });
  table.fields.reserve(kRows.size());  // the spans below point into it
  for (const Head& head : kHeads) {
    const size_t first = table.fields.size();
    for (const auto& row : kRows) {
      if (row.kind == head.kind) table.fields.push_back(row.info);
    }
    table.states.push_back(
        {head.name, head.text, head.header, {table.fields.data() + first, table.fields.size() - first}});
  }
  return table;
}

const StateTable& States() {
  static const StateTable table = MakeStates();
  return table;
}

}  // namespace

const OpInfo& Info(OpKind op) { return kOps[static_cast<size_t>(op)]; }

std::optional<OpKind> OpByText(std::string_view text) {
  for (size_t i = 0; i < kOps.size(); ++i) {
    if (kOps[i].text == text) return static_cast<OpKind>(i);
  }
  return std::nullopt;
}

uint32_t OpCount() { return kOps.size(); }

const StateInfo& Info(StateKind kind) { return States().states[static_cast<size_t>(kind)]; }

std::optional<StateKind> StateByText(std::string_view text) {
  for (size_t i = 0; i < States().states.size(); ++i) {
    if (States().states[i].text == text) return static_cast<StateKind>(i);
  }
  return std::nullopt;
}

uint32_t StateKindCount() { return static_cast<uint32_t>(States().states.size()); }

uint8_t FieldIndex(StateKind kind, std::string_view field) {
  const auto fields = Info(kind).fields;
  for (size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].name == field) return static_cast<uint8_t>(i);
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::ir
