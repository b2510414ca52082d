// Numbers: constants, conversions (specification 6.1), numbers as bits and bits as numbers.
#pragma once

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class StatedFacts;

class Conversions : Context {
 public:
  Conversions(const Context& context, StatedFacts& stated) : Context(context), stated_(stated) {}

  Value Make(ir::ValueId id, TypeId type);
  Value Number(int64_t number, TypeId type, uint32_t base = 10);
  Value Zero(TypeId type);
  Value FromBit(ir::ValueId bit);
  /// The low byte of a word: where the word is made of bytes, the operation is one of bytes.
  ir::ValueId Narrow8(ir::ValueId value);
  Value ConvertInteger(const Value& value, TypeId to);
  Value Convert(const Value& value, TypeId to);
  ir::ValueId AsBit(const Value& value);
  ir::ValueId AsIndex(const Value& value);

 private:
  ir::ValueId Narrow16(ir::ValueId value);

  StatedFacts& stated_;
};

}  // namespace plcxx::hnc
