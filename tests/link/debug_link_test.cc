// The machine's side of the link: each command, each refusal, and that no bytes do more than they are allowed to.

#include "plcxx/debug_link.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

#include "tests/link/link_bench.h"
#include "tests/temporary_directory.h"

namespace plcxx {
namespace {

using plcxx_test::Bytes;
using plcxx_test::Frame;
using plcxx_test::LinkedMachine;
using plcxx_test::Machine;
using plcxx_test::ReadOnly;
using plcxx_test::Writing;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr uint8_t kCheck[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
static_assert(LinkCrc(kCheck, 9) == 0x29B1, "the polynomial's published check value");

struct Answer {
  LinkStatus status{};
  uint8_t number = 0;
  uint32_t offset = 0;
  Bytes payload;
};

/// The one answer on the wire, which is taken away.
template <class Settings>
Answer Take(LinkedMachine<Settings>& bench) {
  const Bytes bytes = std::exchange(bench.wire.from_machine, {});
  Answer answer;
  if (bytes.size() < 10 || bytes[0] != kLinkStart || bytes.size() != 10U + bytes[1]) {
    ADD_FAILURE() << "no answer, or more than one: " << testing::PrintToString(bytes);
    return answer;
  }
  EXPECT_EQ(LinkCrc(bytes.data() + 1, static_cast<uint32_t>(bytes.size() - 1)), 0);
  answer.status = static_cast<LinkStatus>(bytes[2]);
  answer.number = bytes[3];
  for (int i = 0; i < 4; ++i) answer.offset |= static_cast<uint32_t>(bytes[4 + i]) << (8 * i);
  answer.payload.assign(bytes.begin() + 8, bytes.end() - 2);
  return answer;
}

template <class Settings>
Answer Ask(LinkedMachine<Settings>& bench, const Bytes& frame) {
  bench.Send(frame);
  for (int i = 0; i < 4; ++i) bench.Period();
  return Take(bench);
}

uint32_t Word(const Bytes& bytes, size_t at) {
  uint32_t word = 0;
  for (size_t i = 0; i < 4; ++i) word |= static_cast<uint32_t>(bytes.at(at + i)) << (8 * i);
  return word;
}

TEST(DebugLink, SaysWhoItIsAndWhatItAllows) {
  LinkedMachine<ReadOnly> bench;
  Answer answer = Ask(bench, Frame(LinkCommand::kIdentity, 0, {64}, 42));
  EXPECT_EQ(answer.status, LinkStatus::kDone);
  EXPECT_EQ(answer.number, 42);
  EXPECT_EQ(answer.payload, Bytes(std::begin(plcxx_test::kIdentity), std::end(plcxx_test::kIdentity)));
  EXPECT_THAT(Ask(bench, Frame(LinkCommand::kIdentity, 62, {2})).payload, ElementsAre(0, 0));
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kIdentity, 62, {3})).status, LinkStatus::kOutside);
  answer = Ask(bench, Frame(LinkCommand::kLimits, 0, {sizeof(LinkLimits)}));
  EXPECT_THAT(Bytes(answer.payload.begin(), answer.payload.begin() + 3), ElementsAre(kLinkVersion, 0, 0));
  EXPECT_EQ(Word(answer.payload, 4), sizeof(Machine));
  EXPECT_EQ(Word(answer.payload, 12), ReadOnly::kBytesPerPeriod);
  LinkedMachine<Writing> writing;
  answer = Ask(writing, Frame(LinkCommand::kLimits, 0, {sizeof(LinkLimits)}));
  EXPECT_THAT(Bytes(answer.payload.begin(), answer.payload.begin() + 3), ElementsAre(kLinkVersion, 1, 6));
}

TEST(DebugLink, ReadsWithinStateOnly) {
  LinkedMachine<ReadOnly> bench;
  bench.machine.bytes[99] = 9;
  EXPECT_THAT(Ask(bench, Frame(LinkCommand::kRead, 114, {2})).payload, ElementsAre(0, 9));
  EXPECT_THAT(Ask(bench, Frame(LinkCommand::kRead, 0, {64})).payload, SizeIs(64));
  for (const auto& [offset, count] : {std::pair<uint32_t, uint8_t>{115, 2}, {116, 1}, {117, 0}, {0xFFFFFFFF, 1}}) {
    const Answer answer = Ask(bench, Frame(LinkCommand::kRead, offset, {count}));
    EXPECT_EQ(answer.status, LinkStatus::kOutside) << offset;
    EXPECT_THAT(answer.payload, IsEmpty());
  }
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kRead, 0, {65})).status, LinkStatus::kUnknown);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kRead, 0, {1, 1})).status, LinkStatus::kUnknown);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kRead, 0, {})).status, LinkStatus::kUnknown);
  EXPECT_EQ(Ask(bench, Frame(99, 0, {1})).status, LinkStatus::kUnknown);
  for (const Bytes& payload : {Bytes{}, Bytes{1}, Bytes{1, 2, 3}})
    EXPECT_EQ(Ask(bench, Frame(LinkCommand::kWatch, 40, payload)).status, LinkStatus::kUnknown);
}

