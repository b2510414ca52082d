// Which part of the lowering lowers an instruction.
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"
#include "transpiler/dialects/technol/lowering/host_calls.h"

namespace plcxx::technol {

class Assembler;
class Bits;
class CellPlaces;
class Data;
class Jumps;
class Mechanisms;
class Subprograms;
class Waits;

class InstructionSet : Context {
 public:
  InstructionSet(const Context& context, CellPlaces& cells, HostCalls& host, Jumps& jumps, Bits& bits, Data& data,
                 Waits& waits, Mechanisms& mechanisms, Subprograms& subprograms, Assembler& assembler)
      : Context(context),
        cells_(cells),
        host_(host),
        jumps_(jumps),
        bits_(bits),
        data_(data),
        waits_(waits),
        mechanisms_(mechanisms),
        subprograms_(subprograms),
        assembler_(assembler) {}

  void Lower(const Instruction& instruction);

 private:
  void LowerOwn(const Instruction& instruction);
  /// ESET (specification 6.8).
  void RaiseError(const Instruction& instruction);

  CellPlaces& cells_;
  HostCalls& host_;
  Jumps& jumps_;
  Bits& bits_;
  Data& data_;
  Waits& waits_;
  Mechanisms& mechanisms_;
  Subprograms& subprograms_;
  Assembler& assembler_;
};

}  // namespace plcxx::technol
