// Every 8-bit input of the bit operations, against references written with loops over wide integers.
#include "plcxx/bits.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace plcxx {
namespace {

int BitOf(long value, int bit) { return static_cast<int>((value / (1L << bit)) % 2); }

// covers: NC110-063
TEST(Bits, SignalOperators) {
  for (int a = 0; a <= 1; ++a) {
    EXPECT_EQ(BitNot(a == 1), a == 0);
    for (int b = 0; b <= 1; ++b) {
      EXPECT_EQ(BitAnd(a == 1, b == 1), a + b == 2);
      EXPECT_EQ(BitOr(a == 1, b == 1), a + b >= 1);
      EXPECT_EQ(BitXor(a == 1, b == 1), a + b == 1);
    }
  }
}

// covers: NC110-078
TEST(Bits, WordOperatorsWorkBitByBit) {
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      long conjunction = 0, disjunction = 0, difference = 0;
      for (int bit = 0; bit < 8; ++bit) {
        const int sum = BitOf(a, bit) + BitOf(b, bit);
        conjunction += (sum == 2 ? 1L : 0L) << bit;
        disjunction += (sum >= 1 ? 1L : 0L) << bit;
        difference += (sum == 1 ? 1L : 0L) << bit;
      }
      const auto x = static_cast<uint8_t>(a), y = static_cast<uint8_t>(b);
      ASSERT_EQ(And8(x, y), conjunction) << a << ' ' << b;
      ASSERT_EQ(Or8(x, y), disjunction) << a << ' ' << b;
      ASSERT_EQ(Xor8(x, y), difference) << a << ' ' << b;
    }
    ASSERT_EQ(Not8(static_cast<uint8_t>(a)), 255 - a);
  }
}

TEST(Bits, WideOperatorsAgreeWithTheirBytes) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 10000; ++i) {
    const uint64_t a = random(), b = random();
    uint64_t conjunction = 0, disjunction = 0, difference = 0, complement = 0;
    for (int byte = 0; byte < 8; ++byte) {
      const auto x = static_cast<uint8_t>(a >> (8 * byte)), y = static_cast<uint8_t>(b >> (8 * byte));
      conjunction |= uint64_t{And8(x, y)} << (8 * byte);
      disjunction |= uint64_t{Or8(x, y)} << (8 * byte);
      difference |= uint64_t{Xor8(x, y)} << (8 * byte);
      complement |= uint64_t{Not8(x)} << (8 * byte);
    }
    const auto a32 = static_cast<uint32_t>(a), b32 = static_cast<uint32_t>(b);
    const auto a16 = static_cast<uint16_t>(a), b16 = static_cast<uint16_t>(b);
    ASSERT_EQ(And64(a, b), conjunction);
    ASSERT_EQ(And32(a32, b32), static_cast<uint32_t>(conjunction));
    ASSERT_EQ(And16(a16, b16), static_cast<uint16_t>(conjunction));
    ASSERT_EQ(Or64(a, b), disjunction);
    ASSERT_EQ(Or32(a32, b32), static_cast<uint32_t>(disjunction));
    ASSERT_EQ(Or16(a16, b16), static_cast<uint16_t>(disjunction));
    ASSERT_EQ(Xor64(a, b), difference);
    ASSERT_EQ(Xor32(a32, b32), static_cast<uint32_t>(difference));
    ASSERT_EQ(Xor16(a16, b16), static_cast<uint16_t>(difference));
    ASSERT_EQ(Not64(a), complement);
    ASSERT_EQ(Not32(a32), static_cast<uint32_t>(complement));
    ASSERT_EQ(Not16(a16), static_cast<uint16_t>(complement));
  }
}

// covers: NC110-106
TEST(Bits, HighestBitOfAllValues) {
  for (int value = 0; value < 256; ++value) {
    int expected = 0;
    while ((1 << expected) <= value) ++expected;
    EXPECT_EQ(HighestBit8(static_cast<uint8_t>(value)), expected) << value;
  }
}

// covers: NC110-107
TEST(Bits, OneHotOfAllValues) {
  const int table[] = {0, 1, 2, 4, 8, 16, 32, 64, 128};
  for (int value = 0; value < 256; ++value) {
    EXPECT_EQ(OneHot8(static_cast<uint8_t>(value)), value <= 8 ? table[value] : 0) << value;
  }
}

// covers: NC110-110
TEST(Bits, NibblesOfAllValues) {
  for (int value = 0; value < 256; ++value) {
    const auto word = static_cast<uint8_t>(value);
    EXPECT_EQ(HighNibble8(word), value / 16);
    EXPECT_EQ(LowNibble8(word), value % 16);
    EXPECT_EQ(SwapNibbles8(word), (value % 16) * 16 + value / 16);
  }
}

// covers: NC110-113
TEST(Bits, SignBitOfAllValues) {
  for (int value = 0; value < 256; ++value) EXPECT_EQ(SignBit8(static_cast<uint8_t>(value)), value / 128 == 1) << value;
}

// covers: NC110-049
TEST(Bits, TestBitOfAllValues) {
  for (int value = 0; value < 256; ++value) {
    for (int bit = 0; bit < 8; ++bit) {
      EXPECT_EQ(TestBit8(static_cast<uint8_t>(value), static_cast<unsigned>(bit)), BitOf(value, bit) == 1);
    }
    for (unsigned bit : {8U, 31U, 32U, 63U, 64U, ~0U}) EXPECT_FALSE(TestBit8(static_cast<uint8_t>(value), bit)) << bit;
  }
}

// covers: NC110-050
TEST(Bits, WithBitsTouchesTheMaskOnly) {
  for (int word = 0; word < 256; ++word) {
    for (int mask = 0; mask < 256; ++mask) {
      int set = 0, cleared = 0;
      for (int bit = 0; bit < 8; ++bit) {
        const bool masked = BitOf(mask, bit) == 1;
        set += (masked ? 1 : BitOf(word, bit)) << bit;
        cleared += (masked ? 0 : BitOf(word, bit)) << bit;
      }
      ASSERT_EQ(WithBits8(static_cast<uint8_t>(word), static_cast<uint8_t>(mask), true), set);
      ASSERT_EQ(WithBits8(static_cast<uint8_t>(word), static_cast<uint8_t>(mask), false), cleared);
    }
  }
}

// covers: NC110-136
TEST(Bits, PairTakesTheLowWordFirst) {
  EXPECT_EQ(Pair16(0xF4, 0x01), 500);  // the manual's 10 s with a tick of 2 ms
  for (int low = 0; low < 256; ++low) {
    for (int high = 0; high < 256; ++high) {
      ASSERT_EQ(Pair16(static_cast<uint8_t>(low), static_cast<uint8_t>(high)), high * 256 + low);
    }
  }
}

}  // namespace
}  // namespace plcxx
