// The image refresh (specification 4.4): counts are read from memory each time, so they may change at run time.
#pragma once

#include "transpiler/dialects/prostep/lowering/context.h"
#include "transpiler/dialects/prostep/lowering/host_calls.h"

namespace plcxx::prostep {

class Cells;

class Refresh : Context {
 public:
  Refresh(const Context& context, HostCalls& host, Cells& cells) : Context(context), host_(host), cells_(cells) {}

  /// One comparison for each byte, at constant addresses: bits of the image stay apart, which an index would forbid.
  void Inputs();
  void Outputs();

 private:
  HostCalls& host_;
  Cells& cells_;
};

}  // namespace plcxx::prostep
