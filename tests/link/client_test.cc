// The host's side of the link against the machine's side, over a wire that loses and changes bytes.

#include "transpiler/link/client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <algorithm>
#include <functional>
#include <random>
#include <string>

#include "tests/link/link_bench.h"
#include "transpiler/link/target.h"

namespace plcxx::debug_link {
namespace {

using plcxx_test::LinkedMachine;
using plcxx_test::Machine;
using plcxx_test::ReadOnly;
using plcxx_test::Writing;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// A period passes whenever somebody waits for bytes.
template <class Settings>
class MemoryWire : public Transport {
 public:
  bool Send(std::span<const uint8_t> bytes) override {
    Bytes sent(bytes.begin(), bytes.end());
    if (to_machine) to_machine(sent);
    bench.Send(sent);
    return !is_closed;
  }
  std::optional<Bytes> Receive(int) override {
    if (is_closed) return std::nullopt;
    bench.Period([this](Machine& machine) {
      if (program) program(machine);
    });
    Bytes bytes = std::exchange(bench.wire.from_machine, {});
    if (from_machine) from_machine(bytes);
    return bytes;
  }
  std::string WhyGone() const override { return "the connection is closed"; }

  LinkedMachine<Settings> bench;
  std::function<void(Machine&)> program;
  std::function<void(Bytes&)> to_machine, from_machine;
  bool is_closed = false;
};

constexpr int kShortMs = 20;

template <class T>
T Value(const Result<T>& result) {
  if (const auto* failure = std::get_if<Failure>(&result)) {
    ADD_FAILURE() << failure->text;
    return T{};
  }
  return std::get<T>(result);
}
template <class T>
std::string Text(const Result<T>& result) {
  const auto* failure = std::get_if<Failure>(&result);
  return failure == nullptr ? "no failure" : failure->text;
}

TEST(LinkClient, ReadsWhatIsThere) {
  MemoryWire<ReadOnly> wire;
  for (int i = 0; i < 100; ++i) wire.bench.machine.bytes[i] = static_cast<uint8_t>(i);
  Client client(wire);
  EXPECT_EQ(Value(client.ReadIdentity()), Bytes(std::begin(plcxx_test::kIdentity), std::end(plcxx_test::kIdentity)));
  const LinkLimits limits = Value(client.ReadLimits());
  EXPECT_EQ(limits.state_bytes, sizeof(Machine));
  EXPECT_EQ(limits.period_bytes, ReadOnly::kBytesPerPeriod);
  EXPECT_EQ(limits.can_write, 0);
  const Bytes all = Value(client.ReadState(16, 100));
  ASSERT_THAT(all, SizeIs(100));
  EXPECT_EQ(all[99], 99);
  EXPECT_GT(Value(client.ReadCounts()).scans, 3u);
  EXPECT_THAT(Text(client.ReadState(100, 17)), HasSubstr("no such byte"));
  EXPECT_THAT(client.Force(20, {0xFF}, {1}), HasSubstr("permits reading only"));
  wire.is_closed = true;
  EXPECT_THAT(Text(client.ReadState(0, 1)), HasSubstr("connection is closed"));
}

TEST(LinkClient, AsksAgainAndWritesOnce) {
  MemoryWire<Writing> wire;
  wire.bench.link.Permit(true);
  Client client(wire, kShortMs);
  wire.bench.machine.bytes[0] = 77;
  std::mt19937 random(1);
  // Every third answer has a wrong bit, every fifth request, too.
  int answers = 0, requests = 0;
  wire.from_machine = [&](Bytes& bytes) {
    if (!bytes.empty() && ++answers % 3 == 0) bytes[random() % bytes.size()] ^= 4;
  };
  wire.to_machine = [&](Bytes& bytes) {
    if (++requests % 5 == 0) bytes[random() % bytes.size()] ^= 4;
  };
  for (int i = 0; i < 50; ++i) EXPECT_THAT(Value(client.ReadState(16, 1)), ElementsAre(77));
  // A write whose answer is lost: done, not known, and not done twice.
  wire.to_machine = nullptr;
  wire.from_machine = [](Bytes& bytes) { bytes.clear(); };
  EXPECT_THAT(client.Write(20, {0xFF}, {5}), HasSubstr("it may be done or not"));
  EXPECT_EQ(wire.bench.machine.bytes[4], 5);
  wire.bench.machine.bytes[4] = 0;
  wire.from_machine = nullptr;
  EXPECT_THAT(Value(client.ReadState(16, 1)), ElementsAre(77)) << "the late answer to the write is not this one's";
  EXPECT_EQ(wire.bench.machine.bytes[4], 0);
}

TEST(LinkClient, BelievesNothingThatIsNoAnswer) {
  MemoryWire<ReadOnly> wire;
  Client client(wire, kShortMs);
  std::mt19937 random(7);
  wire.from_machine = [&](Bytes& bytes) {
    bytes.clear();
    for (int i = 0; i < 400; ++i) bytes.push_back(static_cast<uint8_t>(random() % 4 == 0 ? kLinkStart : random()));
  };
  EXPECT_THAT(Text(client.ReadIdentity()), HasSubstr("nobody answers"));
  EXPECT_THAT(Text(client.ReadLimits()), HasSubstr("nobody answers"));
  // Answers of any content with a right CRC and the right number.
  uint8_t number = 0;
  wire.to_machine = [&](Bytes& bytes) {
    if (bytes.size() > 3 && bytes[0] == kLinkStart) number = bytes[3];
  };
  wire.from_machine = [&](Bytes& bytes) {
    Bytes payload(random() % 65);
    for (uint8_t& byte : payload) byte = static_cast<uint8_t>(random());
    bytes = plcxx_test::Frame(random() % 2 == 0 ? uint8_t{0x80} : static_cast<uint8_t>(random()),
                              static_cast<uint32_t>(random()), payload, number);
  };
  const emit::layout::Layout layout{};
  int failures = 0;
  for (int i = 0; i < 3000; ++i) {
    Target target(client, layout);
    failures += target.Begin(Target::Length::kExact).empty() ? 0 : 1;
    failures += std::holds_alternative<Failure>(client.ReadState(0, 30)) ? 1 : 0;
    static_cast<void>(target.TakeSamples());
    static_cast<void>(target.Watch({{{.offset = 3}}}));
  }
  EXPECT_GT(failures, 3000);
}

TEST(LinkTarget, SamplesAreThoseOfEachScan) {
  MemoryWire<Writing> wire;
  uint8_t count = 0;
  wire.program = [&](Machine& machine) {
    machine.bytes[4] = ++count;
    machine.bytes[50] = static_cast<uint8_t>(count * 3);
  };
  Client client(wire);
  emit::layout::Layout layout{};
  layout.size = sizeof(Machine);
  Target target(client, layout);
  ASSERT_EQ(target.Begin(Target::Length::kExact), "");
  EXPECT_THAT(target.Begin(Target::Length::kLonger), HasSubstr("its State has 116 bytes"));
  const std::vector<Cell> first = {{.offset = 20}}, second = {{.offset = 66, .bit = 1, .bits = 1}};
  ASSERT_EQ(target.Watch({first, second}), "");
  uint32_t last = 0, samples = 0;
  for (int i = 0; i < 200; ++i) {
    for (const TraceSample& sample : Value(target.TakeSamples())) {
      const uint64_t value = ValueOf(first, sample.bytes);
      EXPECT_EQ(ValueOf(second, sample.bytes), (value * 3 >> 1) & 1);
      if (last != 0) {
        EXPECT_GT(sample.scan, last);
      }
      last = sample.scan;
      ++samples;
    }
  }
  EXPECT_GT(samples, 100u);
  std::vector<std::vector<Cell>> many;
  for (uint32_t i = 0; i < 17; ++i) many.push_back({{.offset = 3 * i}});
  EXPECT_THAT(target.Watch(many), HasSubstr("17 places"));
  std::vector<Cell> wide;
  for (uint32_t i = 0; i < 70; ++i) wide.push_back({.offset = i});
  EXPECT_THAT(target.Watch({wide}), HasSubstr("does not fit"));
}

TEST(LinkTarget, ForcesAndReleasesPartsOfBytes) {
  MemoryWire<Writing> wire;
  wire.bench.link.Permit(true);
  wire.program = [](Machine& machine) { machine.bytes[4] = machine.bytes[5] = 0xF0; };
  Client client(wire);
  emit::layout::Layout layout{};
  layout.size = sizeof(Machine);
  Target target(client, layout);
  ASSERT_EQ(target.Begin(Target::Length::kExact), "");
  // A number of ten bits: eight in one byte, two within another one.
  const std::vector<Cell> cells = {{.offset = 20, .bit = 0, .bits = 8, .at = 0},
                                   {.offset = 21, .bit = 2, .bits = 2, .at = 8}};
  EXPECT_EQ(target.Force(cells, 0x2A5), "");
  EXPECT_EQ(Value(target.Read(cells)), 0x2A5u);
  EXPECT_EQ(wire.bench.machine.bytes[5], 0xF8);
  EXPECT_EQ(target.Release(cells), "");
  EXPECT_EQ(Value(target.Counts()).forced, 0);
  EXPECT_EQ(Value(target.Read(cells)), 0xF0u);
  for (uint32_t i = 0; i < Writing::kForces; ++i) EXPECT_EQ(target.Force({{.offset = 30 + 2 * i}}, 1), "");
  EXPECT_THAT(target.Force({{.offset = 90}}, 1), HasSubstr("no room"));
}

TEST(LinkTransport, AddressesAreReadAndWrongOnesRefused) {
  EXPECT_THAT(OpenTransport("").reason, HasSubstr("none of tcp:HOST:PORT"));
  EXPECT_THAT(OpenTransport("telnet:x:1").reason, HasSubstr("none of tcp:HOST:PORT"));
  EXPECT_THAT(OpenTransport("tcp:").reason, HasSubstr("no host and port"));
  EXPECT_THAT(OpenTransport("tcp:localhost").reason, HasSubstr("no host and port"));
  EXPECT_THAT(OpenTransport("tcp:127.0.0.1:1").reason, HasSubstr("no connection"));
  EXPECT_THAT(OpenTransport("socket:/nowhere/at/all").reason, HasSubstr("no connection"));
  EXPECT_THAT(OpenTransport("socket:" + std::string(300, 'x')).reason, HasSubstr("no path"));
  EXPECT_THAT(OpenTransport("serial:/dev/null:7").reason, HasSubstr("baud rate"));
  EXPECT_THAT(OpenTransport("serial:/dev/null").reason, HasSubstr("/dev/null"));
  EXPECT_THAT(OpenTransport("serial:/nowhere:115200").reason, HasSubstr("/nowhere"));
}

TEST(LinkTransport, ASilentEndIsWaitedForAndAClosedOneIsNoticed) {
  int ends[2] = {};
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends), 0);
  const std::unique_ptr<Transport> near = TransportOf(ends[0]);
  std::unique_ptr<Transport> far = TransportOf(ends[1]);
  EXPECT_EQ(near->Receive(10), Bytes());
  EXPECT_TRUE(far->Send(Bytes{1, 2, 3}));
  EXPECT_EQ(near->Receive(1000), (Bytes{1, 2, 3}));
  Client client(*near, kShortMs);
  EXPECT_THAT(Text(client.ReadLimits()), HasSubstr("nobody answers"));
  far.reset();
  EXPECT_EQ(near->Receive(10), std::nullopt);
  EXPECT_THAT(near->WhyGone(), HasSubstr("the connection is closed"));
  EXPECT_FALSE(near->Send(Bytes{1}));
  EXPECT_EQ(near->WhyGone(), "the connection is closed: broken pipe");  // the words of the system
}

