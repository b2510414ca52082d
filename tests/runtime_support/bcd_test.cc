// BCD and BIN of all 256 bytes.
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

}  // namespace
}  // namespace plcxx
