// Where random places lie in State: what the program may rely on, whatever overlaps what.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "transpiler/emit/layout/layout.h"
#include "transpiler/ir/printer.h"
#include "transpiler/ir/reader.h"

namespace plcxx::emit::layout {
namespace {

constexpr uint32_t kBytes = 48;  // of each space

struct Bytes {
  uint32_t begin = 0, end = 0;
  bool Overlaps(const Bytes& other) const { return begin < other.end && other.begin < end; }
};

/// What an access touches of the space.
Bytes InSpace(const ir::Place& place) {
  if (place.indexed) return {place.low, place.high};
  return {place.offset, place.offset + std::max(1u, ir::Bytes(place.type))};
}

Bytes InState(const ir::Place& place, const PlaceStorage& stored) {
  const Bytes space = InSpace(place);
  return {stored.offset, stored.offset + space.end - space.begin};
}

/// Bits and bytes mostly, words of all types, some with an index; in three spaces.
std::string RandomProgram(std::mt19937& random, uint32_t places) {
  const auto below = [&random](uint32_t n) { return static_cast<uint32_t>(random() % n); };
  std::string text =
      "program \"p\" test\nspace little_one 48 volatile little\nspace big_one 48 volatile big\nspace kept 48 retentive "
      "little\n";
  std::string body;
  for (uint32_t i = 0; i < places; ++i) {
    static constexpr const char* kTypes[] = {"bit", "bit", "bit", "i8", "i8", "i16", "i32", "i64", "f32", "f64"};
    static constexpr uint32_t kSizes[] = {1, 1, 1, 1, 1, 2, 4, 8, 4, 8};
    const uint32_t type = below(10), size = kSizes[type];
    const std::string space = std::vector<std::string>{"little_one", "big_one", "kept"}[below(3)];
    // Words mostly at their own borders, so that some are alone.
    const uint32_t at = below(4) == 0 ? below(kBytes - size + 1) : size * below(kBytes / size);
    const std::string name = "p" + std::to_string(i);
    text += "place " + name + " " + kTypes[type] + " " + space + "[" + std::to_string(at) + "]";
    const bool indexed = type > 2 && below(8) == 0;
    if (type <= 2) text += "." + std::to_string(below(8));
    if (indexed) {
      const uint32_t low = std::min(at, kBytes - 16), high = low + std::max(size, 1 + below(16));
      text += " stride " + std::to_string(size) + " low " + std::to_string(low) + " high " + std::to_string(high) +
              " indexed";
    }
    text += "\n";
    const std::string value = "%" + std::to_string(2 * i + 1), index = "%" + std::to_string(2 * i);
    if (below(6) == 0) continue;  // nothing touches it
    if (indexed) body += index + " = const i32 0\n";
    body += value + " = load " + name + (indexed ? "[" + index + "]" : "") + "\n";
  }
  return text + "routine fast fast {\n" + body + "}\n";
}

bool IsInStretch(Storage storage) { return storage == Storage::kWide || storage == Storage::kIndexed; }

void Check(const ir::Program& program, const Layout& layout) {
  std::vector<bool> used(program.places.size());
  for (const ir::Inst& inst : program.insts) {
    if (inst.op == ir::OpKind::kLoad) used[inst.payload] = true;
  }
  for (size_t i = 0; i < layout.members.size(); ++i) {
    const Member& member = layout.members[i];
    const uint32_t end = member.offset + member.count * member.element_bytes;
    EXPECT_LE(end, i + 1 < layout.members.size() ? layout.members[i + 1].offset : layout.size) << member.name;
  }
  for (uint32_t i = 0; i < used.size(); ++i) {
    const ir::Place& place = program.places[ir::PlaceId(i)];
    const PlaceStorage& stored = layout.places[i];
    EXPECT_EQ(stored.storage != Storage::kNone, used[i]);
    if (!used[i]) continue;
    const Bytes space = InSpace(place), state = InState(place, stored);
    EXPECT_LE(state.end, layout.size);
    const bool word = stored.storage >= Storage::kWord16 && stored.storage <= Storage::kFloat64;
    if (word) {
      EXPECT_EQ(stored.offset % ir::Bytes(place.type), 0u);
    }
    bool shared = false, shared_bits_only = true;
    for (uint32_t k = 0; k < used.size(); ++k) {
      if (k == i || !used[k]) continue;
      const ir::Place& other = program.places[ir::PlaceId(k)];
      const PlaceStorage& there = layout.places[k];
      const Bytes other_space = InSpace(other), other_state = InState(other, there);
      if (other.space != place.space || !space.Overlaps(other_space)) {
        EXPECT_FALSE(state.Overlaps(other_state)) << place.name << " and " << other.name;
        continue;
      }
      const bool one_bit = place.type == ir::Type::kBit && other.type == ir::Type::kBit;
      const bool equal = space.begin == other_space.begin && space.end == other_space.end && place.type == other.type &&
                         place.indexed == other.indexed;
      if (!equal || (one_bit && place.bit != other.bit)) shared_bits_only = shared_bits_only && one_bit;
      shared = shared || (!equal && !one_bit);
      if (stored.storage == Storage::kBit && there.storage == Storage::kBit) {
        EXPECT_EQ(place.bit == other.bit, stored.offset == there.offset) << place.name << " and " << other.name;
      } else {
        // Both ways of looking at a byte see the same one.
        EXPECT_EQ(int64_t{stored.offset} - space.begin, int64_t{there.offset} - other_space.begin)
            << place.name << " and " << other.name;
      }
    }
    if (program.spaces[place.space].lifetime == ir::Lifetime::kRetentive) {
      EXPECT_EQ(state.begin, 4 + space.begin) << place.name;  // behind the hash
      continue;
    }
    // Alone it has the form that is read fastest.
    if (place.indexed) {
      EXPECT_EQ(stored.storage, Storage::kIndexed) << place.name;
    } else if (place.type == ir::Type::kBit) {
      EXPECT_EQ(stored.storage, shared_bits_only ? Storage::kBit : Storage::kPackedBit) << place.name;
      if (!shared_bits_only) {
        EXPECT_EQ(stored.bit, place.bit);
      }
    } else if (place.type == ir::Type::kI8) {
      EXPECT_EQ(stored.storage, Storage::kByte) << place.name;
    } else {
      EXPECT_EQ(word, !shared) << place.name;
      EXPECT_EQ(IsInStretch(stored.storage), shared) << place.name;
    }
    // Each byte of a word is where the processor, which keeps the lowest first, has it.
    const bool big = program.spaces[place.space].order == ir::ByteOrder::kBig;
    for (uint32_t b = 0; word && b < space.end - space.begin; ++b) {
      const PlaceStorage& byte = layout.bytes[place.space.index][space.begin + b].whole;
      EXPECT_EQ(byte.offset, stored.offset + (big ? space.end - space.begin - 1 - b : b)) << place.name;
    }
  }
}

TEST(RandomLayout, WhatOverlapsIsOnePlaceAndNothingElseIs) {
  std::mt19937 random(1911);
  for (uint32_t round = 0; round < 400 && !testing::Test::HasFailure(); ++round) {
    const ir::Program program = ir::ReadOrDie(RandomProgram(random, 1 + round % 40));
    Check(program, MakeLayout(program));
    if (testing::Test::HasFailure()) ADD_FAILURE() << ir::Print(program);
  }
}

}  // namespace
}  // namespace plcxx::emit::layout
