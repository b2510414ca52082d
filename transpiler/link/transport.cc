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
#include <utility>
#include <variant>

#include "transpiler/support/check.h"
#include "transpiler/support/system_words.h"

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
        if (IsReady(end_.number(), POLLOUT, kSendMs)) continue;
        why_gone_ = "the connection takes nothing for " + std::to_string(kSendMs / 1000) + " s";
        return false;
      }
      if (count < 0) return Closed(errno);
      bytes = bytes.subspan(static_cast<size_t>(count));
    }
    return true;
  }

  std::optional<Bytes> Receive(int wait_ms) override {
    if (!IsReady(end_.number(), POLLIN, wait_ms)) return Bytes();
    Bytes bytes(kPiece);
    const ssize_t count = read(end_.number(), bytes.data(), bytes.size());
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return Bytes();
    if (count <= 0) {
      Closed(count < 0 ? errno : 0);
      return std::nullopt;
    }
    bytes.resize(static_cast<size_t>(count));
    return bytes;
  }

  std::string WhyGone() const override { return why_gone_; }

 private:
  /// `error`: the system's, or 0 where the other end has just ended. False, for Send.
  bool Closed(int error) {
    why_gone_ = "the connection is closed";
    if (error != 0) why_gone_ += ": " + support::SystemWords(error);
    return false;
  }

  Descriptor end_;
  std::string why_gone_;
};

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

struct Baud {
  int rate;
  speed_t code;
};
constexpr Baud kBauds[] = {{9600, B9600},     {19200, B19200},   {38400, B38400},   {57600, B57600},
                           {115200, B115200}, {230400, B230400}, {460800, B460800}, {921600, B921600}};
constexpr int kUsualRate = 115200;

enum class Wire { kTcp, kSerial, kSocket };
struct Address {
  Wire wire = Wire::kTcp;
  std::string place;  // the host, the device or the path
  std::string port;   // of kTcp
  speed_t baud = 0;   // of kSerial
};

std::optional<int> WholeNumber(std::string_view text) {
  int number = 0;
  const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && last == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// An address, or what is wrong with it as it is written.
using ParsedAddress = std::variant<Address, std::string>;

ParsedAddress ParseTcp(const std::string& text) {
  constexpr int kMaxPort = 65535;
  const size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == text.size()) {
    return "'tcp:" + text + "' has no host and port: tcp:HOST:PORT";
  }
  Address address{.wire = Wire::kTcp, .place = text.substr(0, colon), .port = text.substr(colon + 1), .baud = 0};
  const std::optional<int> port = WholeNumber(address.port);
  if (!port || *port < 1 || *port > kMaxPort) return "'" + address.port + "' is no port: 1 to 65535";
  std::string& host = address.place;
  if (host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  return address;
}

ParsedAddress ParseSerial(const std::string& text) {
  const size_t colon = text.rfind(':');
  const std::string device = text.substr(0, colon);
  if (device.empty()) return "'serial:" + text + "' has no device: serial:DEVICE:BAUD";
  const int rate =
      colon == std::string::npos ? kUsualRate : WholeNumber(std::string_view(text).substr(colon + 1)).value_or(0);
  for (const Baud& known : kBauds) {
    if (known.rate == rate) return Address{.wire = Wire::kSerial, .place = device, .port = {}, .baud = known.code};
  }
  return "'" + text + "' has no baud rate of 9600, 19200 ... 921600";
}

ParsedAddress ParseSocket(const std::string& path) {
  if (path.empty() || path.size() >= sizeof sockaddr_un().sun_path) return "'" + path + "' is no path of a socket";
  return Address{.wire = Wire::kSocket, .place = path, .port = {}, .baud = 0};
}

ParsedAddress ParseAddress(std::string_view text) {
  const size_t colon = text.find(':');
  const std::string_view kind = text.substr(0, colon);
  const std::string place(colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1));
  if (kind == "tcp") return ParseTcp(place);
  if (kind == "serial") return ParseSerial(place);
  if (kind == "socket") return ParseSocket(place);
  return "'" + std::string(text) + "' is none of tcp:HOST:PORT, serial:DEVICE:BAUD, socket:PATH";
}

/// What to look at where nothing listens.
std::string Remedy(int error) {
  switch (error) {
    case ECONNREFUSED:
    case ENOENT:
      return "; is the machine on, and is its link there?";
    case EACCES:
    case EPERM:
      return "; this user has no right to it";
    case ETIMEDOUT:
    case EHOSTUNREACH:
    case ENETUNREACH:
      return "; is the machine on, and the network in between?";
    case ENOTTY:
      return "; it is no serial line";
    default:
      return "";
  }
}

OpenedTransport Failed(const std::string& what) {
  const int error = errno;
  return {.transport = nullptr, .reason = what + ": " + support::SystemWords(error) + Remedy(error)};
}

OpenedTransport OpenTcp(const Address& wanted) {
  addrinfo hints = {};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (const int error = getaddrinfo(wanted.place.c_str(), wanted.port.c_str(), &hints, &found); error != 0) {
    return {.transport = nullptr, .reason = "'" + wanted.place + "' is not found: " + gai_strerror(error)};
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
  return Failed("no connection to " + wanted.place + ":" + wanted.port);
}

OpenedTransport OpenSocket(const Address& wanted) {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  wanted.place.copy(address.sun_path, wanted.place.size());
  Descriptor descriptor(socket(AF_UNIX, SOCK_STREAM | kSocketFlags, 0));
  if (descriptor.number() < 0 ||
      !Connects(descriptor.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address)) {
    return Failed("no connection to '" + wanted.place + "'");
  }
  return {.transport = TransportOf(descriptor.Take()), .reason = {}};
}

OpenedTransport OpenSerial(const Address& wanted) {
  Descriptor descriptor(open(wanted.place.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK));
  termios settings = {};
  if (descriptor.number() < 0 || tcgetattr(descriptor.number(), &settings) != 0) {
    return Failed("'" + wanted.place + "'");
  }
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS | CSTOPB);
  settings.c_cc[VMIN] = 1;  // with 0, nothing there and nobody there would read alike
  settings.c_cc[VTIME] = 0;
  if (cfsetispeed(&settings, wanted.baud) != 0 || cfsetospeed(&settings, wanted.baud) != 0 ||
      tcsetattr(descriptor.number(), TCSANOW, &settings) != 0) {
    return Failed("'" + wanted.place + "'");
  }
  tcflush(descriptor.number(), TCIOFLUSH);
  return {.transport = TransportOf(descriptor.Take()), .reason = {}};
}

}  // namespace

std::unique_ptr<Transport> TransportOf(int descriptor) { return std::make_unique<FileTransport>(descriptor); }

std::string WrongAddress(std::string_view address) {
  const ParsedAddress parsed = ParseAddress(address);
  const auto* wrong = std::get_if<std::string>(&parsed);
  return wrong != nullptr ? *wrong : std::string();
}

OpenedTransport OpenTransport(std::string_view address) {
  const ParsedAddress parsed = ParseAddress(address);
  if (const auto* wrong = std::get_if<std::string>(&parsed)) return {.transport = nullptr, .reason = *wrong};
  const auto& wanted = std::get<Address>(parsed);
  switch (wanted.wire) {
    case Wire::kTcp:
      return OpenTcp(wanted);
    case Wire::kSerial:
      return OpenSerial(wanted);
    case Wire::kSocket:
      return OpenSocket(wanted);
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::debug_link
