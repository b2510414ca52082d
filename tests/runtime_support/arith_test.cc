// Arithmetic against wide integers: all pairs of bytes, random wider words and their borders.
#include "plcxx/arith.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "plcxx/compare.h"

namespace plcxx {
namespace {

__extension__ using Wide = __int128;

/// `value` modulo 2^bits, never negative.
uint64_t Modulo(Wide value, int bits) {
  const Wide modulus = Wide{1} << bits;
  return static_cast<uint64_t>(((value % modulus) + modulus) % modulus);
}

/// Words where carries and signs turn over, and random ones.
std::vector<uint64_t> Samples() {
  std::vector<uint64_t> samples;
  for (int bit : {0, 1, 7, 8, 15, 16, 31, 32, 63}) {
    const uint64_t power = uint64_t{1} << bit;
    samples.insert(samples.end(), {power - 1, power, power + 1, ~power, ~power + 1});
  }
  std::mt19937_64 random(7);
  for (int i = 0; i < 300; ++i) samples.push_back(random() >> (random() % 64));
  return samples;
}

// covers: NC110-081, NC110-082
TEST(Arith, AllPairsOfBytesWrap) {
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      const auto x = static_cast<uint8_t>(a), y = static_cast<uint8_t>(b);
      ASSERT_EQ(Add8(x, y), Modulo(a + b, 8));
      ASSERT_EQ(Sub8(x, y), Modulo(a - b, 8));
      ASSERT_EQ(Mul8(x, y), Modulo(a * b, 8));
    }
  }
  EXPECT_EQ(Sub8(17, 19), 0xFE);  // the specification's example
}

TEST(Arith, WiderWordsWrap) {
  const std::vector<uint64_t> samples = Samples();
  for (uint64_t a : samples) {
    for (uint64_t b : samples) {
      const Wide x = a, y = b;
      const auto a16 = static_cast<uint16_t>(a), b16 = static_cast<uint16_t>(b);
      const auto a32 = static_cast<uint32_t>(a), b32 = static_cast<uint32_t>(b);
      ASSERT_EQ(Add16(a16, b16), Modulo(Wide{a16} + b16, 16));
      ASSERT_EQ(Sub16(a16, b16), Modulo(Wide{a16} - b16, 16));
      ASSERT_EQ(Mul16(a16, b16), Modulo(Wide{a16} * b16, 16));
      ASSERT_EQ(Add32(a32, b32), Modulo(Wide{a32} + b32, 32));
      ASSERT_EQ(Sub32(a32, b32), Modulo(Wide{a32} - b32, 32));
      ASSERT_EQ(Mul32(a32, b32), Modulo(Wide{a32} * b32, 32));
      ASSERT_EQ(Add64(a, b), Modulo(x + y, 64));
      ASSERT_EQ(Sub64(a, b), Modulo(x - y, 64));
      __extension__ using UnsignedWide = unsigned __int128;
      ASSERT_EQ(Mul64(a, b), static_cast<uint64_t>(UnsignedWide{a} * b));
      const Wide sum = Wide{a32} + b32;
      ASSERT_EQ(AddSaturate32(a32, b32), sum > 0xFFFFFFFF ? 0xFFFFFFFF : static_cast<uint64_t>(sum));
    }
  }
}

/// The absolute value of a word of `bits` bits in two's complement, modulo 2^bits.
uint64_t AbsoluteModulo(uint64_t word, int bits) {
  Wide number = word;
  if (number >= Wide{1} << (bits - 1)) number -= Wide{1} << bits;
  return Modulo(number < 0 ? -number : number, bits);
}

// covers: NC110-111
TEST(Arith, AbsOfAllBytes) {
  for (int a = 0; a < 256; ++a) EXPECT_EQ(Abs8(static_cast<uint8_t>(a)), a < 128 ? a : (256 - a) % 256) << a;
  EXPECT_EQ(Abs8(0x80), 0x80);
}

TEST(Arith, AbsOfWiderWords) {
  for (int a = 0; a < 65536; ++a) {
    ASSERT_EQ(Abs16(static_cast<uint16_t>(a)), AbsoluteModulo(static_cast<uint64_t>(a), 16)) << a;
  }
  for (uint64_t a : Samples()) {
    EXPECT_EQ(Abs32(static_cast<uint32_t>(a)), AbsoluteModulo(static_cast<uint32_t>(a), 32)) << a;
    EXPECT_EQ(Abs64(a), AbsoluteModulo(a, 64)) << a;
  }
  EXPECT_EQ(Abs16(0x8000), 0x8000);
  EXPECT_EQ(Abs32(0x80000000), 0x80000000);
  EXPECT_EQ(Abs64(0x8000000000000000), 0x8000000000000000);
}

TEST(Arith, WideningKeepsTheNumber) {
  for (int a = 0; a < 65536; ++a) {
    const auto word = static_cast<uint16_t>(a);
    const auto byte = static_cast<uint8_t>(a % 256);
    ASSERT_EQ(Widen16To32(word), static_cast<uint32_t>(a));
    ASSERT_EQ(Widen32(word), static_cast<uint32_t>(a));
    ASSERT_EQ(Widen8To32(byte), static_cast<uint32_t>(a % 256));
    ASSERT_EQ(Widen32(byte), static_cast<uint32_t>(a % 256));
  }
}

// covers: NC110-090
TEST(Compare, AllPairsOfBytesAreUnsigned) {
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      const auto x = static_cast<uint8_t>(a), y = static_cast<uint8_t>(b);
      ASSERT_EQ(Equal8(x, y), a == b);
      ASSERT_EQ(Less8(x, y), a < b);
      ASSERT_EQ(Greater8(x, y), a > b);
    }
  }
}

TEST(Compare, WiderWordsAreUnsigned) {
  const std::vector<uint64_t> samples = Samples();
  for (uint64_t a : samples) {
    for (uint64_t b : samples) {
      const Wide difference = Wide{a} - Wide{b};
      ASSERT_EQ(Equal64(a, b), difference == 0);
      ASSERT_EQ(Less64(a, b), difference < 0);
      ASSERT_EQ(Greater64(a, b), difference > 0);
      const auto a32 = static_cast<uint32_t>(a), b32 = static_cast<uint32_t>(b);
      ASSERT_EQ(Equal32(a32, b32), Equal64(a32, b32));
      ASSERT_EQ(Less32(a32, b32), Less64(a32, b32));
      ASSERT_EQ(Greater32(a32, b32), Greater64(a32, b32));
      const auto a16 = static_cast<uint16_t>(a), b16 = static_cast<uint16_t>(b);
      ASSERT_EQ(Equal16(a16, b16), Equal64(a16, b16));
      ASSERT_EQ(Less16(a16, b16), Less64(a16, b16));
      ASSERT_EQ(Greater16(a16, b16), Greater64(a16, b16));
    }
  }
}

}  // namespace
}  // namespace plcxx
