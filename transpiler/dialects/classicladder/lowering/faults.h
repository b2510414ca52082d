// Faults while the machine runs: the host is told, and the program goes on.
#pragma once

#include "transpiler/dialects/classicladder/lowering/context.h"
#include "transpiler/dialects/classicladder/lowering/host_calls.h"

namespace plcxx::classicladder {

/// In the order of the enumerators of fault().
enum class Fault : uint8_t { kJumpLoop, kIndex, kDivision };

class Faults : Context {
 public:
  Faults(const Context& context, HostCalls& host) : Context(context), host_(host) {}

  void Report(Fault fault) {
    host_(HostCall::kFault, {builder_.Constant(ir::Type::kI8, static_cast<uint64_t>(fault))});
  }

 private:
  HostCalls& host_;
};

}  // namespace plcxx::classicladder
