#include "transpiler/emit/layout.h"

#include <algorithm>

#include "transpiler/ir/builder.h"
#include "transpiler/support/check.h"

namespace plcxx::emit {
namespace {

using ir::Place;
using ir::PlaceId;
using ir::SpaceId;
using ir::StateId;
using ir::Type;

constexpr uint32_t kRetentiveHeader = 4;  // the layout hash in front of the bytes

uint32_t RoundUp(uint32_t value, uint32_t alignment) { return (value + alignment - 1) / alignment * alignment; }

/// How the program touches one byte.
struct Use {
  uint8_t bits = 0;    // mask of single bits
  bool whole = false;  // as a byte
  uint8_t wide = 0;    // size of the word that starts here
  bool inside_wide = false;
};

std::vector<bool> UsedPlaces(const ir::Program& program) {
  std::vector<bool> used(program.places.size());
  for (const ir::Inst& inst : program.insts) {
    const ir::Shape shape = ir::Info(inst.op).shape;
    if (shape == ir::Shape::kLoad || shape == ir::Shape::kStore) used[inst.payload] = true;
  }
  const auto mark = [&used](PlaceId place) {
    if (place.valid()) used[place.index] = true;
  };
  mark(program.schedule.slow_done);
  mark(program.schedule.retain_at_power_off);
  for (const ir::MessageWord& word : program.message_words) mark(word.place);
  for (const ir::Loop& loop : program.loops) mark(loop.budget);
  return used;
}

struct Builder {
  const ir::Program& program;
  Layout layout;
  std::vector<std::vector<Use>> uses;
  uint32_t bits = 0, bytes = 0, words16 = 0, words32 = 0, words64 = 0;