TEST(LinkTransport, AnEndThatTakesNothingIsGivenUp) {
  int ends[2] = {};
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends), 0);
  const std::unique_ptr<Transport> near = TransportOf(ends[0]), far = TransportOf(ends[1]);
  EXPECT_FALSE(near->Send(Bytes(10'000'000)));
  EXPECT_EQ(near->WhyGone(), "the connection takes nothing for 2 s");
}

TEST(Address, IsWrongAsItIsWrittenOrNobodyIsThere) {
  for (const char* right : {"tcp:10.0.0.7:5020", "tcp:[::1]:1", "tcp:machine:65535", "serial:/dev/ttyUSB0",
                            "serial:/dev/ttyUSB0:9600", "socket:/tmp/qemu.socket"})
    EXPECT_EQ(WrongAddress(right), "") << right;
  EXPECT_EQ(WrongAddress("station.socket"),
            "'station.socket' is none of tcp:HOST:PORT, serial:DEVICE:BAUD, socket:PATH");
  EXPECT_EQ(WrongAddress("tcp:10.0.0.7"), "'tcp:10.0.0.7' has no host and port: tcp:HOST:PORT");
  // 99999 is 34463 in 16 bits: another machine's port.
  for (const char* port : {"0", "65536", "99999", "-1", "http", "1x"})
    EXPECT_EQ(WrongAddress("tcp:m:" + std::string(port)), "'" + std::string(port) + "' is no port: 1 to 65535");
  EXPECT_EQ(WrongAddress("serial:/dev/ttyS0:123"), "'/dev/ttyS0:123' has no baud rate of 9600, 19200 ... 921600");
  EXPECT_EQ(WrongAddress("serial:"), "'serial:' has no device: serial:DEVICE:BAUD");
  EXPECT_EQ(WrongAddress("socket:"), "'' is no path of a socket");
  EXPECT_EQ(OpenTransport("tcp:m:99999").reason, WrongAddress("tcp:m:99999"));
  EXPECT_EQ(OpenTransport("socket:/nowhere").reason,
            "no connection to '/nowhere': no such file or directory; is the machine on, and is its link there?");
  EXPECT_THAT(OpenTransport("serial:/dev/null").reason, HasSubstr("; it is no serial line"));
}

}  // namespace
}  // namespace plcxx::debug_link
