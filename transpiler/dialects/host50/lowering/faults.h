// Faults while the machine runs: the host is told in which section and network; the program goes on.
#pragma once

#include "transpiler/dialects/host50/lowering/context.h"
#include "transpiler/dialects/host50/lowering/host_calls.h"

namespace plcxx::host50 {

/// In the order of the enumerators of fault().
enum class Fault : uint8_t { kJumpLoop, kRotRange, kAxisRange };

class Faults : Context {
 public:
  Faults(const Context& context, HostCalls& host) : Context(context), host_(host) {}

  void Call(Fault fault);

 private:
  HostCalls& host_;
};

}  // namespace plcxx::host50
