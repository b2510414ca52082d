// A server on standard input and output, until the input ends or somebody says so.
//
// It reads while what it says has not been read: a client that first sends all of its files and then listens is served.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "transpiler/rpc/json_rpc.h"

namespace plcxx::rpc {

class StandardStreams {
 public:
  StandardStreams();
  /// For the server's `send`: queues a message. What cannot be written ends the loop.
  void Send(Framing framing, std::string_view text);
  /// Feeds the server and lets it work. `idle` is called when nothing has arrived and nothing waits; it does one step
  /// of what can wait, and says whether there is more. Ends when the input does, or after `ended` says so.
  void Run(Server& server, const std::function<bool()>& idle, const std::function<bool()>& ended);

 private:
  enum class Wait : uint8_t { kUntilSomethingHappens, kNot };

  /// What has arrived; none: nothing, as far as `wait` allows to wait. Empty at the end of the input. Writes meanwhile.
  std::optional<std::string> Read(Wait wait);
  void WriteSome();
  bool MustWrite() const { return written_ < queue_.size(); }

  std::string queue_;  // to be written, from written_ on
  size_t written_ = 0;
  bool broken_ = false;
};

}  // namespace plcxx::rpc
