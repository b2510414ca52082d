#include "transpiler/rpc/standard_streams.h"

#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <string>

namespace plcxx::rpc {
namespace {

enum class Wait : uint8_t { kUntilSomethingArrives, kNot };

bool HasInput(Wait wait) {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  while (true) {
    const int ready = poll(&input, 1, wait == Wait::kNot ? 0 : -1);
    if (ready >= 0) return ready > 0;
    if (errno != EINTR) return true;  // read() tells what is wrong
  }
}

}  // namespace

/// A client that is gone is the end of the loop, not of the process by a signal.
StandardStreams::StandardStreams() { signal(SIGPIPE, SIG_IGN); }

void StandardStreams::Send(Framing framing, std::string_view text) {
  const std::string frame = Framed(framing, text);
  size_t sent = 0;
  while (!broken_ && sent < frame.size()) {
    const ssize_t count = write(STDOUT_FILENO, frame.data() + sent, frame.size() - sent);
    if (count >= 0) {
      sent += static_cast<size_t>(count);
    } else if (errno == EAGAIN) {
      pollfd output{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
      poll(&output, 1, -1);
    } else if (errno != EINTR) {
      broken_ = true;
    }
  }
}

void StandardStreams::Run(Server& server, const std::function<bool()>& idle, const std::function<bool()>& ended) {
  constexpr size_t kPiece = size_t{1} << 16;
  std::string piece(kPiece, '\0');
  bool idle_work = true;
  while (!broken_ && !ended()) {
    const bool must_wait = !server.HasWork() && !idle_work;
    if (HasInput(must_wait ? Wait::kUntilSomethingArrives : Wait::kNot)) {
      const ssize_t count = read(STDIN_FILENO, piece.data(), piece.size());
      if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
      if (count <= 0) break;
      server.Feed(std::string_view(piece).substr(0, static_cast<size_t>(count)));
      idle_work = true;
      continue;
    }
    if (server.HasWork()) {
      server.Work();
      idle_work = true;
    } else {
      idle_work = idle();
    }
  }
  // What a client sent before it closed its side is answered.
  while (!broken_ && !ended() && server.HasWork()) server.Work();
}

}  // namespace plcxx::rpc
