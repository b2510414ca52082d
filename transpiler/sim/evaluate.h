// The meaning of the operations: the functions of runtime_support, called with operands of their own types.
//
// A value travels as 64 raw bits; the operand types of ops.def say what they are. The call is by name, so that an
// overloaded function is chosen as generated code chooses it, and an operation without a function does not compile.
// Not its job: what is around an operation (memory, forces, control flow: simulator.h).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace plcxx::sim {

/// The C++ types of ir::Type, by the names that the operation table uses.
namespace operand_types {
using None = void;
using Bit = bool;
using I8 = uint8_t;
using I16 = uint16_t;
using I32 = uint32_t;
using I64 = uint64_t;
using F32 = float;
using F64 = double;
}  // namespace operand_types

template <class T>
T FromRaw(uint64_t raw) {
  if constexpr (std::is_same_v<T, float>) {
    return std::bit_cast<float>(static_cast<uint32_t>(raw));
  } else if constexpr (std::is_same_v<T, double>) {
    return std::bit_cast<double>(raw);
  } else {
    return static_cast<T>(raw);
  }
}

template <class T>
uint64_t ToRaw(T value) {
  if constexpr (std::is_same_v<T, float>) {
    return std::bit_cast<uint32_t>(value);
  } else if constexpr (std::is_same_v<T, double>) {
    return std::bit_cast<uint64_t>(value);
  } else {
    return value;
  }
}

/// Calls `function` with operands 0, 1 ... that `raw` gives; 0 when it has no result. The type names the declared
/// types.
template <class Result, class... Operand, class Raw, class Function>
uint64_t Apply(std::type_identity<Result(Operand...)>, [[maybe_unused]] Raw&& raw, Function&& function) {
  return [&]<size_t... kIndex>(std::index_sequence<kIndex...>) -> uint64_t {
    static_assert(std::is_same_v<decltype(function(FromRaw<Operand>(raw(kIndex))...)), Result>,
                  "the function's result is what the operation table declares");
    if constexpr (std::is_void_v<Result>) {
      function(FromRaw<Operand>(raw(kIndex))...);
      return 0;
    } else {
      return ToRaw<Result>(function(FromRaw<Operand>(raw(kIndex))...));
    }
  }(std::index_sequence_for<Operand...>{});
}

}  // namespace plcxx::sim
