// The loop of Linux, its files, and what hands over between its threads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <plcxx_host/pins.h>
#include <plcxx_host/real_time.h>
#include <plcxx_host/retentive_files.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "tests/host/host_program.h"
#include "tests/temporary_directory.h"

namespace plcxx::host {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kIo = R"(#include <stdio.h>
#include <plcxx_host/posix.h>
#include "fan_pins.hpp"
using At = fan::Host::At;
namespace plcxx::host {
static int periods = 0;
bool io_open(int argc, char** argv) noexcept { return argc == 0 || argv[0][0] != 'x'; }
void io_read(Value* pins) noexcept {
  pins[At::I0A0].bit = true;
  pins[At::W1A0].u32 = 300;  // more than the place holds
  pins[At::I0A2].bit = ++periods > 1;
}
void io_write(const Value* pins) noexcept {
  if (periods == 1 || periods == 22 || periods == 23)
    printf("%d: pump %d, lamp %d, kept %u\n", periods, pins[At::PUMP].bit, pins[At::LAMP].bit, static_cast<unsigned>(pins[At::KEPT].u32));
}
void io_close() noexcept { printf("closed\n"); }
}
)";

TEST(PosixLoop, RunsPeriodsUntilItsEnd) {
  const HostProgram program("posix");
  EXPECT_EQ(program.emitted.code, 0) << program.emitted;
  program.work.Write("io.cpp", kIo);
  ASSERT_EQ(program.Compile("out/fan.cpp out/fan_pins.cpp out/fan_posix.cpp io.cpp", ""), "");
  std::filesystem::create_directories(program.work.Path("kept"));
  const driver::Ran ran = program.Talk("--periods 25 --retentive kept", "");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.out, HasSubstr("1: pump 1, lamp 0, kept 255\n"));
  EXPECT_THAT(ran.out, HasSubstr("closed\n"));
  EXPECT_THAT(ran.errors, HasSubstr("fan: 25 periods of 10 ms: late by "));
  EXPECT_TRUE(std::filesystem::exists(program.work.Path("kept/fan.a")));

  struct Wrong {
    const char *words, *message;
  };
  const Wrong kWrong[] = {
      {"--periods none", "fan: 'none': no number of periods: 1 or more\n"},
      {"--periods -1", "fan: '-1': no number of periods: 1 or more\n"},  // not 2^64 - 1
      {"--periods 0", "fan: '0': no number of periods: 1 or more\n"},
      {"--periods", "fan: '--periods': needs a value\n"},
      {"--priority 100", "fan: '100': no priority: 1 to 99\n"},
      {"--periods 5 --periods 6", "fan: '--periods': given twice\n"},
      {"--periode 5", "fan: '--periode': no option of the loop; what is meant for the terminals comes after --\n"},
  };
  for (const Wrong& wrong : kWrong) {
    const driver::Ran refused = program.Talk(wrong.words, "");
    EXPECT_EQ(refused.code, 2) << refused;
    EXPECT_THAT(refused.errors, HasSubstr(std::string(wrong.message) + "usage: fan [--retentive FOLDER]"));
  }
  const driver::Ran help = program.Talk("--help", "");
  EXPECT_EQ(help.code, 0);
  EXPECT_THAT(help.out, HasSubstr("usage: fan [--retentive FOLDER]"));
  EXPECT_THAT(program.Talk("--periods 1 --retentive io.cpp", "").errors,
              HasSubstr("retentive memory is not kept: io.cpp: Not a directory"));
  EXPECT_EQ(program.Talk("--periods 5 -- x", "").code, 1);
}

TEST(PosixLoop, AnOverrunIsCountedAndLeavesPeriodsOut) {
  Punctuality seen;
  int calls = 0;
  uint64_t left_out = 0;
  RunPeriods(2 * kNsPerMs, seen, [&](int64_t, uint64_t missed) {
    left_out += missed;
    if (++calls == 3) std::this_thread::sleep_for(std::chrono::milliseconds(9));
    return calls < 8;
  });
  EXPECT_EQ(seen.periods, 8U);
  EXPECT_GE(seen.overruns, 1U);
  EXPECT_GE(seen.missed, 4U);  // more on a machine that is busy
  EXPECT_EQ(left_out, seen.missed);
  EXPECT_GE(seen.longest_ns, 9 * kNsPerMs);
}

using Block = std::array<uint8_t, 40>;
Block Filled(uint8_t value) {
  Block block;
  block.fill(value);
  return block;
}

