// What expressions of C become while they are lowered: numbers, addresses, lvalues.
#pragma once

#include <cstdint>
#include <optional>

#include "transpiler/dialects/hnc/analysis/objects.h"
#include "transpiler/dialects/hnc/analysis/ranges.h"
#include "transpiler/dialects/hnc/syntax/syntax.h"
#include "transpiler/ir/program.h"

namespace plcxx::hnc {

/// A number that has been computed. `is_bit`: the IR's value is a bit that stands for the int 0 or 1.
struct Value {
  ir::ValueId id;
  TypeId type;
  bool is_bit = false;
  Bounds bounds;  // of integers
};

/// A place or the value of a pointer: bytes base + index * stride of one of the targets.
struct Address {
  ObjectSet targets;
  ir::ValueId object;  // i16, the number of the target; none where there is one target
  int64_t base = 0;
  ir::ValueId index;  // i32 with sign; none: constant
  uint32_t stride = 1;
  Bounds index_bounds;
  bool is_null = false;   // the constant 0
  bool reported = false;  // that there is none has been reported
};

/// What an lvalue expression names: a local of the routine, or memory.
struct Lvalue {
  VariableId local;  // a scalar that is a named local
  Address address;
  TypeId type;
  const Member* bit_field = nullptr;
  ExprId expr;  // for messages
};

/// What a call gives back.
struct CallResult {
  std::optional<Value> value;
  std::optional<Address> address;  // of pointers, and of records
};

inline constexpr uint32_t kNullOffset = 0x80000000;
inline constexpr Bounds kAnyOffset{-0x80000000LL, 0x7FFFFFFF};  // of a pointer, null among them
inline constexpr uint32_t kMostTargets = 16;

}  // namespace plcxx::hnc
