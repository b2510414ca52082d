// Inline assembler: which of its families lowers an instruction (specification 6.9). Values are what the registers
// hold; a flag is computed where some path reads it.
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"

namespace plcxx::technol {

class Arithmetic;
class Flags;
class Jumps;
class Moves;
class Products;
class Shifts;

class Assembler : Context {
 public:
  Assembler(const Context& context, Flags& flags, Jumps& jumps, Arithmetic& arithmetic, Moves& moves, Shifts& shifts,
            Products& products)
      : Context(context),
        flags_(flags),
        jumps_(jumps),
        arithmetic_(arithmetic),
        moves_(moves),
        shifts_(shifts),
        products_(products) {}

  void Lower(const Instruction& instruction);

 private:
  Flags& flags_;
  Jumps& jumps_;
  Arithmetic& arithmetic_;
  Moves& moves_;
  Shifts& shifts_;
  Products& products_;
};

}  // namespace plcxx::technol
