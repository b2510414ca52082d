// Variables that are read and written: numbers, bits, what an index reaches.
#pragma once

#include "transpiler/dialects/classicladder/lowering/faults.h"
#include "transpiler/dialects/classicladder/lowering/places.h"

namespace plcxx::classicladder {

class Accesses : Context {
 public:
  Accesses(const Context& context, Faults& faults, Places& places)
      : Context(context), faults_(faults), places_(places) {}

  ir::ValueId ReadNumber(const Variable& variable);
  ir::ValueId ReadBit(const Variable& variable);
  void WriteNumber(const Variable& variable, ir::ValueId value);
  void WriteBit(const Variable& variable, ir::ValueId bit);

 private:
  struct Indexed {
    ir::PlaceId place;
    ir::ValueId index;
    ir::Type type{};
  };
  /// Where an indexed variable is, and by what it is reached; reports an index that leads out of the array.
  Indexed At(const Variable& variable);
  ir::ValueId BaseOf(const Variable& variable, ir::ValueId index);

  Faults& faults_;
  Places& places_;
};

}  // namespace plcxx::classicladder
