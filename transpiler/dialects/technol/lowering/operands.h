// What operands are as values: constants, registers, and memory, through an index register, too (specification 6.1).
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class CellPlaces;
class Exits;
class Faults;
class MechanismPlaces;

class Operands : Context {
 public:
  /// Where an operand is in memory; `index` none: without an index register. A register has no place.
  struct Reach {
    ir::PlaceId place;
    ir::ValueId index;
  };

  Operands(const Context& context, CellPlaces& cells, MechanismPlaces& mechanisms, Faults& faults, Exits& exits)
      : Context(context), cells_(cells), mechanisms_(mechanisms), faults_(faults), exits_(exits) {}

  /// A value of the operand's width: memory, constant or register.
  ir::ValueId Read(const Operand& operand);
  /// The same as the operand `width` bits wide of an operation on DR: zero-extended, constants modulo 2^width.
  ir::ValueId ReadAs(const Operand& operand, uint32_t width);
  void Write(const Operand& operand, ir::ValueId value);
  ir::PlaceId PlaceOf(const Operand& operand);
  /// Of memory. An index is checked here: what is not wholly inside the area reads 0 and is not written, and the host
  /// learns of it (6.1).
  Reach ReachOf(const Operand& operand);
  /// Of what an instruction reads and writes, register or memory: reached, and reported, once.
  Reach ReachOfTarget(const Operand& operand);
  ir::ValueId ReadAt(const Operand& operand, const Reach& reach);
  void WriteAt(const Operand& operand, const Reach& reach, ir::ValueId value);

 private:
  /// The index register as a signed number of 32 bits.
  ir::ValueId IndexOf(const Address& address);
  void CheckInside(ir::ValueId at, uint32_t bytes, uint32_t area_bytes);

  CellPlaces& cells_;
  MechanismPlaces& mechanisms_;
  Faults& faults_;
  Exits& exits_;
};

}  // namespace plcxx::technol
