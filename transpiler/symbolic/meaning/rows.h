// One function for each row of ops.def, by its name, and what an instance is made of: declared from the tables, so that
// a row without its function does not link.
//
// In: values of the widths of the row. A step changes the fields of its instance.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

#include "transpiler/symbolic/meaning/value.h"

namespace plcxx::meaning {

/// The types of the table. All are values; the width is the row's.
using None = void;
using Bit = Value;
using I8 = Value;
using I16 = Value;
using I32 = Value;
using I64 = Value;
using F32 = Value;
using F64 = Value;

/// A field of an instance: a value, or a row of them.
template <size_t kCount>
using FieldValues = std::conditional_t<kCount == 1, Value, std::array<Value, kCount>>;

// The fields of each kind by name, in the order of the table: struct OnDelayTimerValues { Value elapsed_ms; ... }. A
// row of a kind ends the struct of the kind before it.
// clang-format off
struct NoValues {
#define PLCXX_STATE(Kind, ...) }; struct Kind##Values {
#define PLCXX_FIELD(Kind, Field, Type) Value Field;
#define PLCXX_HIDDEN(Kind, Field, Type, Count) FieldValues<Count> Field;
#include "transpiler/ir/states.def"
#undef PLCXX_STATE
#undef PLCXX_FIELD
#undef PLCXX_HIDDEN
};
// clang-format on

#define PLCXX_STEP_PARAMETERS(...) __VA_OPT__(, ) __VA_ARGS__
#define PLCXX_PURE(Kind, Text, Operands, Result, ...) Result Kind Operands;
#define PLCXX_STEP(Kind, Text, State, Operands, Result, ...) \
  Result Kind(State##Values& instance PLCXX_STEP_PARAMETERS Operands);
#define PLCXX_CORE(...)
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
#undef PLCXX_STEP_PARAMETERS

/// The core operation of this name: NC110 7.5.
void UpdateText(TextFlagValues& flag, const TextInboxValues& inbox, std::string_view text);

}  // namespace plcxx::meaning
