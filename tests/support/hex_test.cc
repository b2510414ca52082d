#include "transpiler/support/hex.h"

#include <gtest/gtest.h>

namespace plcxx::support {
namespace {

TEST(Hex, DigitsFromTheMostSignificantOne) {
  EXPECT_EQ(HexDigits(0), "0");
  EXPECT_EQ(HexDigits(0x1F, 4), "001f");
  EXPECT_EQ(HexDigits(0x12345, 4), "12345");
  EXPECT_EQ(HexDigits(0xABC, 2, HexLetters::kCapital), "ABC");
  EXPECT_EQ(HexDigits(0, 16), "0000000000000000");
  EXPECT_EQ(HexDigits(0xFEDCBA9876543210), "fedcba9876543210");
}

TEST(Hex, ValueOfWhatWasWritten) {
  for (uint8_t value = 0; value < 16; ++value) EXPECT_EQ(HexValue(HexDigits(value)[0]), value);
  for (const char other : {'A', 'g', ' ', '\0', '\xE9'}) EXPECT_EQ(HexValue(other), std::nullopt) << int{other};
}

}  // namespace
}  // namespace plcxx::support
