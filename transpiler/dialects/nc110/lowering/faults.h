// Faults while the machine runs: the host is told; the logic never stops.
#pragma once

#include "transpiler/dialects/nc110/lowering/context.h"
#include "transpiler/dialects/nc110/lowering/host_calls.h"

namespace plcxx::nc110 {

/// In the order of the enumerators of fault().
enum class Fault : uint8_t { kParamRange, kLoopLimit };

class Faults : Context {
 public:
  Faults(const Context& context, HostCalls& host) : Context(context), host_(host) {}

  void Call(Fault kind, uint32_t index) {
    const ir::ValueId number = builder_.Constant(ir::Type::kI32, index);
    host_(HostCall::kFault, {Byte(static_cast<uint32_t>(kind)), number});
  }

 private:
  HostCalls& host_;
};

}  // namespace plcxx::nc110
