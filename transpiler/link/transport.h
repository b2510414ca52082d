// The wire to a machine: bytes out, bytes in, and no wait without an end.
//
// In: an address as the command line has it. Out: an open wire, or why there is none. Not its job: what the bytes mean.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plcxx::debug_link {

using Bytes = std::vector<uint8_t>;

class Transport {
 public:
  virtual ~Transport() = default;
  /// False: the other end is gone, or takes nothing any more.
  virtual bool Send(std::span<const uint8_t> bytes) = 0;
  /// What has come, waiting so long for the first byte; none: the other end is gone.
  virtual std::optional<Bytes> Receive(int wait_ms) = 0;
  /// After one of these said that the other end is gone: how it went; lower case, no full stop.
  virtual std::string WhyGone() const = 0;
};

struct OpenedTransport {
  std::unique_ptr<Transport> transport;
  std::string reason;  // why there is none; lower case, no full stop
};

/// What is wrong with an address as it is written; empty: nothing.
std::string WrongAddress(std::string_view address);

/// "tcp:HOST:PORT", "serial:DEVICE:BAUD" (BAUD may be left out: 115200), "socket:PATH" (QEMU's -chardev
/// socket,path=...).
OpenedTransport OpenTransport(std::string_view address);

/// Of a file descriptor that is open already, which it closes.
std::unique_ptr<Transport> TransportOf(int descriptor);

}  // namespace plcxx::debug_link
