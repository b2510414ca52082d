#include "transpiler/scenarios/separate_processes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "transpiler/support/check.h"

namespace plcxx::scenarios {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// What became of items 0 to 5 in two groups, of which `bad` does its harm.
std::map<uint32_t, ItemEnd> EndsOfGroups(uint32_t bad, void (*harm)()) {
  std::map<uint32_t, ItemEnd> ends;
  const std::vector<ItemGroup> groups = {{0, 1, 2, 3}, {4, 5}};
  WorkSeparately(
      groups, {.jobs = 2, .item_seconds = 1},
      [&](const ItemGroup& items, WorkReport& report) {
        for (const uint32_t item : items) {
          report.Begin(item);
          if (item == bad) harm();
          report.Done(item, "item " + std::to_string(item));
        }
      },
      [&](uint32_t item, ItemEnd end) { EXPECT_TRUE(ends.emplace(item, std::move(end)).second) << item; });
  return ends;
}

void ExpectOnlyFailed(const std::map<uint32_t, ItemEnd>& ends, uint32_t bad) {
  EXPECT_EQ(ends.size(), 6u);
  for (const auto& [item, end] : ends) {
    if (item != bad) {
      EXPECT_EQ(end.result, "item " + std::to_string(item)) << end.why;
    }
  }
  EXPECT_FALSE(ends.at(bad).result);
}

TEST(SeparateProcesses, AllAreDone) {
  for (const auto& [item, end] : EndsOfGroups(99, [] {})) EXPECT_EQ(end.result, "item " + std::to_string(item));
}

TEST(SeparateProcesses, ACrashIsThatOfOneItem) {
  const auto ends = EndsOfGroups(1, [] { std::abort(); });
  ExpectOnlyFailed(ends, 1);
  EXPECT_THAT(ends.at(1).why, HasSubstr("ended by a fault of plcxx itself: signal 6 (Aborted)"));
}

TEST(SeparateProcesses, AnInternalFaultIsThatOfOneItemAndSaysWhere) {
  const auto ends = EndsOfGroups(4, [] { PLCXX_CHECK(false); });
  ExpectOnlyFailed(ends, 4);
  EXPECT_THAT(ends.at(4).why, AllOf(HasSubstr("ended by a fault of plcxx itself"), HasSubstr("separate_processes_test"),
                                    HasSubstr("please report it")));
}

TEST(SeparateProcesses, EndlessWorkIsThatOfOneItem) {
  const auto ends = EndsOfGroups(3, [] {
    for (;;) pause();
  });
  ExpectOnlyFailed(ends, 3);
  EXPECT_EQ(ends.at(3).why, "did not end within 1 s; --time-limit SECONDS allows more");
}

TEST(SeparateProcesses, AnExceptionIsShown) {
  const auto ends = EndsOfGroups(0, [] { throw std::runtime_error("no more room"); });
  ExpectOnlyFailed(ends, 0);
  EXPECT_THAT(ends.at(0).why, HasSubstr("no more room"));
}

TEST(SeparateProcesses, WorkForAllThatFailsIsDoneForEach) {
  std::map<uint32_t, ItemEnd> ends;
  WorkSeparately(
      {{0, 1, 2}}, {},
      [](const ItemGroup& items, WorkReport& report) {
        report.BeginCommon();
        for (const uint32_t item : items) {
          if (item == 1) std::abort();
        }
        for (const uint32_t item : items) report.Done(item, std::string(100'000, 'x'));
      },
      [&](uint32_t item, ItemEnd end) { ends[item] = std::move(end); });
  EXPECT_EQ(ends.at(0).result, std::string(100'000, 'x'));
  EXPECT_THAT(ends.at(1).why, HasSubstr("signal 6"));
  EXPECT_EQ(ends.at(2).result, std::string(100'000, 'x'));
}

}  // namespace
}  // namespace plcxx::scenarios