TEST(DebugLink, IsReadOnlyUntilItIsPermitted) {
  LinkedMachine<ReadOnly> without;
  without.link.Permit(true);
  LinkedMachine<Writing> bench;
  for (const LinkCommand command : {LinkCommand::kWrite, LinkCommand::kForce}) {
    EXPECT_EQ(Ask(without, Frame(command, 20, {0xFF, 5})).status, LinkStatus::kReadOnly);
    EXPECT_EQ(Ask(bench, Frame(command, 20, {0xFF, 5})).status, LinkStatus::kReadOnly);
  }
  EXPECT_EQ(without.machine.bytes[4], 0);
  EXPECT_EQ(bench.machine.bytes[4], 0);
  bench.link.Permit(true);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kWrite, 20, {0x0F, 0xF5})).status, LinkStatus::kDone);
  EXPECT_EQ(bench.machine.bytes[4], 5);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kForce, 20, {0xFF, 5})).status, LinkStatus::kDone);
  EXPECT_EQ(bench.link.counts().forced, 1);
  bench.link.Permit(false);
  EXPECT_EQ(bench.link.counts().forced, 0) << "what is forced is let go";
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kWrite, 20, {0xFF, 1})).status, LinkStatus::kReadOnly);
}

TEST(DebugLink, ForcesHoldAgainstInputsAndProgram) {
  LinkedMachine<Writing> bench;
  bench.link.Permit(true);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kForce, 20, {0x02, 0xFF, 0x02, 0x31})).status, LinkStatus::kDone);
  uint8_t seen = 0;
  bench.machine.bytes[4] = 0;  // as the inputs are read
  bench.Period([&](Machine& machine) {
    seen = machine.bytes[4];
    machine.bytes[4] = 0xF0;
    machine.bytes[5] = 7;
  });
  EXPECT_EQ(seen, 0x02);
  EXPECT_EQ(bench.machine.bytes[4], 0xF2) << "bits that are not forced are the program's";
  EXPECT_EQ(bench.machine.bytes[5], 0x31);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kForce, 20, {0, 0})).status, LinkStatus::kDone);
  bench.Period([](Machine& machine) { machine.bytes[4] = machine.bytes[5] = 0; });
  EXPECT_EQ(bench.machine.bytes[4], 0);
  EXPECT_EQ(bench.machine.bytes[5], 0x31);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kForce, 0, {})).status, LinkStatus::kDone);
  EXPECT_EQ(bench.link.counts().forced, 0);
}

TEST(DebugLink, ForcesOfAWholeValueOrNothing) {
  LinkedMachine<Writing> bench;
  bench.link.Permit(true);
  const Bytes masks(4, 0xFF);
  const auto word = [&](uint8_t value) {
    Bytes payload = masks;
    payload.insert(payload.end(), 4, value);
    return payload;
  };
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kForce, 20, word(1))).status, LinkStatus::kDone);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kForce, 30, word(2))).status, LinkStatus::kNoRoom);
  EXPECT_EQ(bench.machine.bytes[14], 0);
  EXPECT_EQ(bench.link.counts().forced, 4);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kForce, 20, word(3))).status, LinkStatus::kDone) << "the same one again";
  EXPECT_EQ(bench.link.counts().forced, 4);
  EXPECT_EQ(bench.machine.bytes[7], 3);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kForce, 113, word(3))).status, LinkStatus::kOutside);
}

TEST(DebugLink, AValueOfWhichAPartIsForcedNeedsRoomForTheRest) {
  LinkedMachine<Writing> bench;
  bench.link.Permit(true);
  for (const uint32_t at : {20U, 40U, 41U, 42U, 43U}) Ask(bench, Frame(LinkCommand::kForce, at, {0xFF, 1}));
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kForce, 20, {0xFF, 0xFF, 0xFF, 5, 6, 7})).status, LinkStatus::kNoRoom);
  EXPECT_EQ(bench.link.counts().forced, 5);
  EXPECT_THAT(Bytes(bench.machine.bytes + 4, bench.machine.bytes + 7), ElementsAre(1, 0, 0)) << "no part of it";
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kForce, 20, {0xFF, 0xFF, 5, 6})).status, LinkStatus::kDone);
  EXPECT_EQ(bench.link.counts().forced, 6);
  EXPECT_THAT(Bytes(bench.machine.bytes + 4, bench.machine.bytes + 7), ElementsAre(5, 6, 0));
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kForce, 21, {0, 0})).status, LinkStatus::kDone);
  EXPECT_EQ(bench.link.counts().forced, 5);
  // The one beside it takes its place in the list, and stays forced.
  bench.machine.bytes[4] = bench.machine.bytes[5] = bench.machine.bytes[27] = 0;
  bench.Period();
  EXPECT_EQ(bench.machine.bytes[4], 5);
  EXPECT_EQ(bench.machine.bytes[5], 0);
  EXPECT_EQ(bench.machine.bytes[27], 1);
}

