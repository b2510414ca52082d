// The two-copy store of retentive memory: what it keeps, and a loss of power at every write.

#include "plcxx/retentive_store.h"

#include <gtest/gtest.h>

#include "tests/baremetal/power_cuts.h"

namespace plcxx {
namespace {

constexpr uint8_t kCheck[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
static_assert(Crc32(0, kCheck, 9) == 0xCBF43926U, "the polynomial's published check value");
static_assert(Crc32(Crc32(0, kCheck, 4), kCheck + 4, 5) == 0xCBF43926U, "in pieces as in one");
static_assert(RetentiveSlotBytes(0) == 16 && RetentiveSlotBytes(1) == 24 && RetentiveSlotBytes(68) == 88);

TEST(RetentiveStore, APowerCutAtAnyWriteLeavesTheOldOrTheNewContent) {
  const plcxx_test::CutCounts counts = plcxx_test::PowerCuts<40>().Run();
  EXPECT_EQ(counts.wrong, 0U);
  EXPECT_GT(counts.cuts, 100'000U);
  EXPECT_GT(counts.old_content, counts.cuts / 2);
  EXPECT_GT(counts.new_content, 0U);
}

TEST(RetentiveStore, KeepsTheNewestAcrossTheWrapOfItsSequence) {
  RetentiveStorage storage;
  uint32_t content = 0;
  EXPECT_FALSE(LoadRetentive(storage, 24, &content, 4));
  for (uint32_t value = 1; value < 10; ++value) {
    ASSERT_TRUE(StoreRetentive(storage, 24, &value, 4));
    ASSERT_TRUE(LoadRetentive(storage, 24, &content, 4));
    ASSERT_EQ(content, value);
    if (value != 3) continue;
    // As after four thousand million stores: slots of sequence 0xFFFFFFFE and 0xFFFFFFFF.
    for (uint32_t at = 0; at < 48; at += 24) {
      uint8_t* const slot = storage.bytes + at;
      retentive_internal::PutWord(slot + 4, retentive_internal::GetWord(slot + 4) + 0xFFFFFFFCU);
      retentive_internal::PutWord(slot + 12, Crc32(Crc32(0, slot + 4, 8), slot + 16, 4));
    }
  }
}

TEST(RetentiveStore, TheNewestStaysWholeUntilTheNextOneIs) {
  RetentiveStorage storage;
  for (uint32_t value = 1; value < 6; ++value) {
    ASSERT_TRUE(StoreRetentive(storage, 24, &value, 4));
    const uint32_t next = value + 1;
    for (uint32_t cut = 0; cut < 24; ++cut) {
      RetentiveStorage torn = storage;
      torn.written = 0;
      torn.cut_at = cut;
      ASSERT_TRUE(StoreRetentive(torn, 24, &next, 4));
      uint32_t content = 0;
      ASSERT_TRUE(LoadRetentive(torn, 24, &content, 4)) << value << ", cut at " << cut;
      EXPECT_TRUE(content == value || content == next) << content << " of " << value << ", cut at " << cut;
    }
  }
}

TEST(RetentiveStore, WritesNothingWhenNothingChanged) {
  RetentiveStorage storage;
  const uint32_t content = 77;
  ASSERT_TRUE(StoreRetentive(storage, 24, &content, 4));
  const uint32_t written = storage.written;
  EXPECT_EQ(written, 4U + 12U + 4U + 4U);
  ASSERT_TRUE(StoreRetentive(storage, 24, &content, 4));
  EXPECT_EQ(storage.written, written);
}

TEST(RetentiveStore, RefusesAnotherSizeAndALossOfAnyBit) {
  RetentiveStorage storage;
  const uint32_t first = 1, second = 0x12345678;
  ASSERT_TRUE(StoreRetentive(storage, 24, &first, 4));
  ASSERT_TRUE(StoreRetentive(storage, 24, &second, 4));
  uint8_t other[5] = {9, 9, 9, 9, 9};
  EXPECT_FALSE(LoadRetentive(storage, 24, other, 5));
  EXPECT_EQ(other[0], 9);
  EXPECT_FALSE(LoadRetentive(storage, 16, other, 4)) << "slots that are too small";
  EXPECT_FALSE(StoreRetentive(storage, 16, other, 4));
  // The newer copy loses a bit: the older one is there.
  for (uint32_t bit = 0; bit < 20 * 8; ++bit) {
    RetentiveStorage damaged = storage;
    damaged.bytes[24 + bit / 8] = static_cast<uint8_t>(damaged.bytes[24 + bit / 8] ^ 1U << bit % 8);
    uint32_t content = 0;
    ASSERT_TRUE(LoadRetentive(damaged, 24, &content, 4));
    EXPECT_EQ(content, first) << bit;
  }
}

}  // namespace
}  // namespace plcxx
