// Operands as values: constants, memory, and the direct ports (specification 6.1.1, 6.2, 6.4, 6.9).
#pragma once

#include "transpiler/dialects/prostep/lowering/context.h"
#include "transpiler/dialects/prostep/lowering/host_calls.h"

namespace plcxx::prostep {

class Cells;

class Operands : Context {
 public:
  Operands(const Context& context, HostCalls& host, Cells& cells) : Context(context), host_(host), cells_(cells) {}

  /// A byte operand, or the bits of a word operand or constant.
  ir::ValueId Read(const Operand& operand);
  /// A value of 8 or 16 bits, as wide as the operand.
  void Write(const Operand& operand, ir::ValueId value);
  ir::ValueId ReadPort(uint32_t port) { return host_(HostCall::kReadPort, {Number(port)}); }
  /// The latch of an output byte goes out.
  void SendLatch(uint32_t port);
  /// val(x) of 6.9 in 32 bits; with muldiv=unsigned everything is zero-extended.
  ir::ValueId Value32(const Operand& operand);
  /// val(x) modulo 2^16, and modulo 2^8.
  ir::ValueId Value16(const Operand& operand);
  ir::ValueId Value8(const Operand& operand);

 private:
  void WritePort(uint32_t port, ir::ValueId byte);

  HostCalls& host_;
  Cells& cells_;
};

}  // namespace plcxx::prostep
