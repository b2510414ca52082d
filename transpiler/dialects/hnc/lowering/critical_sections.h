// From `asm cli` to `asm sti`, or to the end of the part (specification 6.8): calls of the host and a flag.
#pragma once

#include <string>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class HostCalls;
class Memory;

class CriticalSections : Context {
 public:
  CriticalSections(const Context& context, HostCalls& host_calls, Memory& memory)
      : Context(context), host_calls_(host_calls), memory_(memory) {}

  void Call(const std::string& name);
  /// Set from `asm cli` to `asm sti`, or to the end of the part (6.8).
  ir::PlaceId Flag();
  void End();
  /// None: no statement is `asm cli` or `asm sti`.
  ir::PlaceId flag() const { return flag_; }

 private:
  HostCalls& host_calls_;
  Memory& memory_;
  ir::PlaceId flag_;
};

}  // namespace plcxx::hnc
