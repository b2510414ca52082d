#include "transpiler/dialects/hnc/analysis/loop_counts.h"

#include <algorithm>

#include "transpiler/support/check.h"

namespace plcxx::hnc {

BinaryOp Turned(BinaryOp op) {
  switch (op) {
    case BinaryOp::kLess:
      return BinaryOp::kGreater;
    case BinaryOp::kGreater:
      return BinaryOp::kLess;
    case BinaryOp::kLessEqual:
      return BinaryOp::kGreaterEqual;
    case BinaryOp::kGreaterEqual:
      return BinaryOp::kLessEqual;
    case BinaryOp::kAdd:
    case BinaryOp::kSubtract:
    case BinaryOp::kMultiply:
    case BinaryOp::kDivide:
    case BinaryOp::kRemainder:
    case BinaryOp::kShiftLeft:
    case BinaryOp::kShiftRight:
    case BinaryOp::kBitAnd:
    case BinaryOp::kBitXor:
    case BinaryOp::kBitOr:
    case BinaryOp::kEqual:
    case BinaryOp::kNotEqual:
    case BinaryOp::kPointerAdd:
    case BinaryOp::kPointerSubtract:
    case BinaryOp::kPointerDifference:
      return op;
  }
  PLCXX_UNREACHABLE();
}

BinaryOp Negated(BinaryOp op) {
  switch (op) {
    case BinaryOp::kLess:
      return BinaryOp::kGreaterEqual;
    case BinaryOp::kGreater:
      return BinaryOp::kLessEqual;
    case BinaryOp::kLessEqual:
      return BinaryOp::kGreater;
    case BinaryOp::kGreaterEqual:
      return BinaryOp::kLess;
    case BinaryOp::kEqual:
      return BinaryOp::kNotEqual;
    case BinaryOp::kNotEqual:
      return BinaryOp::kEqual;
    case BinaryOp::kAdd:
    case BinaryOp::kSubtract:
    case BinaryOp::kMultiply:
    case BinaryOp::kDivide:
    case BinaryOp::kRemainder:
    case BinaryOp::kShiftLeft:
    case BinaryOp::kShiftRight:
    case BinaryOp::kBitAnd:
    case BinaryOp::kBitXor:
    case BinaryOp::kBitOr:
    case BinaryOp::kPointerAdd:
    case BinaryOp::kPointerSubtract:
    case BinaryOp::kPointerDifference:
      return op;
  }
  PLCXX_UNREACHABLE();
}

namespace {

bool RelationHolds(BinaryOp op, int64_t a, int64_t b) {
  switch (op) {
    case BinaryOp::kLess:
      return a < b;
    case BinaryOp::kGreater:
      return a > b;
    case BinaryOp::kLessEqual:
      return a <= b;
    case BinaryOp::kGreaterEqual:
      return a >= b;
    case BinaryOp::kEqual:
      return a == b;
    case BinaryOp::kAdd:
    case BinaryOp::kSubtract:
    case BinaryOp::kMultiply:
    case BinaryOp::kDivide:
    case BinaryOp::kRemainder:
    case BinaryOp::kShiftLeft:
    case BinaryOp::kShiftRight:
    case BinaryOp::kBitAnd:
    case BinaryOp::kBitXor:
    case BinaryOp::kBitOr:
    case BinaryOp::kNotEqual:
    case BinaryOp::kPointerAdd:
    case BinaryOp::kPointerSubtract:
    case BinaryOp::kPointerDifference:
      return a != b;
  }
  PLCXX_UNREACHABLE();
}

int64_t SizeOf(const Bounds& type) { return type.high - type.low + 1; }

int64_t WrapInto(int64_t value, const Bounds& type) {
  const int64_t rest = (value - type.low) % SizeOf(type);
  return type.low + (rest < 0 ? rest + SizeOf(type) : rest);
}

uint64_t CeilDivide(int64_t a, int64_t b) { return a <= 0 ? 0 : static_cast<uint64_t>((a + b - 1) / b); }

/// The values that no conversion changes: compared, they are themselves.
Bounds Unchanged(const CountedLoop& loop) {
  Bounds same = loop.type;
  for (const Bounds& type : loop.conversions) same = Meet(same, type).value_or(Bounds{0, 0});
  return same;
}

int64_t AsCompared(int64_t value, const CountedLoop& loop) {
  for (const Bounds& type : loop.conversions) value = WrapInto(value, type);
  return value;
}

/// Whether no start below `same` passes the test: -1, compared with an unsigned limit, is above it. They are one
/// stretch of numbers then, too.
bool FailsBelow(const CountedLoop& loop, const Bounds& same, int64_t last) {
  const int64_t high = std::min(loop.start.high, same.low - 1);
  const int64_t first = AsCompared(loop.start.low, loop);
  return first > last && AsCompared(high, loop) - first == high - loop.start.low;
}

/// The step by the shorter way round the type: 65535, added to 16 bits, is -1.
int64_t Shorter(const CountedLoop& loop) {
  const int64_t size = SizeOf(loop.type), up = ((loop.step % size) + size) % size;
  return 2 * up > size ? up - size : up;
}

/// Upwards below a limit, or downwards above it: one step past the last value that passes the test is the furthest.
std::optional<LoopCount> CountTowards(const CountedLoop& loop) {
  const Bounds same = Unchanged(loop);
  const bool upwards = loop.op == BinaryOp::kLess || loop.op == BinaryOp::kLessEqual;
  const int64_t strict = loop.op == BinaryOp::kLess || loop.op == BinaryOp::kGreater ? 1 : 0;
  const int64_t last = upwards ? loop.limit.high - strict : loop.limit.low + strict;
  if (upwards && loop.start.low < same.low && loop.start.high <= same.high && FailsBelow(loop, same, last)) {
    if (loop.start.high < same.low) return LoopCount{.iterations = 0, .at_test = loop.start, .in_body = {}};
    CountedLoop passing = loop;
    passing.start.low = same.low;
    std::optional<LoopCount> count = CountTowards(passing);
    if (count) count->at_test = Join(count->at_test, loop.start);
    return count;
  }
  if (!loop.start.Within(same)) return std::nullopt;
  if (upwards ? last < loop.start.low : last > loop.start.high) {
    return LoopCount{.iterations = 0, .at_test = loop.start, .in_body = {}};
  }
  const int64_t step = (loop.step > 0) == upwards ? loop.step : Shorter(loop);
  if (step == 0 || (step > 0) != upwards || !same.Holds(last + step)) return std::nullopt;
  if (upwards) {
    return LoopCount{.iterations = CeilDivide(last - loop.start.low + 1, step),
                     .at_test = {loop.start.low, std::max(loop.start.high, last + step)},
                     .in_body = Bounds{loop.start.low, last}};
  }
  return LoopCount{.iterations = CeilDivide(loop.start.high - last + 1, -step),
                   .at_test = {std::min(loop.start.low, last + step), loop.start.high},
                   .in_body = Bounds{last, loop.start.high}};
}

/// All of it is constant: the values, one after the other.
std::optional<LoopCount> CountOut(const CountedLoop& loop) {
  const int64_t step = Shorter(loop);
  int64_t value = loop.start.low;
  LoopCount count{.iterations = 0, .at_test = loop.start, .in_body = {}};
  for (; count.iterations <= kMaxIterations; ++count.iterations) {
    count.at_test = Join(count.at_test, {value, value});
    if (!RelationHolds(loop.op, AsCompared(value, loop), loop.limit.low)) return count;
    count.in_body = Join(count.in_body.value_or(Bounds{value, value}), {value, value});
    if (!loop.wraps && !loop.type.Holds(value + step)) return std::nullopt;
    value = WrapInto(value + step, loop.type);
  }
  return std::nullopt;
}

/// By steps of one a counter meets each value of its type, so the limit, too, where that is one of them.
std::optional<LoopCount> CountToMeeting(const CountedLoop& loop) {
  const bool upwards = Shorter(loop) == 1, downwards = Shorter(loop) == -1;
  if ((!upwards && !downwards) || !loop.limit.Within(Unchanged(loop))) return std::nullopt;
  if (upwards && loop.start.high <= loop.limit.low) {
    LoopCount count{.iterations = static_cast<uint64_t>(loop.limit.high - loop.start.low),
                    .at_test = {loop.start.low, loop.limit.high},
                    .in_body = {}};
    if (count.iterations > 0) count.in_body = Bounds{loop.start.low, loop.limit.high - 1};
    return count;
  }
  if (downwards && loop.start.low >= loop.limit.high) {
    LoopCount count{.iterations = static_cast<uint64_t>(loop.start.high - loop.limit.low),
                    .at_test = {loop.limit.low, loop.start.high},
                    .in_body = {}};
    if (count.iterations > 0) count.in_body = Bounds{loop.limit.low + 1, loop.start.high};
    return count;
  }
  return LoopCount{.iterations = static_cast<uint64_t>(SizeOf(loop.type)), .at_test = loop.type, .in_body = loop.type};
}

}  // namespace

Bounds Wrapped(const Bounds& one, const Bounds& type) {
  const int64_t value = WrapInto(one.low, type);
  return {value, value};
}

std::optional<LoopCount> Count(const CountedLoop& loop) {
  const bool ordered = Info(loop.op).family == BinaryFamily::kOrder;
  if (ordered) {
    if (const std::optional<LoopCount> count = CountTowards(loop)) return count;
  }
  if (loop.start.IsOne() && loop.limit.IsOne()) {
    if (const std::optional<LoopCount> count = CountOut(loop)) return count;
  }
  if (loop.op == BinaryOp::kNotEqual) return CountToMeeting(loop);
  return std::nullopt;
}

bool IsEntered(const CountedLoop& loop) {
  if (!loop.start.Within(Unchanged(loop))) {
    return loop.start.IsOne() && loop.limit.IsOne() &&
           RelationHolds(loop.op, AsCompared(loop.start.low, loop), loop.limit.low);
  }
  // Of an order the start that is nearest to the limit decides; others are decided where the ranges do not meet.
  if (Info(loop.op).family == BinaryFamily::kOrder) {
    const bool upwards = loop.op == BinaryOp::kLess || loop.op == BinaryOp::kLessEqual;
    return upwards ? RelationHolds(loop.op, loop.start.high, loop.limit.low)
                   : RelationHolds(loop.op, loop.start.low, loop.limit.high);
  }
  return loop.op == BinaryOp::kNotEqual && !Meet(loop.start, loop.limit);
}

}  // namespace plcxx::hnc
