// What is said of a loop's iterations, against the loops themselves: counters of 4 bits, every start and limit of a
// range.
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "transpiler/dialects/hnc/analysis/loop_counts.h"

namespace plcxx::hnc {
namespace {

constexpr Bounds kSigned4{-8, 7}, kUnsigned4{0, 15}, kSigned8{-128, 127}, kUnsigned8{0, 255};
constexpr int64_t kAsked[] = {-8, -5, -1, 0, 1, 3, 7, 8, 14, 15};

int64_t In(const Bounds& type, int64_t value) { return Wrapped({value, value}, type).low; }

bool Holds(BinaryOp op, int64_t a, int64_t b) {
  if (op == BinaryOp::kLess) return a < b;
  if (op == BinaryOp::kLessEqual) return a <= b;
  if (op == BinaryOp::kGreater) return a > b;
  if (op == BinaryOp::kGreaterEqual) return a >= b;
  return a != b;
}

bool Passes(const CountedLoop& loop, int64_t value, int64_t limit) {
  for (const Bounds& type : loop.conversions) value = In(type, value);
  return Holds(loop.op, value, limit);
}

/// Where both are constant the product counts out up to ten million iterations: not here.
bool IsEndless(const CountedLoop& loop) {
  if (!loop.start.IsOne() || !loop.limit.IsOne()) return false;
  int64_t value = loop.start.low;
  for (int tests = 0; tests <= 16; ++tests, value = In(loop.type, value + loop.step)) {
    if (!Passes(loop, value, loop.limit.low)) return false;
  }
  return true;
}

/// Executes the loop from one start to one limit, and compares.
void Execute(const CountedLoop& loop, const std::optional<LoopCount>& count, int64_t start, int64_t limit) {
  if (IsEntered(loop)) EXPECT_TRUE(Passes(loop, start, limit));
  if (!count) return;
  uint64_t iterations = 0;
  for (int64_t value = start;; ++iterations) {
    ASSERT_TRUE(count->at_test.Holds(value)) << value;
    if (!Passes(loop, value, limit)) break;
    ASSERT_TRUE(count->in_body && count->in_body->Holds(value)) << value;
    ASSERT_LT(iterations, count->iterations);
    // By steps of one a counter meets every value, past the end of its type, too (6.6).
    const bool may_wrap = loop.wraps || loop.op == BinaryOp::kNotEqual;
    ASSERT_TRUE(may_wrap || loop.type.Holds(value + loop.step)) << value;
    value = In(loop.type, value + loop.step);
  }
}

std::vector<Bounds> RangesIn(const Bounds& type) {
  std::vector<Bounds> ranges;
  for (const int64_t low : kAsked) {
    for (const int64_t high : kAsked) {
      if (low <= high && type.Holds(low) && type.Holds(high)) ranges.push_back({low, high});
    }
  }
  return ranges;
}

TEST(HncLoopCounts, HoldForEveryStartAndLimit) {
  const std::vector<std::vector<Bounds>> conversions = {{}, {kUnsigned4}, {kSigned8}, {kUnsigned8}, {kSigned4}};
  uint32_t counted = 0;
  for (const Bounds& type : {kSigned4, kUnsigned4}) {
    for (const std::vector<Bounds>& through : conversions) {
      const Bounds compared = through.empty() ? type : through.back();
      for (const BinaryOp op :
           {BinaryOp::kLess, BinaryOp::kLessEqual, BinaryOp::kGreater, BinaryOp::kGreaterEqual, BinaryOp::kNotEqual}) {
        for (const int64_t step : {-3, -1, 1, 2}) {
          for (const Bounds& start : RangesIn(type)) {
            for (const Bounds& limit : RangesIn(compared)) {
              const CountedLoop loop{.op = op,
                                     .start = start,
                                     .limit = limit,
                                     .step = step,
                                     .type = type,
                                     .wraps = type.low == 0,
                                     .conversions = through};
              if (IsEndless(loop)) continue;
              const std::optional<LoopCount> count = Count(loop);
              if (count) ++counted;
              for (const int64_t from : {start.low, start.high}) {
                for (const int64_t to : {limit.low, limit.high}) Execute(loop, count, from, to);
              }
              EXPECT_FALSE(HasFailure()) << "op " << static_cast<int>(op) << " step " << step << " start " << start.low
                                         << ".." << start.high << " limit " << limit.low << ".." << limit.high
                                         << " type " << type.low << " as " << compared.low;
              if (HasFailure()) return;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(counted, 10'000U);
}

/// `i < 3u` of an int: what is below 0 is above the limit.
TEST(HncLoopCounts, ANegativeStartFailsAgainstAnUnsignedLimit) {
  const CountedLoop loop{.op = BinaryOp::kLess,
                         .start = kSigned4,
                         .limit = {3, 3},
                         .step = 1,
                         .type = kSigned4,
                         .wraps = false,
                         .conversions = {kUnsigned4}};
  const std::optional<LoopCount> count = Count(loop);
  ASSERT_TRUE(count);
  EXPECT_EQ(count->iterations, 3U);
  ASSERT_TRUE(count->in_body);
  EXPECT_EQ(count->in_body->low, 0);
  EXPECT_EQ(count->in_body->high, 2);
  EXPECT_FALSE(IsEntered(loop));
}

}  // namespace
}  // namespace plcxx::hnc
