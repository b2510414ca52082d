#include "transpiler/sim/value_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace plcxx::sim {
namespace {

uint64_t Bits(float value) { return std::bit_cast<uint32_t>(value); }
uint64_t Bits(double value) { return std::bit_cast<uint64_t>(value); }

TEST(ValueText, Digits) {
  EXPECT_EQ(ValueDigits(ir::Type::kBit, 1), "1");
  EXPECT_EQ(ValueDigits(ir::Type::kI32, 0xFFFFFFFF), "4294967295");
  EXPECT_EQ(ValueDigits(ir::Type::kI64, ~uint64_t{0}), "18446744073709551615");
  EXPECT_EQ(ValueDigits(ir::Type::kI32, 0xFFFFFFF9, Sign::kTwosComplement), "-7");
  EXPECT_EQ(ValueDigits(ir::Type::kI8, 0x7F, Sign::kTwosComplement), "127");
  EXPECT_EQ(ValueDigits(ir::Type::kI64, ~uint64_t{0}, Sign::kTwosComplement), "-1");
  EXPECT_EQ(ValueDigits(ir::Type::kBit, 1, Sign::kTwosComplement), "1");
  EXPECT_EQ(ValueDigits(ir::Type::kF32, Bits(12.5f)), "12.5");
  EXPECT_EQ(ValueDigits(ir::Type::kF32, Bits(0.1f)), "0.1");
  EXPECT_EQ(ValueDigits(ir::Type::kF32, Bits(-0.0f)), "-0");
  EXPECT_EQ(ValueDigits(ir::Type::kF64, Bits(0.1)), "0.1");
  EXPECT_EQ(ValueDigits(ir::Type::kF32, Bits(-std::numeric_limits<float>::infinity())), "-inf");
  EXPECT_EQ(ValueDigits(ir::Type::kF32, Bits(std::nanf(""))), "nan");
  EXPECT_EQ(ValueDigits(ir::Type::kF32, 0xFFC00001), "nan");
}

TEST(ValueText, SameValue) {
  EXPECT_TRUE(SameValue(ir::Type::kF32, 0x7FC00000, 0xFFC00001));
  EXPECT_FALSE(SameValue(ir::Type::kI32, 0x7FC00000, 0xFFC00001));
  EXPECT_FALSE(SameValue(ir::Type::kF32, Bits(0.0f), Bits(-0.0f)));
  EXPECT_TRUE(SameValue(ir::Type::kF64, Bits(1.5), Bits(1.5)));
}

}  // namespace
}  // namespace plcxx::sim