TEST(RetentiveFiles, TheNewestWholeOneCounts) {
  const testing_support::TemporaryDirectory directory;
  const std::string folder = directory.path().string();
  Block block = Filled(0);
  {
    RetentiveFiles files;
    ASSERT_TRUE(files.Open(folder.c_str(), "m"));
    EXPECT_EQ(files.Load(block.data(), block.size()), Loaded::kNothing);
    for (uint8_t i = 1; i <= 5; ++i) EXPECT_TRUE(files.Store(Filled(i).data(), block.size()));
  }
  RetentiveFiles files;
  ASSERT_TRUE(files.Open(folder.c_str(), "m"));
  EXPECT_EQ(files.Load(block.data(), block.size()), Loaded::kContent);
  EXPECT_EQ(block, Filled(5));
  Block other{};
  EXPECT_EQ(files.Load(other.data(), other.size() - 1), Loaded::kOtherSize);
  EXPECT_EQ(other, Block{});
}

// A loss of power leaves any part of the newest file, or of the one that was being written.
TEST(RetentiveFiles, WhateverALossOfPowerLeavesOneOfTwoIsWhole) {
  const testing_support::TemporaryDirectory directory;
  const std::string folder = directory.path().string();
  RetentiveFiles files;
  ASSERT_TRUE(files.Open(folder.c_str(), "m"));
  ASSERT_TRUE(files.Store(Filled(1).data(), 40));  // a
  ASSERT_TRUE(files.Store(Filled(2).data(), 40));  // b
  const std::string newest = driver::ReadFile(folder + "/m.b");
  ASSERT_EQ(newest.size(), 56U);
  for (size_t length = 0; length < newest.size(); ++length) {
    directory.Write("m.b", newest.substr(0, length));
    directory.Write("m.new", newest.substr(0, length));
    Block block = Filled(9);
    RetentiveFiles after;
    ASSERT_TRUE(after.Open(folder.c_str(), "m"));
    ASSERT_EQ(after.Load(block.data(), block.size()), Loaded::kContent) << length;
    ASSERT_EQ(block, Filled(1)) << length;
  }
  for (size_t at = 0; at < newest.size(); ++at) {
    std::string changed = newest;
    changed[at] = static_cast<char>(changed[at] ^ 0x20);
    directory.Write("m.b", changed);
    Block block = Filled(9);
    RetentiveFiles after;
    ASSERT_TRUE(after.Open(folder.c_str(), "m"));
    ASSERT_EQ(after.Load(block.data(), block.size()), Loaded::kContent) << at;
    ASSERT_EQ(block, Filled(1)) << at;
  }
}

TEST(Handover, TheReaderGetsWholeBlocksAndTheLast) {
  static Handover<64> handover;
  constexpr uint32_t kLast = 200'000;
  std::thread writer([] {
    std::array<uint32_t, 16> block;
    for (uint32_t i = 1; i <= kLast; ++i) {
      block.fill(i);
      handover.Give(block.data());
    }
  });
  uint32_t newest = 0;
  while (newest != kLast) {
    const uint8_t* const taken = handover.Take();
    if (taken == nullptr) continue;
    std::array<uint32_t, 16> block;
    memcpy(block.data(), taken, sizeof block);
    for (const uint32_t word : block) ASSERT_EQ(word, block[0]);
    ASSERT_GT(block[0], newest);
    newest = block[0];
  }
  writer.join();
  EXPECT_EQ(handover.Take(), nullptr);
}

TEST(EventQueue, KeepsTheirOrderAndCountsWhatFindsNoRoom) {
  static EventQueue queue;
  for (uint32_t i = 0; i < 70; ++i) queue.Push({i, {}});
  EXPECT_EQ(queue.lost(), 6U);
  Event event{};
  for (uint32_t i = 0; i < 64; ++i) {
    ASSERT_TRUE(queue.Pop(event));
    EXPECT_EQ(event.what, i);
  }
  EXPECT_FALSE(queue.Pop(event));
}

TEST(Pins, ANumberThatDoesNotFitBecomesTheGreatestThatDoes) {
  EXPECT_EQ(Fit8(255), 255);
  EXPECT_EQ(Fit8(256), 255);
  EXPECT_EQ(Fit16(65535), 65535);
  EXPECT_EQ(Fit16(4'000'000'000U), 65535);
}

}  // namespace
}  // namespace plcxx::host
