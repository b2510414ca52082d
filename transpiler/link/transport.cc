#include "transpiler/link/transport.h"

#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>

namespace plcxx::debug_link {
namespace {

constexpr int kConnectMs = 5000, kSendMs = 2000;
constexpr size_t kPiece = 4096;

/// Closes what nobody took.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  int number() const { return number_; }
  int Take() { return std::exchange(number_, -1); }

 private:
  int number_;
};

bool IsReady(int descriptor, short events, int wait_ms) {
  pollfd end = {.fd = descriptor, .events = events, .revents = 0};
  int ready = 0;
  do ready = poll(&end, 1, wait_ms);
  while (ready < 0 && errno == EINTR);
  return ready > 0;
}

class FileTransport : public Transport {
 public:
  explicit FileTransport(int descriptor) : end_(descriptor) {}

  bool Send(std::span<const uint8_t> bytes) override {
    while (!bytes.empty()) {
      ssize_t count = send(end_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count < 0 && errno == ENOTSOCK) count = write(end_.number(), bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
        if (!IsReady(end_.number(), POLLOUT, kSendMs)) return false;
        continue;
      }
      if (count < 0) return false;
      bytes = bytes.subspan(static_cast<size_t>(count));
    }
    return true;
  }

  std::optional<Bytes> Receive(int wait_ms) override {
    if (!IsReady(end_.number(), POLLIN, wait_ms)) return Bytes();
    Bytes bytes(kPiece);
    const ssize_t count = read(end_.number(), bytes.data(), bytes.size());
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return Bytes();
    if (count <= 0) return std::nullopt;
    bytes.resize(static_cast<size_t>(count));
    return bytes;
  }

 private:
  Descriptor end_;
};

OpenedTransport Failed(std::string what) {
  return {.transport = nullptr, .reason = std::move(what) + ": " + std::strerror(errno)};
}

/// Empty: connected. The descriptor does not block, so that a host that does not answer is given up.
bool Connects(int descriptor, const sockaddr* address, socklen_t size) {
  if (connect(descriptor, address, size) == 0) return true;
  if (errno != EINPROGRESS) return false;
  if (!IsReady(descriptor, POLLOUT, kConnectMs)) {
    errno = ETIMEDOUT;
    return false;
  }
  int error = 0;
  socklen_t error_size = sizeof error;
  if (getsockopt(descriptor, SOL_SOCKET, SO_ERROR, &error, &error_size) != 0) return false;
  errno = error;
  return error == 0;
}

constexpr int kSocketFlags = SOCK_CLOEXEC | SOCK_NONBLOCK;

OpenedTransport OpenTcp(const std::string& place) {
  const size_t colon = place.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == place.size()) {
    return {.transport = nullptr, .reason = "'tcp:" + place + "' has no host and port: tcp:HOST:PORT"};
  }
  std::string host = place.substr(0, colon);
  if (host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  addrinfo hints = {};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (const int error = getaddrinfo(host.c_str(), place.c_str() + colon + 1, &hints, &found); error != 0) {
    return {.transport = nullptr, .reason = "'" + host + "' is not found: " + gai_strerror(error)};
  }
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses(found, &freeaddrinfo);
  errno = 0;
  for (const addrinfo* address = found; address != nullptr; address = address->ai_next) {
    Descriptor descriptor(socket(address->ai_family, address->ai_socktype | kSocketFlags, address->ai_protocol));
    if (descriptor.number() < 0) continue;
    if (Connects(descriptor.number(), address->ai_addr, address->ai_addrlen)) {
      return {.transport = TransportOf(descriptor.Take()), .reason = {}};
    }
  }
  return Failed("no connection to " + place);
}

OpenedTransport OpenSocket(const std::string& path) {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) {
    return {.transport = nullptr, .reason = "'" + path + "' is no path of a socket"};
  }
  path.copy(address.sun_path, path.size());
  Descriptor descriptor(socket(AF_UNIX, SOCK_STREAM | kSocketFlags, 0));
  if (descriptor.number() < 0 ||
      !Connects(descriptor.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address)) {
    return Failed("no connection to '" + path + "'");
  }
  return {.transport = TransportOf(descriptor.Take()), .reason = {}};
}

struct Baud {
  int rate;
  speed_t code;
};
constexpr Baud kBauds[] = {{9600, B9600},     {19200, B19200},   {38400, B38400},   {57600, B57600},
                           {115200, B115200}, {230400, B230400}, {460800, B460800}, {921600, B921600}};

OpenedTransport OpenSerial(const std::string& place) {
  std::string device = place;
  int rate = 115200;
  if (const size_t colon = place.rfind(':'); colon != std::string::npos) {
    const char* const end = place.data() + place.size();
    const auto parsed = std::from_chars(place.data() + colon + 1, end, rate);
    if (parsed.ec != std::errc() || parsed.ptr != end) rate = 0;
    device = place.substr(0, colon);
  }
  const Baud* baud = nullptr;
  for (const Baud& known : kBauds) {
    if (known.rate == rate) baud = &known;
  }
  if (baud == nullptr) {
    return {.transport = nullptr, .reason = "'" + place + "' has no baud rate of 9600, 19200 ... 921600"};
  }
  Descriptor descriptor(open(device.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK));
  termios settings = {};
  if (descriptor.number() < 0 || tcgetattr(descriptor.number(), &settings) != 0) return Failed("'" + device + "'");
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS | CSTOPB);
  settings.c_cc[VMIN] = 1;  // with 0, nothing there and nobody there would read alike
  settings.c_cc[VTIME] = 0;
  if (cfsetispeed(&settings, baud->code) != 0 || cfsetospeed(&settings, baud->code) != 0 ||
      tcsetattr(descriptor.number(), TCSANOW, &settings) != 0) {
    return Failed("'" + device + "'");
  }
  tcflush(descriptor.number(), TCIOFLUSH);
  return {.transport = TransportOf(descriptor.Take()), .reason = {}};
}

}  // namespace

std::unique_ptr<Transport> TransportOf(int descriptor) { return std::make_unique<FileTransport>(descriptor); }

OpenedTransport OpenTransport(std::string_view address) {
  const size_t colon = address.find(':');
  const std::string_view kind = address.substr(0, colon);
  const std::string place(colon == std::string_view::npos ? std::string_view() : address.substr(colon + 1));
  if (kind == "tcp") return OpenTcp(place);
  if (kind == "serial") return OpenSerial(place);
  if (kind == "socket") return OpenSocket(place);
  return {.transport = nullptr,
          .reason = "'" + std::string(address) + "' is none of tcp:HOST:PORT, serial:DEVICE:BAUD, socket:PATH"};
}

}  // namespace plcxx::debug_link
