#include "plcxx/wide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <type_traits>

#include "plcxx/forced.h"

namespace plcxx {
namespace {

static_assert(std::is_trivial_v<Little<uint16_t>> && sizeof(Little<uint64_t>) == 2);
static_assert(At(Indexed<Little<uint16_t>>{10, 2, -3, 5}, 1).place.byte == 18, "usable in constant expressions");

/// The bytes of a value as arithmetic gives them, in the order of the memory.
template <ByteOrder kOrder>
uint64_t Composed(const uint8_t* bytes, size_t count) {
  uint64_t value = 0;
  for (size_t i = 0; i < count; ++i) value = value * 256 + bytes[kOrder == ByteOrder::kBig ? i : count - 1 - i];
  return value;
}

template <class T, ByteOrder kOrder>
void ReadsAndWrites() {
  std::mt19937_64 random(4711);
  for (int round = 0; round < 2000; ++round) {
    uint8_t memory[12], before[12];
    for (uint8_t& byte : memory) byte = static_cast<uint8_t>(random());
    const size_t at = 1 + random() % 3;  // odd addresses, too
    WideRef<T, kOrder> ref(memory + at);
    ASSERT_EQ(static_cast<T>(ref), static_cast<T>(Composed<kOrder>(memory + at, sizeof(T))));
    std::memcpy(before, memory, sizeof memory);
    const T value = static_cast<T>(random());
    ref = value;
    ASSERT_EQ(Composed<kOrder>(memory + at, sizeof(T)), value);
    for (size_t i = 0; i < sizeof memory; ++i) {
      const bool beside = i < at || i >= at + sizeof(T);
      ASSERT_TRUE(!beside || memory[i] == before[i]) << i;
    }
  }
}

TEST(Wide, LeastSignificantByteFirst) {
  ReadsAndWrites<uint8_t, ByteOrder::kLittle>();
  ReadsAndWrites<uint16_t, ByteOrder::kLittle>();
  ReadsAndWrites<uint32_t, ByteOrder::kLittle>();
  ReadsAndWrites<uint64_t, ByteOrder::kLittle>();
}

TEST(Wide, MostSignificantByteFirst) {
  ReadsAndWrites<uint8_t, ByteOrder::kBig>();
  ReadsAndWrites<uint16_t, ByteOrder::kBig>();
  ReadsAndWrites<uint32_t, ByteOrder::kBig>();
  ReadsAndWrites<uint64_t, ByteOrder::kBig>();
}

TEST(Wide, FloatsKeepTheirBits) {
  uint8_t memory[5] = {};
  WideRef<float, ByteOrder::kLittle> little(memory + 1);
  WideRef<float, ByteOrder::kBig> big(memory + 1);
  for (const float value : {0.0F, -0.0F, 1.5F, -3.25e-30F, std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::denorm_min()}) {
    uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    little = value;
    EXPECT_EQ(Composed<ByteOrder::kLittle>(memory + 1, 4), bits);
    EXPECT_EQ(static_cast<float>(little), value);
    EXPECT_EQ(std::signbit(static_cast<float>(little)), std::signbit(value));
    big = value;
    EXPECT_EQ(Composed<ByteOrder::kBig>(memory + 1, 4), bits);
    EXPECT_EQ(static_cast<float>(big), value);
  }
  little = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(std::isnan(static_cast<float>(little)));
  uint8_t wide[8] = {};
  WideRef<double, ByteOrder::kBig> number(wide);
  number = -1.5;
  EXPECT_EQ(Composed<ByteOrder::kBig>(wide, 8), 0xBFF8000000000000u);
  EXPECT_EQ(static_cast<double>(number), -1.5);
}

TEST(Wide, AssignmentCopiesTheValue) {
  uint8_t memory[4] = {1, 2, 3, 4};
  WideRef<uint16_t, ByteOrder::kLittle> from(memory), to(memory + 1);
  to = from;  // overlapping: the value is read as a whole first
  EXPECT_EQ(memory[0], 1);
  EXPECT_EQ(memory[1], 1);
  EXPECT_EQ(memory[2], 2);
  EXPECT_EQ(memory[3], 4);
}

TEST(Indexed, ElementsOutsideReadZeroAndKeepNothing) {
  uint8_t memory[10] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  // Three words from byte 2 on, the first one has the index -1.
  constexpr Indexed<Little<uint16_t>> kRow{2, 2, -1, 3};
  for (int64_t index = -5; index < 5; ++index) {
    const Element<Little<uint16_t>> element = At(kRow, static_cast<uint32_t>(index));
    ElementRef<uint16_t, ByteOrder::kLittle> ref(memory + element.place.byte, element.inside);
    const bool inside = index >= -1 && index <= 1;
    EXPECT_EQ(element.inside, inside) << index;
    EXPECT_EQ(static_cast<uint16_t>(ref), inside ? Composed<ByteOrder::kLittle>(memory + 4 + 2 * index, 2) : 0);
    if (!inside) ref = 0xFFFF;
  }
  for (uint8_t i = 0; i < 10; ++i) EXPECT_EQ(memory[i], i);
  const auto last = At(kRow, 1);
  ElementRef<uint16_t, ByteOrder::kLittle>(memory + last.place.byte, last.inside) = 0x1234;
  EXPECT_EQ(memory[6], 0x34);
  EXPECT_EQ(memory[7], 0x12);
  EXPECT_EQ(memory[8], 8);
}

TEST(Indexed, FarIndicesAreOutside) {
  constexpr Indexed<Big<uint32_t>> kRow{0, 1, -100, 997};
  for (const uint32_t index : {0x7FFFFFFFu, 0x80000000u, 0x80000001u, 0xFFFFFF00u, 1000u}) {
    EXPECT_FALSE(At(kRow, index).inside) << index;
  }
  EXPECT_TRUE(At(kRow, static_cast<uint32_t>(-100)).inside);
  EXPECT_TRUE(At(kRow, 896).inside);
  EXPECT_FALSE(At(kRow, 897).inside);
  EXPECT_FALSE(At(Indexed<Big<uint32_t>>{0, 1, 0, 0}, 0).inside);
}

TEST(ForcedBytes, ForcedBitsStay) {
  uint8_t memory[2] = {0x00, 0x10};
  const unsigned char mask[2] = {0, 0x10}, value[2] = {0, 0x10};
  using Ref = WideRef<uint16_t, ByteOrder::kLittle>;
  ForcedBytes<Ref, uint16_t>(Ref(memory), memory, true, mask, value) = 0x0001;
  EXPECT_EQ(memory[0], 0x01);
  EXPECT_EQ(memory[1], 0x10);
  const uint16_t read = ForcedBytes<Ref, uint16_t>(Ref(memory), memory, true, mask, value);
  EXPECT_EQ(read, 0x1001);
}

TEST(ForcedBytes, OneIsAssignedToTheOther) {
  using Ref = WideRef<uint16_t, ByteOrder::kLittle>;
  uint8_t from[2] = {0x12, 0x34}, to[2] = {};
  const unsigned char none[2] = {}, mask[2] = {0x0F, 0}, value[2] = {0x05, 0};
  {
    const ForcedBytes<Ref, uint16_t> source(Ref(from), from, true, none, none);
    ForcedBytes<Ref, uint16_t>(Ref(to), to, true, mask, value) = source;
  }
  EXPECT_EQ(to[0], 0x15);
  EXPECT_EQ(to[1], 0x34);
}

TEST(ForcedBytes, AnElementOutsideHasNothingToPutBack) {
  uint8_t memory[2] = {1, 2};
  const unsigned char mask[2] = {0xFF, 0xFF}, value[2] = {7, 7};
  using Ref = ElementRef<uint16_t, ByteOrder::kLittle>;
  ForcedBytes<Ref, uint16_t>(Ref(memory, false), memory, false, mask, value) = 0x0101;
  EXPECT_EQ(memory[0], 1);
  EXPECT_EQ(memory[1], 2);
}

}  // namespace
}  // namespace plcxx