TEST(DebugLink, ForcesEndWithTheConnection) {
  LinkedMachine<Writing> bench;
  bench.link.Permit(true);
  Ask(bench, Frame(LinkCommand::kForce, 20, {0xFF, 1}));
  for (uint32_t i = 0; i < 3 * Writing::kSilentPeriods; ++i) {
    if (i % 10 == 0) Ask(bench, Frame(LinkCommand::kRead, 0, {1}));
    bench.Period();
  }
  EXPECT_EQ(bench.link.counts().forced, 1) << "somebody is there";
  for (uint32_t i = 0; i <= Writing::kSilentPeriods; ++i) bench.Period();
  EXPECT_EQ(bench.link.counts().forced, 0);
}

TEST(DebugLink, TracesEachScanAndCountsWhatIsLost) {
  LinkedMachine<Writing> bench;
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kWatch, 20, {0, 2})).status, LinkStatus::kDone);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kWatch, 30, {15, 1})).status, LinkStatus::kDone);
  const uint32_t begin = bench.link.counts().begin;
  // Records of 7 bytes: 9 of them are in the ring of 64 bytes.
  uint8_t value = 0;
  const auto period = [&] {
    bench.Period([&](Machine& machine) {
      machine.bytes[4] = ++value;
      machine.bytes[14] = static_cast<uint8_t>(2 * value);
    });
  };
  for (int i = 0; i < 5; ++i) period();
  EXPECT_EQ(bench.link.counts().lost, 0u);
  Bytes trace;
  uint32_t at = begin;
  for (int i = 0; i < 400; ++i) {
    // At the end faster than the samples come, so that none is still to be seen as a gap.
    bench.Send(Frame(LinkCommand::kTrace, at, {static_cast<uint8_t>(i < 350 ? 20 : 60)}));
    do period();
    while (bench.wire.from_machine.empty());
    const Answer answer = Take(bench);
    ASSERT_EQ(answer.status, LinkStatus::kDone);
    ASSERT_EQ(answer.offset, at);
    at += static_cast<uint32_t>(answer.payload.size());
    trace.insert(trace.end(), answer.payload.begin(), answer.payload.end());
    if (i == 200) {
      for (int k = 0; k < 100; ++k) period();
    }
  }
  ASSERT_GT(trace.size(), 300u * 7);
  uint32_t gaps = 0, last = Word(trace, 0) - 1;
  for (size_t record = 0; record + 7 <= trace.size(); record += 7) {
    const uint32_t scan = Word(trace, record);
    gaps += scan - last - 1;
    last = scan;
    EXPECT_EQ(static_cast<uint8_t>(2 * trace[record + 4]), trace[record + 6]) << "one sample is of one scan";
  }
  EXPECT_GT(bench.link.counts().lost, 85u);
  EXPECT_EQ(gaps, bench.link.counts().lost);
  // An answer that was lost on the wire is asked for once more; an offset of long ago begins anew.
  const uint32_t there = bench.link.counts().begin;
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kTrace, there, {7})).payload,
            Ask(bench, Frame(LinkCommand::kTrace, there, {7})).payload);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kTrace, there - 500, {7})).offset, there);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kWatch, 0, {16, 1})).status, LinkStatus::kUnknown);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kWatch, 0, {1, 9})).status, LinkStatus::kUnknown);
  EXPECT_EQ(Ask(bench, Frame(LinkCommand::kWatch, 115, {1, 2})).status, LinkStatus::kOutside);
}

TEST(DebugLink, NeverMoreThanTheDeclaredBytes) {
  LinkedMachine<ReadOnly> bench;
  for (int i = 0; i < 100; ++i) bench.Send(Frame(LinkCommand::kRead, 0, {64}));
  uint64_t moved = 0;
  uint32_t most = 0;
  for (int i = 0; i < 200; ++i) {
    bench.Period();
    most = std::max(most, bench.wire.moved);
    moved += bench.wire.moved;
  }
  EXPECT_EQ(most, ReadOnly::kBytesPerPeriod);
  EXPECT_EQ(moved, 100u * (11 + 74)) << "all are answered in the end";
  bench.wire.from_machine.clear();
  bench.wire.is_full = true;
  bench.Send(Frame(LinkCommand::kRead, 0, {64}));
  bench.Send(Bytes(1000, 0xA5));
  for (int i = 0; i < 50; ++i) bench.Period();
  EXPECT_EQ(bench.wire.to_machine.size(), 1000u) << "who does not read what he asked for is not listened to";
}

