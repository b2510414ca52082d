// Bits that are read and written: memory, ports, outputs of timers, counters that are not 0 (specification 6.1, 6.2).
#pragma once

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Cells;
class Instances;
class Logic;
class Operands;

class Bits : Context {
 public:
  Bits(const Context& context, Cells& cells, Instances& instances, Operands& operands, Logic& logic)
      : Context(context), cells_(cells), instances_(instances), operands_(operands), logic_(logic) {}

  ir::ValueId Read(const Operand& operand);
  void Assign(const Operand& target);
  /// Without a branch, so that the worst scan costs what the mean one costs: x | S and x & !S.
  void Set(const Operand& target);
  void Reset(const Operand& target);

 private:
  /// With S = 0 the port is not touched.
  void WritePort(const Operand& target, uint64_t value);

  Cells& cells_;
  Instances& instances_;
  Operands& operands_;
  Logic& logic_;
};

}  // namespace plcxx::prostep
