// What the arrays of a State hold at power-on: the initial bytes of the spaces, gathered to the values that they are
// parts of. The printer writes them, and what their texts call is used like what statements call.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "transpiler/emit/emittable.h"

namespace plcxx::emit {

/// A value of an array member: bit[5] = true.
struct InitialElement {
  uint32_t index = 0;  // in the array
  ir::SpaceId space;
  uint32_t offset = 0;  // of the space
  uint64_t value = 0;
};

/// Values of one array, by index; what is not named is 0.
struct InitialArray {
  std::string member;  // "m.word16"
  ir::Type type;
  std::map<uint32_t, InitialElement> values;
};

std::map<layout::Storage, InitialArray> InitialArraysOf(const Emittable& emittable);

}  // namespace plcxx::emit
