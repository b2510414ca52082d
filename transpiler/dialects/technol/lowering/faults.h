// Faults of a statement while the machine runs: the host is told, and execution goes on (specification 8.1).
#pragma once

#include "transpiler/dialects/technol/lowering/context.h"
#include "transpiler/dialects/technol/lowering/host_calls.h"

namespace plcxx::technol {

/// In the order of the enumerators of fault(): 8.1.
enum class Fault : uint8_t { kBounds, kLoop, kDivide, kBcdRange, kBcdDigit };

class Faults : Context {
 public:
  Faults(const Context& context, HostCalls& host) : Context(context), host_(host) {}

  /// Calls fault() with the statement that is being lowered.
  void Report(Fault fault);
  void ReportWhen(ir::ValueId condition, Fault fault);

 private:
  HostCalls& host_;
};

}  // namespace plcxx::technol
