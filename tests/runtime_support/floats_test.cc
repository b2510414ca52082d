// Floating point against double, and integers against 64 bits: a double has more than twice a float's digits, so that
// one operation in double rounded to float is the correctly rounded float.
#include "plcxx/floats.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace plcxx {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Borders of the format and of the words, and patterns of all kinds.
std::vector<float> FloatSamples() {
  std::vector<float> samples = {0.0F,
                                -0.0F,
                                0.5F,
                                -0.5F,
                                1.5F,
                                2.5F,
                                -1.5F,
                                0.49999997F,
                                -0.49999997F,
                                8388607.5F,
                                -8388607.5F,
                                8388608.0F,
                                16777216.0F,
                                2147483520.0F,
                                2147483648.0F,
                                -2147483648.0F,
                                -2147483904.0F,
                                1e-45F,
                                1.17549435e-38F,
                                3.4028235e38F,
                                kInfinity,
                                -kInfinity,
                                kNan,
                                10.3F};
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) samples.push_back(std::bit_cast<float>(static_cast<uint32_t>(random())));
  std::uniform_real_distribution<float> usual(-1000.0F, 1000.0F);
  for (int i = 0; i < 300; ++i) samples.push_back(usual(random));
  return samples;
}

/// Equal in every bit; one NaN is like another.
testing::AssertionResult Same(float found, double expected) {
  const auto rounded = static_cast<float>(expected);
  const bool same =
      std::isnan(found) ? std::isnan(rounded) : std::bit_cast<uint32_t>(found) == std::bit_cast<uint32_t>(rounded);
  if (same) return testing::AssertionSuccess();
  return testing::AssertionFailure() << found << " instead of " << rounded;
}

// covers: HOST50-121..124 HOST50-144
TEST(Floats, EveryOperationIsRoundedOnce) {
  const std::vector<float> samples = FloatSamples();
  for (const float a : samples) {
    for (const float b : samples) {
      const double x = a, y = b;
      ASSERT_TRUE(Same(AddF32(a, b), x + y)) << a << " + " << b;
      ASSERT_TRUE(Same(SubF32(a, b), x - y)) << a << " - " << b;
      ASSERT_TRUE(Same(MulF32(a, b), x * y)) << a << " * " << b;
      ASSERT_TRUE(Same(QuotientOrDividendF32(a, b), b == 0 ? x : x / y)) << a << " / " << b;
    }
  }
  EXPECT_EQ(std::bit_cast<uint32_t>(QuotientOrDividendF32(-0.0F, 0.0F)), 0x80000000U);
  // 16777216 + 1 + 1 is 16777216 in binary32, not 16777218.
  EXPECT_EQ(AddF32(AddF32(16777216.0F, 1.0F), 1.0F), 16777216.0F);
}

// covers: HOST50-120
TEST(Floats, NegationInvertsTheSignOnly) {
  for (const float value : FloatSamples()) {
    if (std::isnan(value)) continue;  // whose bits C++ leaves open
    EXPECT_EQ(BitsOfF32(NegateF32(value)), BitsOfF32(value) ^ 0x80000000U) << value;
  }
}

TEST(Floats, BitsTellZerosApartAndNanFromNan) {
  EXPECT_NE(BitsOfF32(0.0F), BitsOfF32(-0.0F));
  EXPECT_EQ(BitsOfF32(kNan), BitsOfF32(kNan));
  EXPECT_EQ(BitsOfF32(1.0F), 0x3F800000U);
}

// covers: HOST50-156
TEST(Floats, BitsAndNumbersAreOneAnother) {
  EXPECT_EQ(F32OfBits(0x3FC00000), 1.5F);
  EXPECT_EQ(F32OfBits(0xFF800000), -kInfinity);
  EXPECT_TRUE(std::isnan(F32OfBits(0x7FC00001)));
  EXPECT_EQ(BitsOfF32(F32OfBits(0x7FC00001)), 0x7FC00001u);
}

TEST(Floats, WithNanOnlyNotEqualIsTrue) {
  for (const float a : FloatSamples()) {
    for (const float b : FloatSamples()) {
      const bool ordered = !std::isnan(a) && !std::isnan(b);
      ASSERT_EQ(EqualF32(a, b), ordered && a == b);
      ASSERT_EQ(NotEqualF32(a, b), !(ordered && a == b));
      ASSERT_EQ(LessF32(a, b), ordered && a < b);
      ASSERT_EQ(LessEqualF32(a, b), ordered && (a < b || a == b));
      ASSERT_EQ(GreaterF32(a, b), ordered && a > b);
      ASSERT_EQ(GreaterEqualF32(a, b), ordered && (a > b || a == b));
    }
  }
  EXPECT_TRUE(EqualF32(0.0F, -0.0F));
}

uint32_t Saturated(double whole) {
  if (std::isnan(whole)) return 0;
  if (whole > 2147483647.0) return 0x7FFFFFFF;
  if (whole < -2147483648.0) return 0x80000000;
  return static_cast<uint32_t>(static_cast<int64_t>(whole));
}

// covers: HOST50-129 HOST50-130
TEST(Floats, ToWordsBySaturation) {
  for (const float value : FloatSamples()) {
    ASSERT_EQ(TruncateF32(value), Saturated(std::trunc(double{value}))) << value;
    ASSERT_EQ(RoundF32(value), Saturated(std::round(double{value}))) << value;
  }
  EXPECT_EQ(TruncateF32(-3.9F), static_cast<uint32_t>(-3));
  EXPECT_EQ(RoundF32(2.5F), 3U);
  EXPECT_EQ(RoundF32(-2.5F), static_cast<uint32_t>(-3));
}

// covers: HOST50-126 HOST50-131
TEST(Floats, WordsToTheNearestTiesToEven) {
  std::mt19937 random(5);
  for (int i = 0; i < 100000; ++i) {
    const auto word = static_cast<uint32_t>(random() >> (random() % 32));
    ASSERT_TRUE(Same(SignedToF32(word), static_cast<int32_t>(word))) << word;
  }
  EXPECT_EQ(SignedToF32(16777217), 16777216.0F);
  EXPECT_EQ(SignedToF32(16777219), 16777220.0F);
  EXPECT_EQ(SignedToF32(0x7FFFFFFF), 2147483648.0F);
  EXPECT_EQ(SignedToF32(0x80000000), -2147483648.0F);
  EXPECT_EQ(SignedToF32(0xFFFFFFFF), -1.0F);
}

}  // namespace
}  // namespace plcxx
