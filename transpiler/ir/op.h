// The operations as data: enum and properties, made from ops.def and states.def.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "transpiler/ir/types.h"

namespace plcxx::ir {

enum class OpKind : uint16_t {
#define PLCXX_PURE(Kind, ...) k##Kind,
#define PLCXX_STEP(Kind, ...) k##Kind,
#define PLCXX_CORE(Kind, ...) k##Kind,
#include "transpiler/ir/ops.def"
#undef PLCXX_PURE
#undef PLCXX_STEP
#undef PLCXX_CORE
};

enum class StateKind : uint8_t {
#define PLCXX_STATE(Kind, ...) k##Kind,
#define PLCXX_FIELD(...)
#define PLCXX_HIDDEN(...)
#include "transpiler/ir/states.def"
#undef PLCXX_STATE
#undef PLCXX_FIELD
#undef PLCXX_HIDDEN
};

/// What the words a, b, c and the payload of an Inst mean; see program.h.
enum class Shape : uint8_t {
  kPure,
  kStep,
  kConst,
  kLoad,
  kStore,
  kText,
  kStatement,
  kIf,
  kSwitch,
  kLoop,
  kBlock,
  kExit,
  kRepeat,
  kCall,
  kHostCall,
  kJump,
  kLabel
};
enum class Effect : uint8_t { kPure, kReads, kWrites, kHost, kControl };
/// Of the C++ operator in the spelling, tightest first; the printer parenthesizes by it.
enum class Precedence : uint8_t { kPrimary, kUnary, kAdditive, kRelational, kEquality, kAnd, kXor, kOr, kAssign };
/// The classes the cost model prices (cost/).
enum class CostClass : uint8_t {
  kFree,
  kLogic,
  kArithmetic,
  kDivide,
  kTable,
  kCompare,
  kLoad,
  kStore,
  kBranch,
  kCall,
  kTimer,
  kCounter,
  kPulse,
  kExpire
};

struct OpInfo {
  std::string_view text;
  Shape shape;
  Effect effect;
  Type result;            // kNone where the Inst's own type says it (load, const, call)
  uint8_t operand_count;  // of kPure and kStep
  Type operands[3];
  std::string_view spelling;  // C++; {0} {1} {2} operands, {s} the state instance
  std::string_view function;  // of runtime_support; empty for the IR's own
  std::string_view header;    // where that is; empty: in logic.h, or with the state
  Precedence precedence;
  CostClass cost;
  std::optional<StateKind> state;  // of kStep
};

const OpInfo& Info(OpKind op);
std::optional<OpKind> OpByText(std::string_view text);
uint32_t OpCount();

struct FieldInfo {
  std::string_view name;
  Type type;
  uint8_t count;  // more than 1: an array
  bool hidden;    // only the kind's own operations use it
};
struct StateInfo {
  std::string_view struct_name;  // "OnDelayTimer"
  std::string_view text;         // "on_delay_timer"
  std::string_view header;       // "timers.h" of runtime_support/plcxx
  std::span<const FieldInfo> fields;
};

const StateInfo& Info(StateKind kind);
std::optional<StateKind> StateByText(std::string_view text);
uint32_t StateKindCount();
/// The index of a field by its name; a fault of plcxx when there is none.
uint8_t FieldIndex(StateKind kind, std::string_view field);

}  // namespace plcxx::ir