  void CollectUses(const std::vector<bool>& used);
  void PlaceSpaces();
  void PlaceStates();
  void LayOut();
  void ResolvePlaces(const std::vector<bool>& used);
  uint32_t MemberOffset(std::string_view name) const;
};

void Builder::CollectUses(const std::vector<bool>& used) {
  for (const ir::Space& space : program.spaces) {
    uses.emplace_back(space.lifetime == ir::Lifetime::kVolatile ? space.bytes : 0);
  }
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    const Place& place = program.places[PlaceId(i)];
    if (!used[i] || place.is_field() || uses[place.space.index].empty()) continue;
    PLCXX_CHECK(!place.indexed);  // raw storage arrives with the first dialect that indexes
    Use& use = uses[place.space.index][place.offset];
    if (place.type == Type::kBit) {
      use.bits |= static_cast<uint8_t>(1u << place.bit);
    } else if (ir::Bytes(place.type) == 1) {
      use.whole = true;
    } else {
      use.wide = static_cast<uint8_t>(ir::Bytes(place.type));
      for (uint32_t k = 1; k < use.wide; ++k) uses[place.space.index][place.offset + k].inside_wide = true;
    }
  }
}

void Builder::PlaceSpaces() {
  layout.retentive_base.assign(program.spaces.size(), 0);
  layout.bytes.resize(program.spaces.size());
  for (uint32_t s = 0; s < program.spaces.size(); ++s) {
    const ir::Space& space = program.spaces[SpaceId(s)];
    if (space.lifetime == ir::Lifetime::kRoutine) continue;
    layout.bytes[s].resize(space.bytes);
    if (space.lifetime == ir::Lifetime::kRetentive) {
      layout.retentive_base[s] = layout.retentive_bytes;
      for (uint32_t b = 0; b < space.bytes; ++b) {
        layout.bytes[s][b].whole = {Storage::kRetentiveByte, layout.retentive_bytes + b, 0, 0};
      }
      layout.retentive_bytes += space.bytes;
      continue;
    }
    for (uint32_t b = 0; b < space.bytes; ++b) {
      const Use& use = uses[s][b];
      ByteStorage& stored = layout.bytes[s][b];
      if (use.wide != 0) {
        // A word of its own; words that overlap other accesses arrive with the first dialect that has them.
        PLCXX_CHECK(use.bits == 0 && !use.whole && !use.inside_wide);
        const Storage storage = use.wide == 2 ? Storage::kWord16 : use.wide == 4 ? Storage::kWord32 : Storage::kWord64;
        uint32_t& next = use.wide == 2 ? words16 : use.wide == 4 ? words32 : words64;
        stored.whole = {storage, next++, 0, 0};
      } else if (use.whole) {
        PLCXX_CHECK(!use.inside_wide);
        stored.whole = {Storage::kByte, bytes++, 0, 0};
      } else {
        PLCXX_CHECK(use.bits == 0 || !use.inside_wide);
        for (uint8_t bit = 0; bit < 8; ++bit) {
          if ((use.bits >> bit & 1) != 0) stored.bits[bit] = {Storage::kBit, bits++, 0, 0};
        }
      }
    }
  }
}

void Builder::PlaceStates() {
  std::vector<uint32_t> counts(ir::StateKindCount(), 0);
  for (const ir::StateInstance& state : program.states) {
    layout.states.push_back({counts[static_cast<size_t>(state.kind)]++, 0});
  }
}

void Builder::LayOut() {
  uint32_t offset = 0, alignment = 1;
  const auto add = [&](std::string name, std::string element, uint32_t count, uint32_t size, uint32_t align) {
    if (count == 0) return;
    offset = RoundUp(offset, align);
    alignment = std::max(alignment, align);
    layout.members.push_back({std::move(name), std::move(element), count, size, offset});
    offset += count * size;
  };
  if (layout.retentive_bytes > 0) {
    const uint32_t size = RoundUp(kRetentiveHeader + layout.retentive_bytes, 4);
    add("retentive", "Retentive", 1, size, 4);
  }
  add("word64", "uint64_t", words64, 8, 8);
  add("word32", "uint32_t", words32, 4, 4);
  for (uint32_t k = 0; k < ir::StateKindCount(); ++k) {
    const auto kind = static_cast<ir::StateKind>(k);
    uint32_t count = 0;
    for (const ir::StateInstance& state : program.states) count += state.kind == kind ? 1 : 0;
    add(std::string(ir::Info(kind).text), "plcxx::" + std::string(ir::Info(kind).struct_name), count, StructBytes(kind),
        StructAlignment(kind));
  }
  add("word16", "uint16_t", words16, 2, 2);
  add("byte", "uint8_t", bytes, 1, 1);
  add("bit", "bool", bits, 1, 1);
  layout.size = RoundUp(std::max(offset, 1u), alignment);
}

uint32_t Builder::MemberOffset(std::string_view name) const {
  for (const Member& member : layout.members) {
    if (member.name == name) return member.offset;
  }
  PLCXX_UNREACHABLE();
}

void Builder::ResolvePlaces(const std::vector<bool>& used) {
  const auto locate = [this](PlaceStorage& stored) {
    switch (stored.storage) {
      case Storage::kBit:
        stored.offset = MemberOffset("bit") + stored.index;
        break;
      case Storage::kByte:
      case Storage::kPackedBit:
        stored.offset = MemberOffset("byte") + stored.index;
        break;
      case Storage::kWord16:
        stored.offset = MemberOffset("word16") + 2 * stored.index;
        break;
      case Storage::kWord32:
        stored.offset = MemberOffset("word32") + 4 * stored.index;
        break;
      case Storage::kWord64:
        stored.offset = MemberOffset("word64") + 8 * stored.index;
        break;
      case Storage::kRetentiveByte:
      case Storage::kRetentiveBit:
        stored.offset = MemberOffset("retentive") + kRetentiveHeader + stored.index;
        break;
      case Storage::kNone:
      case Storage::kField:
      case Storage::kLocal:
        break;
    }
  };
  for (auto& space : layout.bytes) {
    for (ByteStorage& stored : space) {
      locate(stored.whole);
      for (PlaceStorage& bit : stored.bits) locate(bit);
    }
  }
  for (uint32_t i = 0; i < program.states.size(); ++i) {
    const ir::StateKind kind = program.states[StateId(i)].kind;
    layout.states[i].offset = MemberOffset(ir::Info(kind).text) + layout.states[i].index * StructBytes(kind);
  }
  layout.places.resize(program.places.size());
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    const Place& place = program.places[PlaceId(i)];
    PlaceStorage& stored = layout.places[i];
    if (place.is_field()) {
      const ir::StateKind kind = program.states[place.state].kind;
      stored = {Storage::kField, layout.states[place.state.index].index, 0,
                layout.states[place.state.index].offset + FieldOffset(kind, place.field)};
    } else if (program.spaces[place.space].lifetime == ir::Lifetime::kRoutine) {
      stored = {Storage::kLocal, 0, 0, 0};
    } else if (used[i]) {
      const ByteStorage& byte = layout.bytes[place.space.index][place.offset];
      if (place.type != Type::kBit) {
        stored = byte.whole;
      } else if (byte.whole.storage == Storage::kNone) {
        stored = byte.bits[place.bit];
      } else {
        stored = byte.whole;
        stored.storage = stored.storage == Storage::kByte ? Storage::kPackedBit : Storage::kRetentiveBit;
        stored.bit = place.bit;
      }
    }
  }
}

}  // namespace

uint32_t FieldOffset(ir::StateKind kind, uint8_t field) {
  const auto fields = ir::Info(kind).fields;
  uint32_t offset = 0;
  for (uint8_t i = 0;; ++i) {
    offset = RoundUp(offset, ir::Bytes(fields[i].type));
    if (i == field) return offset;
    offset += ir::Bytes(fields[i].type) * fields[i].count;
  }
}

uint32_t StructAlignment(ir::StateKind kind) {
  uint32_t alignment = 1;
  for (const ir::FieldInfo& field : ir::Info(kind).fields) alignment = std::max(alignment, ir::Bytes(field.type));
  return alignment;
}

uint32_t StructBytes(ir::StateKind kind) {
  const auto fields = ir::Info(kind).fields;
  const auto last = static_cast<uint8_t>(fields.size() - 1);
  return RoundUp(FieldOffset(kind, last) + ir::Bytes(fields[last].type) * fields[last].count, StructAlignment(kind));
}

Layout MakeLayout(const ir::Program& program) {
  const std::vector<bool> used = UsedPlaces(program);
  Builder builder{.program = program, .layout = {}, .uses = {}};
  builder.CollectUses(used);
  builder.PlaceSpaces();
  builder.PlaceStates();
  builder.LayOut();
  builder.ResolvePlaces(used);
  return std::move(builder.layout);
}

}  // namespace plcxx::emit
