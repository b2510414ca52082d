// Faults while the machine runs: the host is told in which module; the PLC goes on (specification 8.1).
#pragma once

#include "transpiler/dialects/prostep/lowering/context.h"
#include "transpiler/dialects/prostep/lowering/host_calls.h"

namespace plcxx::prostep {

/// In the order of the enumerators of fault(): 8.1.
enum class Fault : uint8_t { kDivZero, kDivOverflow, kIndex, kNcAccess, kLoopBudget };

class Faults : Context {
 public:
  Faults(const Context& context, HostCalls& host) : Context(context), host_(host) {}

  void Report(Fault fault) { host_(HostCall::kFault, {Byte(static_cast<uint32_t>(fault)), Number(module().number)}); }
  void ReportWhen(ir::ValueId condition, Fault fault) {
    builder_.When(condition, [&] { Report(fault); });
  }

 private:
  HostCalls& host_;
};

}  // namespace plcxx::prostep
