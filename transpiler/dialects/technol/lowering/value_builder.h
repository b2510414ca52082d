// Values of 8, 16 and 32 bits, put together from their parts and taken apart again without computing anything where
// that can be seen (specification 5.6, 6.9).
#pragma once

#include <initializer_list>
#include <optional>

#include "transpiler/dialects/common/builder.h"
#include "transpiler/dialects/common/logic_stack.h"

namespace plcxx::technol {

/// Of 8, 16 or 32 bits.
constexpr ir::Type TypeOf(uint32_t width) {
  return width == 8 ? ir::Type::kI8 : width == 16 ? ir::Type::kI16 : ir::Type::kI32;
}

class ValueBuilder : public dialects::Builder {
 public:
  using dialects::Builder::Builder;
  using dialects::Builder::Constant;

  ir::ValueId Constant(uint64_t value, uint32_t width, uint32_t base = 10);
  ir::ValueId Byte(uint64_t value) { return Constant(value, 8); }
  ir::ValueId Number(uint64_t value) { return Constant(value, 32); }
  ir::ValueId Not(ir::ValueId bit) { return dialects::Inverted(*this, bit); }

  uint32_t WidthOf(ir::ValueId value);
  std::optional<uint64_t> KnownValue(ir::ValueId value);
  /// Parts of a value that are known where it was put together.
  ir::ValueId Low16(ir::ValueId value);
  ir::ValueId High16(ir::ValueId value);
  ir::ValueId Low8(ir::ValueId value);
  ir::ValueId High8(ir::ValueId value);
  /// Zero-extended, sign-extended or cut to 8, 16 or 32 bits.
  ir::ValueId ToWidth(ir::ValueId value, uint32_t width);
  ir::ValueId SignedTo32(ir::ValueId value);
};

}  // namespace plcxx::technol
