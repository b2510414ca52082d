// FM 41 to FM 54: variables of the NC, through the host (specification 6.9, 8.1).
#pragma once

#include "transpiler/dialects/prostep/lowering/context.h"
#include "transpiler/dialects/prostep/lowering/host_calls.h"

namespace plcxx::prostep {

class Cells;
class Faults;
class Operands;
class Scalars;

class NcVariables : Context {
 public:
  NcVariables(const Context& context, HostCalls& host, Scalars& scalars, Cells& cells, Faults& faults,
              Operands& operands)
      : Context(context), host_(host), scalars_(scalars), cells_(cells), faults_(faults), operands_(operands) {}

  void Read(const Instruction& instruction, ir::Type type);
  void Write(const Instruction& instruction, ir::Type type);

 private:
  HostCalls& host_;
  Scalars& scalars_;
  Cells& cells_;
  Faults& faults_;
  Operands& operands_;
};

}  // namespace plcxx::prostep
