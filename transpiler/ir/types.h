// The types of the IR's values. Integers have no sign: the operation carries it (ult / slt, lshr / ashr).
#pragma once

#include <cstdint>
#include <string_view>

namespace plcxx::ir {

enum class Type : uint8_t { kNone, kBit, kI8, kI16, kI32, kI64, kF32, kF64 };

constexpr std::string_view Name(Type type) {
  switch (type) {
    case Type::kNone:
      return "none";
    case Type::kBit:
      return "bit";
    case Type::kI8:
      return "i8";
    case Type::kI16:
      return "i16";
    case Type::kI32:
      return "i32";
    case Type::kI64:
      return "i64";
    case Type::kF32:
      return "f32";
    case Type::kF64:
      return "f64";
  }
  return "?";
}

/// Bytes that a value occupies in an address space; a bit occupies part of one.
constexpr uint32_t Bytes(Type type) {
  switch (type) {
    case Type::kNone:
      return 0;
    case Type::kBit:
    case Type::kI8:
      return 1;
    case Type::kI16:
      return 2;
    case Type::kI32:
    case Type::kF32:
      return 4;
    case Type::kI64:
    case Type::kF64:
      return 8;
  }
  return 0;
}

/// The C++ type that generated code and simulator use for a value: Bit -> bool, I8 -> uint8_t ...
constexpr std::string_view CppName(Type type) {
  switch (type) {
    case Type::kNone:
      return "void";
    case Type::kBit:
      return "bool";
    case Type::kI8:
      return "uint8_t";
    case Type::kI16:
      return "uint16_t";
    case Type::kI32:
      return "uint32_t";
    case Type::kI64:
      return "uint64_t";
    case Type::kF32:
      return "float";
    case Type::kF64:
      return "double";
  }
  return "?";
}

}  // namespace plcxx::ir
