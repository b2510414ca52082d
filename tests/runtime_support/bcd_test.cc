// BCD and BIN of all bytes and all 16-bit words.
#include "plcxx/bcd.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace plcxx {
namespace {

// covers: NC110-108
TEST(Bcd, ToBcdIsModuloOneHundred) {
  for (int value = 0; value < 256; ++value) {
    const int digits = value % 100;
    EXPECT_EQ(ToBcd8(static_cast<uint8_t>(value)), (digits / 10) * 16 + digits % 10) << value;
  }
}

// covers: NC110-109
TEST(Bcd, FromBcdIsThePlainFormula) {
  for (int value = 0; value < 256; ++value) {
    EXPECT_EQ(FromBcd8(static_cast<uint8_t>(value)), (value / 16) * 10 + value % 16) << value;
  }
  EXPECT_EQ(FromBcd8(0xFF), 165);
}

TEST(Bcd, RoundTrip) {
  for (int value = 0; value < 100; ++value) EXPECT_EQ(FromBcd8(ToBcd8(static_cast<uint8_t>(value))), value);
}

// covers: PS-204
TEST(Bcd, WordsToDigits) {
  for (uint32_t value = 0; value < 0x10000; ++value) {
    uint32_t digits = 0, rest = value % 10000;
    for (uint32_t shift = 0; shift < 16; shift += 4, rest /= 10) digits |= rest % 10 << shift;
    ASSERT_EQ(ToBcd16(static_cast<uint16_t>(value)), digits) << value;
  }
}

// covers: PS-205
TEST(Bcd, DigitsToWords) {
  for (uint32_t word = 0; word < 0x10000; ++word) {
    const uint32_t value = (word >> 12) * 1000 + (word >> 8 & 15) * 100 + (word >> 4 & 15) * 10 + (word & 15);
    ASSERT_EQ(FromBcd16(static_cast<uint16_t>(word)), value) << word;
  }
  EXPECT_EQ(FromBcd16(0xFFFF), 16665);
}

}  // namespace
}  // namespace plcxx
