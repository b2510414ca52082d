// Two's complement and 16-bit words against wide integers: all pairs of bytes, borders and random wider words.
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "plcxx/arith.h"
#include "plcxx/bits.h"
#include "plcxx/compare.h"

namespace plcxx {
namespace {

/// A word of `bits` bits as two's complement.
int64_t Number(uint64_t word, int bits) {
  const int64_t value = static_cast<int64_t>(word & ((uint64_t{1} << bits) - 1));
  return value >= int64_t{1} << (bits - 1) ? value - (int64_t{1} << bits) : value;
}

std::vector<uint32_t> SignedSamples() {
  std::vector<uint32_t> samples;
  for (int bit : {0, 1, 7, 8, 14, 15, 16, 30, 31}) {
    const uint32_t power = uint32_t{1} << bit;
    samples.insert(samples.end(), {power - 1, power, power + 1, ~power, ~power + 1});
  }
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) samples.push_back(static_cast<uint32_t>(random()) >> (random() % 32));
  return samples;
}

// covers: PS-151
TEST(Signed, AllPairsOfBytes) {
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      const auto x = static_cast<uint8_t>(a), y = static_cast<uint8_t>(b);
      const int64_t p = Number(x, 8), q = Number(y, 8);
      ASSERT_EQ(NotEqual8(x, y), p != q);
      ASSERT_EQ(LessEqual8(x, y), a <= b);
      ASSERT_EQ(GreaterEqual8(x, y), a >= b);
      ASSERT_EQ(SignedLess8(x, y), p < q);
      ASSERT_EQ(SignedLessEqual8(x, y), p <= q);
      ASSERT_EQ(SignedGreater8(x, y), p > q);
      ASSERT_EQ(SignedGreaterEqual8(x, y), p >= q);
    }
  }
}

// covers: PS-152, PS-222
TEST(Signed, WiderWords) {
  for (const uint32_t a : SignedSamples()) {
    for (const uint32_t b : SignedSamples()) {
      const auto x = static_cast<uint16_t>(a), y = static_cast<uint16_t>(b);
      const int64_t p = Number(x, 16), q = Number(y, 16);
      ASSERT_EQ(NotEqual16(x, y), p != q);
      ASSERT_EQ(LessEqual16(x, y), x <= y);
      ASSERT_EQ(GreaterEqual16(x, y), x >= y);
      ASSERT_EQ(SignedLess16(x, y), p < q);
      ASSERT_EQ(SignedLessEqual16(x, y), p <= q);
      ASSERT_EQ(SignedGreater16(x, y), p > q);
      ASSERT_EQ(SignedGreaterEqual16(x, y), p >= q);
      const int64_t u = Number(a, 32), v = Number(b, 32);
      ASSERT_EQ(NotEqual32(a, b), u != v);
      ASSERT_EQ(LessEqual32(a, b), a <= b);
      ASSERT_EQ(GreaterEqual32(a, b), a >= b);
      ASSERT_EQ(SignedLess32(a, b), u < v);
      ASSERT_EQ(SignedLessEqual32(a, b), u <= v);
      ASSERT_EQ(SignedGreater32(a, b), u > v);
      ASSERT_EQ(SignedGreaterEqual32(a, b), u >= v);
    }
  }
}

// covers: PS-202, PS-215
TEST(Signed, DivisionTruncatesAndTheRemainderHasTheSignOfTheDividend) {
  for (const uint32_t a : SignedSamples()) {
    for (const uint32_t b : SignedSamples()) {
      const int64_t u = Number(a, 32), v = Number(b, 32);
      ASSERT_EQ(SignedDiv32(a, b), v == 0 ? 0 : static_cast<uint32_t>(u / v)) << u << '/' << v;
      ASSERT_EQ(SignedRem32(a, b), v == 0 ? a : static_cast<uint32_t>(u % v)) << u << '%' << v;
      ASSERT_EQ(UnsignedDiv32(a, b), b == 0 ? 0 : a / b);
      ASSERT_EQ(UnsignedRem32(a, b), b == 0 ? a : a % b);
    }
  }
  EXPECT_EQ(SignedDiv32(0x80000000, 0xFFFFFFFF), 0x80000000);
  EXPECT_EQ(SignedRem32(0x80000000, 0xFFFFFFFF), 0u);
}

// covers: PS-201, PS-215
TEST(Signed, WideningKeepsTheNumberAndHalvesPutItTogether) {
  for (const uint32_t a : SignedSamples()) {
    const auto word = static_cast<uint16_t>(a);
    ASSERT_EQ(Number(SignExtend16To32(word), 32), Number(word, 16));
    ASSERT_EQ(static_cast<int64_t>(SignExtend32To64(a)), Number(a, 32));
    ASSERT_EQ(Widen32To64(a), a);
    ASSERT_EQ((uint32_t{HighHalf32(a)} << 16) + LowHalf32(a), a);
    for (const uint32_t b : SignedSamples()) {
      const uint64_t product = Mul64(SignExtend32To64(a), SignExtend32To64(b));
      ASSERT_EQ(static_cast<int64_t>(product), Number(a, 32) * Number(b, 32));
      ASSERT_EQ((uint64_t{HighHalf64(product)} << 32) + LowHalf64(product), product);
      ASSERT_EQ(IsZero64(product), a == 0 || b == 0);
    }
  }
}

// covers: PS-206
TEST(Words, ShiftsBringInZeros) {
  for (uint32_t word = 0; word < 0x10000; word += 37) {
    const auto value = static_cast<uint16_t>(word);
    for (uint32_t count = 0; count < 40; ++count) {
      const uint64_t left = count > 15 ? 0 : (uint64_t{word} << count) % 0x10000;
      ASSERT_EQ(ShiftLeft16(value, static_cast<uint16_t>(count)), left);
      ASSERT_EQ(ShiftRight16(value, static_cast<uint16_t>(count)), count > 15 ? 0 : word >> count);
    }
    ASSERT_EQ(ShiftLeft16(value, 0xFFFF), 0);
    ASSERT_EQ(ShiftRight16(value, 0x8000), 0);
  }
}

// covers: PS-160
TEST(Words, BytesOfAWord) {
  for (uint32_t word = 0; word < 0x10000; ++word) {
    const auto value = static_cast<uint16_t>(word);
    ASSERT_EQ(LowByte16(value), word % 256);
    ASSERT_EQ(HighByte16(value), word / 256);
    ASSERT_EQ(Pair16(LowByte16(value), HighByte16(value)), word);
    const auto byte = static_cast<uint8_t>(word * 7);
    ASSERT_EQ(WithLowByte16(value, byte), word / 256 * 256 + byte);
    ASSERT_EQ(Widen8To16(byte), byte);
  }
}

TEST(Words, SingleBitsOfDoubleWords) {
  for (const uint32_t a : SignedSamples()) {
    for (uint32_t bit = 0; bit < 40; ++bit) {
      ASSERT_EQ(TestBit32(a, bit), bit < 32 && (uint64_t{a} >> bit & 1) != 0);
      ASSERT_EQ(BitAt32(true, bit), bit < 32 ? uint64_t{1} << bit : 0);
      ASSERT_EQ(BitAt32(false, bit), 0u);
    }
    ASSERT_EQ(Not32(a), 0xFFFFFFFF - a);
  }
}

}  // namespace
}  // namespace plcxx
