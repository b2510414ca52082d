// Borders that depend on what is near them: limits, and how far an edit reaches.
#include "transpiler/emit/legalize/content_borders.h"

#include <gtest/gtest.h>

#include <set>

namespace plcxx::emit::legalize {
namespace {

constexpr BorderLimits kLimits = {.least = 25, .most = 100};

std::vector<BorderCandidate> Entries(uint32_t count) {
  std::vector<BorderCandidate> entries;
  for (uint32_t i = 0; i < count; ++i) entries.push_back({1, SpreadHash(i, 7), true});
  return entries;
}

/// The weights between the borders.
std::vector<uint32_t> Stretches(const std::vector<BorderCandidate>& entries, const std::vector<size_t>& borders) {
  std::vector<uint32_t> stretches = {0};
  size_t border = 0;
  for (size_t i = 0; i < entries.size(); ++i) {
    stretches.back() += entries[i].weight;
    if (border == borders.size() || borders[border] != i) continue;
    stretches.push_back(0);
    ++border;
  }
  return stretches;
}

TEST(ContentBorders, KeepTheLimits) {
  for (const uint32_t count : {50u, 99u, 101u, 5000u}) {
    const auto entries = Entries(count);
    for (const uint32_t stretch : Stretches(entries, ContentBorders(entries, kLimits))) {
      EXPECT_GE(stretch, kLimits.least) << count;
      EXPECT_LE(stretch, kLimits.most) << count;
    }
  }
}

TEST(ContentBorders, AreNoneInAShortOrEmptyList) {
  EXPECT_TRUE(ContentBorders({}, kLimits).empty());
  EXPECT_TRUE(ContentBorders(Entries(49), kLimits).empty());
}

TEST(ContentBorders, OfEqualContentsKeepTheLimitsToo) {
  const std::vector<BorderCandidate> entries(1000, {1, 42, true});
  for (const uint32_t stretch : Stretches(entries, ContentBorders(entries, kLimits))) {
    EXPECT_GE(stretch, kLimits.least);
    EXPECT_LE(stretch, kLimits.most);
  }
}

TEST(ContentBorders, LieWhereTheyAreAllowedOnly) {
  std::vector<BorderCandidate> entries = Entries(1000);
  for (size_t i = 0; i < entries.size(); ++i) entries[i].border = i % 10 == 0;
  for (const size_t border : ContentBorders(entries, kLimits)) EXPECT_EQ(border % 10, 0u);
  for (BorderCandidate& entry : entries) entry.border = false;
  EXPECT_TRUE(ContentBorders(entries, kLimits).empty());
}

TEST(ContentBorders, AHeavyEntryMayExceedTheMost) {
  std::vector<BorderCandidate> entries = Entries(60);
  entries[30].weight = 500;
  const std::vector<uint32_t> stretches = Stretches(entries, ContentBorders(entries, kLimits));
  ASSERT_GE(stretches.size(), 2u);
  for (const uint32_t stretch : stretches) EXPECT_GE(stretch, kLimits.least);
}

/// With least 2 and most 5.
std::vector<size_t> SmallBorders(const std::vector<uint32_t>& hashes) {
  std::vector<BorderCandidate> entries;
  for (const uint32_t hash : hashes) entries.push_back({1, hash, true});
  return ContentBorders(entries, {.least = 2, .most = 5});
}

// Increasing: the first entry with two in front of it is the least around; the rest is cut at its least, and so on.
TEST(ContentBorders, ALongStretchIsCutBehindItsLeastHash) {
  EXPECT_EQ(SmallBorders({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}), (std::vector<size_t>{1, 3, 5, 7}));
  EXPECT_EQ(SmallBorders({3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3}), (std::vector<size_t>{1, 3, 5, 7}));
}

// Decreasing: the last entry with two behind it; six in front of it are one too many.
TEST(ContentBorders, TheFirstStretchIsLongWhereAnyOtherIs) {
  EXPECT_EQ(SmallBorders({8, 7, 6, 5, 4, 3, 2, 1}), (std::vector<size_t>{3, 5}));
  EXPECT_EQ(SmallBorders({7, 6, 5, 4, 3, 2, 1}), (std::vector<size_t>{4}));
}

// The reason for the rule. Borders by hash, so that positions do not matter.
TEST(ContentBorders, AnEditMovesBordersNextToItOnly) {
  const std::vector<BorderCandidate> entries = Entries(3000);
  const auto hashes = [](const std::vector<BorderCandidate>& of) {
    std::set<uint32_t> borders;
    for (const size_t i : ContentBorders(of, kLimits)) borders.insert(of[i].hash);
    return borders;
  };
  const std::set<uint32_t> before = hashes(entries);
  for (size_t at = 0; at < entries.size(); at += 13) {
    std::vector<BorderCandidate> edited = entries;
    edited.insert(edited.begin() + static_cast<std::ptrdiff_t>(at),
                  {1, SpreadHash(static_cast<uint32_t>(at), 8), true});
    const std::set<uint32_t> after = hashes(edited);
    size_t moved = 0;
    for (const uint32_t border : before) moved += after.contains(border) ? 0 : 1;
    EXPECT_LE(moved, 2u) << at;
  }
}

}  // namespace
}  // namespace plcxx::emit::legalize
