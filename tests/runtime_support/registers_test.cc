// Flags, shifts and rotations against references in wider integers and bit by bit.
#include "plcxx/registers.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "plcxx/arith.h"
#include "plcxx/bcd.h"
#include "plcxx/bits.h"

namespace plcxx {
namespace {

static_assert(RotateLeft16(0x8001, 1) == 3 && RotateRight8(1, 1) == 0x80, "usable in constant expressions");

/// Read as two's complement in `bits` bits.
int64_t Signed(uint64_t value, int bits) {
  const int64_t number = static_cast<int64_t>(value);
  return (value >> (bits - 1)) != 0 ? number - (int64_t{1} << bits) : number;
}
bool Fits(int64_t value, int bits) {
  return value >= -(int64_t{1} << (bits - 1)) && value < (int64_t{1} << (bits - 1));
}

template <class T, class Carry, class Borrow, class AddOverflow, class SubOverflow>
void CheckSums(T a, T b, unsigned in, Carry carry, Borrow borrow, AddOverflow overflow, SubOverflow lack) {
  constexpr int kBits = sizeof(T) * 8;
  const uint64_t exact = uint64_t{a} + b + in;
  const T sum = static_cast<T>(exact), difference = static_cast<T>(uint64_t{a} - b - in);
  ASSERT_EQ(carry(a, b, sum), exact >> kBits != 0) << +a << ' ' << +b << ' ' << in;
  ASSERT_EQ(borrow(a, b, difference), uint64_t{a} < uint64_t{b} + in) << +a << ' ' << +b << ' ' << in;
  ASSERT_EQ(overflow(a, b, sum), !Fits(Signed(a, kBits) + Signed(b, kBits) + in, kBits)) << +a << ' ' << +b;
  ASSERT_EQ(lack(a, b, difference), !Fits(Signed(a, kBits) - Signed(b, kBits) - in, kBits)) << +a << ' ' << +b;
  const unsigned half = (a & 15U) + (b & 15U) + in;
  ASSERT_EQ(HalfCarry8(LowByte16(static_cast<uint16_t>(a)), LowByte16(static_cast<uint16_t>(b)),
                       LowByte16(static_cast<uint16_t>(sum))),
            half > 15);
  ASSERT_EQ(HalfCarry8(LowByte16(static_cast<uint16_t>(a)), LowByte16(static_cast<uint16_t>(b)),
                       LowByte16(static_cast<uint16_t>(difference))),
            (a & 15U) < (b & 15U) + in);
}

// covers: TECHNOL-143
TEST(Registers, FlagsOfSumsAndDifferences) {
  for (unsigned a = 0; a < 256; ++a) {
    for (unsigned b = 0; b < 256; ++b) {
      for (const unsigned in : {0U, 1U}) {
        CheckSums(static_cast<uint8_t>(a), static_cast<uint8_t>(b), in, CarryOfAdd8, BorrowOfSub8, OverflowOfAdd8,
                  OverflowOfSub8);
      }
    }
  }
  std::mt19937_64 random(36);
  const uint32_t edges[] = {0, 1, 0x7FFF, 0x8000, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF};
  const auto operand = [&] { return random() % 4 == 0 ? edges[random() % 8] : static_cast<uint32_t>(random()); };
  for (unsigned i = 0; i < 50000; ++i) {
    const uint32_t a = operand(), b = operand();
    CheckSums(static_cast<uint16_t>(a), static_cast<uint16_t>(b), i % 2, CarryOfAdd16, BorrowOfSub16, OverflowOfAdd16,
              OverflowOfSub16);
    CheckSums(a, b, i % 2, CarryOfAdd32, BorrowOfSub32, OverflowOfAdd32, OverflowOfSub32);
  }
}

// covers: TECHNOL-147
TEST(Registers, ShiftsOneBitAtATime) {
  for (const uint32_t value : {0U, 1U, 0x80000000U, 0x7FFFFFFFU, 0xDEADBEEFU, 0xFFFFFFFFU}) {
    uint32_t left = value, right = value;
    int64_t sign = Signed(value, 32);
    for (uint32_t count = 0; count < 40; ++count) {
      ASSERT_EQ(ShiftLeft32(value, count), left);
      ASSERT_EQ(ShiftRight32(value, count), right);
      ASSERT_EQ(ArithmeticShiftRight32(value, count), static_cast<uint32_t>(sign));
      left *= 2;
      right /= 2;
      sign = sign < 0 ? (sign - 1) / 2 : sign / 2;
    }
  }
}

template <class T, class Left, class Right, class Through, class Carry>
void CheckRotations(T value, Left left, Right right, Through through, Carry carry) {
  constexpr unsigned kBits = sizeof(T) * 8;
  T to_left = value, to_right = value;
  for (const bool first : {false, true}) {
    T with = value;
    bool flag = first;
    to_left = to_right = value;
    for (uint32_t count = 0; count < 70; ++count) {
      ASSERT_EQ(left(value, count), to_left) << +value << ' ' << count;
      ASSERT_EQ(right(value, count), to_right) << +value << ' ' << count;
      ASSERT_EQ(through(value, first, count), with) << +value << ' ' << count;
      ASSERT_EQ(carry(value, first, count), flag) << +value << ' ' << count;
      const bool top = ((to_left >> (kBits - 1)) & 1) != 0, bottom = (to_right & 1) != 0;
      to_left = static_cast<T>(uint64_t{to_left} * 2 + (top ? 1 : 0));
      to_right = static_cast<T>(to_right / 2 + (bottom ? uint64_t{1} << (kBits - 1) : 0));
      const bool out = ((with >> (kBits - 1)) & 1) != 0;
      with = static_cast<T>(uint64_t{with} * 2 + (flag ? 1 : 0));
      flag = out;
    }
  }
}

// covers: TECHNOL-148
TEST(Registers, RotationsOneBitAtATime) {
  for (unsigned value = 0; value < 256; ++value) {
    CheckRotations(static_cast<uint8_t>(value), RotateLeft8, RotateRight8, RotateCarryLeft8, CarryAfterRotate8);
  }
  std::mt19937 random(17);
  for (int i = 0; i < 200; ++i) {
    const auto value = static_cast<uint32_t>(random());
    CheckRotations(static_cast<uint16_t>(value), RotateLeft16, RotateRight16, RotateCarryLeft16, CarryAfterRotate16);
    CheckRotations(value, RotateLeft32, RotateRight32, RotateCarryLeft32, CarryAfterRotate32);
  }
}

// covers: TECHNOL-152
TEST(Registers, DecimalAdjustmentOfSums) {
  for (unsigned a = 0; a < 100; ++a) {
    for (unsigned b = 0; b < 100; ++b) {
      const uint8_t x = ToBcd8(static_cast<uint8_t>(a)), y = ToBcd8(static_cast<uint8_t>(b));
      const auto sum = static_cast<uint8_t>(x + y), difference = static_cast<uint8_t>(x - y);
      const bool half = HalfCarry8(x, y, sum), carry = CarryOfAdd8(x, y, sum);
      ASSERT_EQ(AdjustAfterAdd8(sum, half || (sum & 15) > 9, carry || sum > 0x99),
                ToBcd8(static_cast<uint8_t>((a + b) % 100)));
      ASSERT_EQ(AdjustAfterSub8(difference, HalfCarry8(x, y, difference), x < y),
                ToBcd8(static_cast<uint8_t>((a + 100 - b) % 100)));
    }
  }
}

// covers: TECHNOL-107
// covers: TECHNOL-108
TEST(Registers, SignedDigits) {
  EXPECT_EQ(ToSignedBcd32(12345), 0x12345U);
  EXPECT_EQ(ToSignedBcd32(static_cast<uint32_t>(-12345)), 0x80012345U);
  EXPECT_EQ(ToSignedBcd32(79999999), 0x79999999U);
  EXPECT_EQ(ToSignedBcd32(static_cast<uint32_t>(-80000000)), 0U);
  EXPECT_EQ(FromSignedBcd32(0x80000000U), 0U);
  EXPECT_EQ(FromSignedBcd32(0x0000000FU), 15U);
  std::mt19937 random(8);
  for (int i = 0; i < 20000; ++i) {
    const auto number = static_cast<uint32_t>(static_cast<int32_t>(random() % 159999999U) - 79999999);
    ASSERT_EQ(FromSignedBcd32(ToSignedBcd32(number)), number);
    ASSERT_FALSE(HasNoDigit32(ToSignedBcd32(number) & 0x7FFFFFFFU));
    const auto word = static_cast<uint32_t>(random());
    bool bad = false;
    for (int shift = 0; shift < 32; shift += 4) bad = bad || ((word >> shift) & 15) > 9;
    ASSERT_EQ(HasNoDigit32(word), bad) << word;
  }
}

// covers: TECHNOL-150
TEST(Registers, QuotientsOfDoubleLength) {
  std::mt19937_64 random(64);
  for (int i = 0; i < 20000; ++i) {
    const uint64_t a = random() >> random() % 60, b = (random() >> random() % 60) | 1;
    ASSERT_EQ(UnsignedDiv64(a, b) * b + UnsignedRem64(a, b), a);
    ASSERT_LT(UnsignedRem64(a, b), b);
    if (b == ~uint64_t{0}) continue;
    ASSERT_EQ(SignedDiv64(a, b), static_cast<uint64_t>(static_cast<int64_t>(a) / static_cast<int64_t>(b)));
    ASSERT_EQ(SignedRem64(a, b), static_cast<uint64_t>(static_cast<int64_t>(a) % static_cast<int64_t>(b)));
  }
  EXPECT_EQ(UnsignedDiv64(7, 0), 0U);
  EXPECT_EQ(UnsignedRem64(7, 0), 7U);
  EXPECT_EQ(SignedDiv64(uint64_t{1} << 63, ~uint64_t{0}), uint64_t{1} << 63);
  EXPECT_EQ(Pair64(0x9ABCDEF0U, 0x12345678U), 0x123456789ABCDEF0U);
  EXPECT_EQ(Pair32(0x5678, 0x1234), 0x12345678U);
  EXPECT_EQ(SignExtend8To16(0x80), 0xFF80);
  EXPECT_EQ(SignExtend8To32(0x7F), 0x7FU);
}

}  // namespace
}  // namespace plcxx
