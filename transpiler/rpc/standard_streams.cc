#include "transpiler/rpc/standard_streams.h"

#include <poll.h>
#include <signal.h>
#include <unistd.h>
#include <climits>

#include <algorithm>
#include <cerrno>

namespace plcxx::rpc {
namespace {

/// With more than this unread by the client, nothing is done that would add to it.
constexpr size_t kMaxQueue = size_t{64} << 20;

}  // namespace

/// A client that is gone is the end of the loop, not of the process by a signal.
StandardStreams::StandardStreams() { signal(SIGPIPE, SIG_IGN); }

void StandardStreams::Send(Framing framing, std::string_view text) {
  if (broken_) return;
  if (!MustWrite()) {
    queue_.clear();
    written_ = 0;
  }
  queue_ += Framed(framing, text);
}

/// As much as a pipe that can be written to takes without blocking.
void StandardStreams::WriteSome() {
  const size_t size = std::min<size_t>(queue_.size() - written_, PIPE_BUF);
  const ssize_t count = write(STDOUT_FILENO, queue_.data() + written_, size);
  if (count >= 0) {
    written_ += static_cast<size_t>(count);
  } else if (errno != EINTR && errno != EAGAIN) {
    broken_ = true;
  }
}

std::optional<std::string> StandardStreams::Read(Wait wait) {
  constexpr size_t kPiece = size_t{1} << 16;
  while (!broken_) {
    pollfd ends[] = {{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0},
                     {.fd = MustWrite() ? STDOUT_FILENO : -1, .events = POLLOUT, .revents = 0}};
    const int ready = poll(ends, 2, wait == Wait::kNot ? 0 : -1);
    if (ready < 0 && errno != EINTR) return std::string();
    if (ready > 0 && ends[1].revents != 0) WriteSome();
    if (ready > 0 && ends[0].revents != 0) {
      std::string piece(kPiece, '\0');
      const ssize_t count = read(STDIN_FILENO, piece.data(), piece.size());
      if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
      piece.resize(count < 0 ? 0 : static_cast<size_t>(count));
      return piece;
    }
    if (ready == 0) return std::nullopt;
  }
  return std::string();
}

void StandardStreams::Run(Server& server, const std::function<bool()>& idle, const std::function<bool()>& ended) {
  bool idle_work = true;
  bool open = true;
  while (open && !broken_ && !ended()) {
    const bool is_full = queue_.size() - written_ > kMaxQueue;
    const bool has_work = !is_full && (server.HasWork() || idle_work);
    if (std::optional<std::string> bytes = Read(has_work ? Wait::kNot : Wait::kUntilSomethingHappens)) {
      open = !bytes->empty();
      server.Feed(*bytes);
      idle_work = true;
    } else if (server.HasWork()) {
      server.Work();
      idle_work = true;
    } else {
      idle_work = idle();
    }
  }
  // What a client sent before it closed its side is answered.
  while (!broken_ && !ended() && server.HasWork()) server.Work();
  while (!broken_ && MustWrite()) WriteSome();
}

}  // namespace plcxx::rpc
