// Packed and forced references: reading, writing, and assignment from one to another.
#include "plcxx/tags.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <type_traits>

#include "plcxx/forced.h"

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
static_assert(std::is_trivial_v<PackedBit>);

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
TEST(Forced, ApplyForcesReplacesTheMaskedBits) {
  for (int byte = 0; byte < 256; ++byte) {
    for (int mask : {0x00, 0x01, 0x0F, 0x81, 0xFF}) {
      for (int value : {0x00, 0x05, 0x55, 0xFF}) {
        int expected = 0;
        for (int power = 1; power < 256; power *= 2) {
          expected += ((mask / power) % 2 == 1 ? (value / power) % 2 : (byte / power) % 2) * power;
        }
        const auto forced = static_cast<unsigned char>(mask), forced_value = static_cast<unsigned char>(value);
        auto stored = static_cast<uint8_t>(byte);
        ApplyForces(&stored, &forced, &forced_value, 1);
        ASSERT_EQ(stored, expected);
        stored = 0xA5;
        Forced<uint8_t>(stored, &forced, &forced_value) = static_cast<uint8_t>(byte);
        ASSERT_EQ(stored, expected);
      }
    }
  }
}

// covers: NC110-236
TEST(Forced, AForcedBitLeavesTheOthersFree) {
  uint8_t byte = 0;
  const unsigned char mask = 0x02, value = 0x02;
  ForcedPackedBit(PackedBitRef(byte, 0x02), byte, &mask, &value) = false;
  EXPECT_TRUE(PackedBitRef(byte, 0x02));
  ForcedPackedBit(PackedBitRef(byte, 0x04), byte, &mask, &value) = true;
  EXPECT_EQ(byte, 0x06);
  ForcedPackedBit(PackedBitRef(byte, 0x04), byte, &mask, &value) = false;
  EXPECT_EQ(byte, 0x02);
  Forced<uint8_t>(byte, &mask, &value) = 0xF0;
  EXPECT_EQ(byte, 0xF2);
}

TEST(Forced, AStepThatGetsTheObjectCannotChangeForcedBits) {
  struct Instance {
    uint8_t count;
    bool done;
  } instance = {1, false};
  const unsigned char mask[sizeof(Instance)] = {0, 0xFF}, value[sizeof(Instance)] = {0, 1};
  const auto step = [](Instance& stepped) { stepped = {7, false}; };
  step(Forced<Instance>(instance, mask, value));
  EXPECT_EQ(instance.count, 7);
  EXPECT_TRUE(instance.done);
}

TEST(Forced, AssignmentCopiesTheValue) {
  uint8_t bytes[2] = {0x01, 0x00};
  const unsigned char masks[2] = {0, 0x10}, values[2] = {0, 0x10};
  {
    const ForcedPackedBit from(PackedBitRef(bytes[0], 0x01), bytes[0], masks, values);
    ForcedPackedBit(PackedBitRef(bytes[1], 0x08), bytes[1], masks + 1, values + 1) = from;
  }
  EXPECT_EQ(bytes[1], 0x18);
  {
    const Forced<uint8_t> from(bytes[0], masks, values);
    Forced<uint8_t>(bytes[1], masks + 1, values + 1) = from;
  }
  EXPECT_EQ(bytes[1], 0x11);
}

TEST(Forced, UnforcedMemoryIsPlain) {
  uint8_t byte = 0;
  const unsigned char none = 0;
  for (int value = 0; value < 256; ++value) {
    Forced<uint8_t>(byte, &none, &none) = static_cast<uint8_t>(value);
    EXPECT_EQ(byte, value);
  }
}

}  // namespace
}  // namespace plcxx
