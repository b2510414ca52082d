// Integers of C on a 16-bit machine against 64-bit arithmetic: borders of the words and random ones.
#include "plcxx/c_integers.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "plcxx/bits.h"

namespace plcxx {
namespace {

std::vector<uint16_t> Words() {
  std::vector<uint16_t> words;
  for (int i = -300; i <= 300; ++i) {
    words.push_back(static_cast<uint16_t>(i));
    words.push_back(static_cast<uint16_t>(0x8000 + i));
  }
  std::mt19937 random(11);
  for (int i = 0; i < 300; ++i) words.push_back(static_cast<uint16_t>(random()));
  return words;
}

std::vector<uint32_t> DoubleWords() {
  std::vector<uint32_t> words;
  for (int i = -20; i <= 20; ++i) {
    for (const uint32_t border : {0U, 0x8000U, 0x10000U, 0x80000000U}) {
      words.push_back(border + static_cast<uint32_t>(i));
    }
  }
  std::mt19937 random(12);
  for (int i = 0; i < 300; ++i) words.push_back(static_cast<uint32_t>(random()) >> (random() % 32));
  return words;
}

int64_t Signed(uint16_t value) { return static_cast<int16_t>(value); }
int64_t Signed(uint32_t value) { return static_cast<int32_t>(value); }

// covers: HNC-197, HNC-198, HNC-201, HNC-202, HNC-203
TEST(CIntegers, DivisionOf16Bits) {
  for (const uint16_t a : Words()) {
    ASSERT_EQ(Minus16(a), static_cast<uint16_t>(-Signed(a)));
    for (const uint16_t b : Words()) {
      if (b == 0) {
        ASSERT_EQ(UnsignedDiv16(a, b), 0);
        ASSERT_EQ(UnsignedRem16(a, b), 0);
        ASSERT_EQ(SignedDiv16(a, b), 0);
        ASSERT_EQ(SignedRem16(a, b), 0);
        continue;
      }
      ASSERT_EQ(UnsignedDiv16(a, b), a / b);
      ASSERT_EQ(UnsignedRem16(a, b), a % b);
      ASSERT_EQ(SignedDiv16(a, b), static_cast<uint16_t>(Signed(a) / Signed(b))) << a << " " << b;
      ASSERT_EQ(SignedRem16(a, b), static_cast<uint16_t>(Signed(a) % Signed(b))) << a << " " << b;
    }
  }
  EXPECT_EQ(SignedDiv16(0x8000, 0xFFFF), 0x8000);
  EXPECT_EQ(SignedRem16(0x8000, 0xFFFF), 0);
}

// covers: HNC-199
TEST(CIntegers, RemainderOf32Bits) {
  for (const uint32_t a : DoubleWords()) {
    ASSERT_EQ(Minus32(a), static_cast<uint32_t>(-Signed(a)));
    for (const uint32_t b : DoubleWords()) {
      if (b == 0) {
        ASSERT_EQ(UnsignedRemOrZero32(a, b), 0U);
        ASSERT_EQ(SignedRemOrZero32(a, b), 0U);
        continue;
      }
      ASSERT_EQ(UnsignedRemOrZero32(a, b), a % b);
      ASSERT_EQ(SignedRemOrZero32(a, b), static_cast<uint32_t>(Signed(a) % Signed(b)));
    }
  }
}

// covers: HNC-207, HNC-208
TEST(CIntegers, ShiftsToTheRightCopyTheSign) {
  for (const uint16_t a : Words()) {
    for (uint16_t count = 0; count < 40; ++count) {
      const int64_t wide = Signed(a) >> (count > 15 ? 15 : count);
      ASSERT_EQ(ArithmeticShiftRight16(a, count), static_cast<uint16_t>(wide)) << a << " " << count;
    }
  }
}

TEST(CIntegers, WidthsAndChoices) {
  EXPECT_EQ(Widen1To16(true), 1);
  EXPECT_EQ(Widen1To16(false), 0);
  EXPECT_EQ(LowByte32(0x12345678), 0x78);
  EXPECT_EQ(Select1(true, false, true), false);
  EXPECT_EQ(Select8(false, 1, 2), 2);
  EXPECT_EQ(Select16(true, 0x8000, 2), 0x8000);
  EXPECT_EQ(Select32(false, 1, 0x80000000U), 0x80000000U);
}

}  // namespace
}  // namespace plcxx