TEST(DebugLink, FindsTheNextFrameAfterRubbish) {
  LinkedMachine<ReadOnly> bench;
  const Bytes good = Frame(LinkCommand::kRead, 0, {1});
  for (const Bytes& rubbish :
       {Bytes{0xA5}, Bytes{0xA5, 0xFF}, Bytes{0xA5, 64, 3}, Bytes(good.begin(), good.end() - 1), Bytes(73, 0xA5)}) {
    bench.Send(rubbish);
    // What a host does before it asks again: no frame is longer.
    bench.Send(Bytes(kLinkFrame, 0));
    EXPECT_EQ(Ask(bench, good).status, LinkStatus::kDone) << testing::PrintToString(rubbish);
  }
  // A length that no frame has ends it at once.
  bench.Send({kLinkStart, kLinkPayload + 1});
  EXPECT_EQ(Ask(bench, good).status, LinkStatus::kDone);
  for (size_t i = 1; i < good.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      Bytes wrong = good;
      wrong[i] ^= static_cast<uint8_t>(1 << bit);
      bench.Send(wrong);
      bench.Send(Bytes(kLinkFrame, 0));
      for (int period = 0; period < 4; ++period) bench.Period();
      EXPECT_THAT(bench.wire.from_machine, IsEmpty()) << "byte " << i << ", bit " << bit;
    }
  }
}

// ---- with compilers as child processes

const std::string kRoot = PLCXX_ROOT;

bool Succeeds(const std::string& command) { return std::system(command.c_str()) == 0; }

TEST(DebugLink, NoBytesDoAnythingUndefined) {
  if (!Succeeds("g++ --version >/dev/null 2>&1")) GTEST_SKIP() << "no compiler";
  const testing_support::TemporaryDirectory directory;
  const std::string program = directory.File("link_bytes");
  ASSERT_TRUE(Succeeds(
      "g++ -std=c++20 -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -Wall -Wextra -Werror -I" + kRoot +
      " -I" + kRoot + "/runtime_support " + kRoot + "/tests/link/fixtures/link_bytes.cc -o " + program));
  EXPECT_TRUE(Succeeds(program + " 60000"));
}

/// All of the link in a Cortex-M4's flash, but the program's identity.
uint64_t LinkBytes(const std::string& flags) {
  const testing_support::TemporaryDirectory directory;
  const std::string object = directory.File("link.o"), list = directory.File("sizes");
  if (!Succeeds(
          "arm-none-eabi-g++ -mcpu=cortex-m4 -mthumb -std=c++17 -ffreestanding -fno-exceptions -fno-rtti -Wall -Wextra "
          "-Wconversion -Wshadow -Wsign-conversion -Werror " +
          flags + " -I" + kRoot + "/runtime_support -c " + kRoot + "/tests/link/fixtures/link_size.cc -o " + object) ||
      !Succeeds("arm-none-eabi-size -A " + object + " >" + list)) {
    ADD_FAILURE() << flags;
    return 0;
  }
  std::ifstream file(list);
  uint64_t bytes = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(".text") || line.starts_with(".rodata") || line.starts_with(".data") ||
        line.starts_with(".init_array")) {
      bytes += std::stoull(line.substr(line.find(' ')));
    }
  }
  return bytes - kLinkIdentityBytes;
}

TEST(DebugLink, IsAtMostOneKilobyteOnACortexM4) {
  if (!Succeeds("arm-none-eabi-g++ --version >/dev/null 2>&1")) GTEST_SKIP() << "no compiler for it";
  for (const std::string level : {"-Os", "-O2"}) {
    const uint64_t reading = LinkBytes(level + " -DCAN_WRITE=false"), writing = LinkBytes(level + " -DCAN_WRITE=true");
    EXPECT_LE(writing, 1024u) << level;
    EXPECT_LE(reading, 768u) << level << ": without code that writes";
    EXPECT_GT(reading, 300u) << level << ": was it measured?";
    EXPECT_GT(writing, reading) << level;
    RecordProperty("bytes" + level + "_reading", std::to_string(reading));
    RecordProperty("bytes" + level + "_writing", std::to_string(writing));
  }
}

}  // namespace
}  // namespace plcxx
