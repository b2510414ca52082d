// Floating point of 64 bits against the host's own, which is IEEE: patterns of all kinds.
#include "plcxx/doubles.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace plcxx {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<double> DoubleSamples() {
  std::vector<double> samples = {0.0,
                                 -0.0,
                                 0.5,
                                 -0.5,
                                 1.0,
                                 -1.0,
                                 2.5,
                                 4503599627370495.5,
                                 -4503599627370495.5,
                                 4503599627370496.0,
                                 9223372036854775807.0,
                                 -9223372036854775808.0,
                                 5e-324,
                                 2.2250738585072014e-308,
                                 1.7976931348623157e308,
                                 kInfinity,
                                 -kInfinity,
                                 kNan};
  std::mt19937_64 random(5);
  for (int i = 0; i < 4000; ++i) samples.push_back(std::bit_cast<double>(random()));
  for (int i = 0; i < 4000; ++i) samples.push_back(static_cast<double>(static_cast<int64_t>(random())) / 65536.0);
  return samples;
}

bool Same(double a, double b) {
  return std::isnan(a) ? std::isnan(b) : std::bit_cast<uint64_t>(a) == std::bit_cast<uint64_t>(b);
}

// covers: HNC-301
TEST(Doubles, RootsAndWholeNumbers) {
  for (const double x : DoubleSamples()) {
    ASSERT_TRUE(Same(SqrtF64(x), std::sqrt(x))) << x;
    ASSERT_TRUE(Same(FloorF64(x), std::floor(x))) << x;
    ASSERT_TRUE(Same(CeilF64(x), std::ceil(x))) << x;
    ASSERT_TRUE(Same(AbsF64(x), std::fabs(x))) << x;
  }
  EXPECT_EQ(std::bit_cast<uint64_t>(SqrtF64(-1.0)), 0x7FF8000000000000U) << "on each target, and quiet";
}

// covers: HNC-189, HNC-190
TEST(Doubles, ConversionsGoByWayOf64Bits) {
  for (const double x : DoubleSamples()) {
    const bool fits = x > -9223372036854775808.0 && x < 9223372036854775808.0;
    const uint32_t expected = fits ? static_cast<uint32_t>(static_cast<uint64_t>(static_cast<int64_t>(x))) : 0U;
    ASSERT_EQ(TruncateF64(x), expected) << x;
    ASSERT_EQ(BitsOfF64(x), std::bit_cast<uint64_t>(x));
  }
  EXPECT_EQ(TruncateF64(65537.9), 65537U);
  EXPECT_EQ(TruncateF64(-1.9), 0xFFFFFFFFU);
  EXPECT_EQ(SignedToF64(0x80000000U), -2147483648.0);
  EXPECT_EQ(UnsignedToF64(0x80000000U), 2147483648.0);
  EXPECT_EQ(NarrowF64(0.1), 0.1F);
  EXPECT_EQ(WidenF32(0.5F), 0.5);
}

TEST(Doubles, ArithmeticAndComparison) {
  EXPECT_EQ(AddF64(1.5, 2.0), 3.5);
  EXPECT_EQ(SubF64(1.5, 2.0), -0.5);
  EXPECT_EQ(MulF64(1.5, 2.0), 3.0);
  EXPECT_EQ(DivF64(1.5, 2.0), 0.75);
  EXPECT_EQ(DivF64(1.0, 0.0), kInfinity);
  EXPECT_TRUE(std::signbit(NegateF64(0.0)));
  EXPECT_TRUE(NotEqualF64(kNan, kNan));
  EXPECT_FALSE(EqualF64(kNan, kNan));
  EXPECT_FALSE(LessF64(kNan, 1.0) || LessEqualF64(kNan, 1.0) || GreaterF64(kNan, 1.0) || GreaterEqualF64(kNan, 1.0));
  EXPECT_TRUE(LessF64(1.0, 2.0) && LessEqualF64(2.0, 2.0) && GreaterF64(2.0, 1.0) && GreaterEqualF64(2.0, 2.0));
  EXPECT_EQ(SelectF64(true, 1.0, 2.0), 1.0);
}

}  // namespace
}  // namespace plcxx
