// Packed and forced references: reading, writing, and assignment from one to another.
#include "plcxx/tags.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <type_traits>

#include "plcxx/debug.h"

namespace plcxx {
namespace {

constexpr uint8_t FlippedAndCopied() {
  uint8_t byte = 0b0000'0010;
  PackedBitRef low(byte, 1), next(byte, 2), high(byte, 128);
  low = next;
  next = !next;
  high = low & !next;
  return byte;
}
static_assert(FlippedAndCopied() == 0b1000'0001, "usable in constant expressions");
static_assert(MaskOf(PackedBit{7, 7}) == 128 && MaskOf(PackedBit{7, 8}) == 0 && MaskOf(PackedBit{7, 255}) == 0);
static_assert(std::is_trivial_v<PackedBit> && std::is_trivial_v<ForceByte>);

// covers: NC110-050
TEST(PackedBitRef, AllBytesAndBits) {
  for (int start = 0; start < 256; ++start) {
    for (uint8_t bit = 0; bit < 8; ++bit) {
      const int power = 1 << bit;
      auto byte = static_cast<uint8_t>(start);
      PackedBitRef ref(byte, MaskOf({0, bit}));
      const bool was = (start / power) % 2 == 1;
      ASSERT_EQ(static_cast<bool>(ref), was);
      ref = true;
      ASSERT_EQ(byte, start + (was ? 0 : power));
      ref = false;
      ASSERT_EQ(byte, start - (was ? power : 0));
    }
  }
}

TEST(PackedBitRef, AssignmentCopiesTheBit) {
  uint8_t source = 0x01, target = 0x00;
  PackedBitRef from(source, 0x01), to(target, 0x80);
  to = from;
  EXPECT_EQ(target, 0x80);
  source = 0;
  EXPECT_TRUE(to);  // the value, not the reference
  to = from;
  EXPECT_EQ(target, 0x00);
}

TEST(PackedBitRef, BitThatAByteDoesNotHave) {
  uint8_t byte = 0x55;
  PackedBitRef ref(byte, MaskOf({0, 8}));
  EXPECT_FALSE(ref);
  ref = true;
  EXPECT_EQ(byte, 0x55);
}

// covers: NC110-236
TEST(Forced, ApplyForceReplacesTheMaskedBits) {
  for (int byte = 0; byte < 256; ++byte) {
    for (int mask : {0x00, 0x01, 0x0F, 0x81, 0xFF}) {
      for (int value : {0x00, 0x05, 0x55, 0xFF}) {
        int expected = 0;
        for (int power = 1; power < 256; power *= 2) {
          expected += ((mask / power) % 2 == 1 ? (value / power) % 2 : (byte / power) % 2) * power;
        }
        const ForceByte force{static_cast<uint8_t>(mask), static_cast<uint8_t>(value)};
        ASSERT_EQ(ApplyForce(static_cast<uint8_t>(byte), force), expected);
        uint8_t stored = 0xA5;
        ForcedByteRef ref(stored, force);
        ref = static_cast<uint8_t>(byte);
        ASSERT_EQ(stored, expected);
        ASSERT_EQ(static_cast<uint8_t>(ref), expected);
      }
    }
  }
}

// covers: NC110-236
TEST(Forced, AForcedBitLeavesTheOthersFree) {
  uint8_t byte = 0;
  const ForceByte force{0x02, 0x02};
  ForcedBitRef forced(byte, 0x02, force), unforced(byte, 0x04, force);
  forced = false;
  EXPECT_TRUE(forced);
  unforced = true;
  EXPECT_TRUE(unforced);
  unforced = false;
  EXPECT_FALSE(unforced);
  EXPECT_EQ(byte, 0x02);
  ForcedByteRef word(byte, force);
  word = 0xF0;
  EXPECT_EQ(byte, 0xF2);
}

TEST(Forced, AssignmentCopiesTheValue) {
  uint8_t bytes[2] = {0x01, 0x00};
  const ForceByte forces[2] = {{0, 0}, {0x10, 0x10}};
  ForcedBitRef from(bytes[0], 0x01, forces[0]), to(bytes[1], 0x08, forces[1]);
  to = from;
  EXPECT_EQ(bytes[1], 0x18);
  ForcedByteRef word_from(bytes[0], forces[0]), word_to(bytes[1], forces[1]);
  word_to = word_from;
  EXPECT_EQ(bytes[1], 0x11);
}

TEST(Forced, UnforcedMemoryIsPlain) {
  uint8_t byte = 0;
  const ForceByte none{};
  ForcedByteRef ref(byte, none);
  for (int value = 0; value < 256; ++value) {
    ref = static_cast<uint8_t>(value);
    EXPECT_EQ(byte, value);
  }
}

}  // namespace
}  // namespace plcxx
