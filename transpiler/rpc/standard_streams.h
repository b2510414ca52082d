// A server on standard input and output, until the input ends or somebody says so.
#pragma once

#include <functional>

#include "transpiler/rpc/json_rpc.h"

namespace plcxx::rpc {

class StandardStreams {
 public:
  StandardStreams();
  /// For the server's `send`. What cannot be written ends the loop.
  void Send(Framing framing, std::string_view text);
  /// Feeds the server and lets it work. `idle` is called when nothing has arrived and nothing waits; it does one step
  /// of what can wait, and says whether there is more. Ends when the input does, or after `ended` says so.
  void Run(Server& server, const std::function<bool()>& idle, const std::function<bool()>& ended);

 private:
  bool broken_ = false;
};

}  // namespace plcxx::rpc
