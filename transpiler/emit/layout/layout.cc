#include "transpiler/emit/layout/layout.h"

#include <algorithm>

#include "transpiler/ir/builder.h"
#include "transpiler/support/check.h"

namespace plcxx::emit::layout {
namespace {

using ir::Place;
using ir::PlaceId;
using ir::SpaceId;
using ir::StateId;
using ir::Type;

constexpr uint32_t kRetentiveHeader = 4;  // the layout hash in front of the bytes

/// How the program touches one byte, alone.
struct Use {
  uint8_t bits = 0;    // mask of single bits
  bool whole = false;  // as a byte
};

/// Bytes [begin, end) that one access touches together.
struct Span {
  uint32_t begin = 0, end = 0;
  Type type = Type::kNone;  // kNone: more than one width, type or place, or an index
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
  mark(program.schedule.fast_done);
  mark(program.schedule.retain_at_power_off);
  for (const ir::MessageWord& word : program.message_words) mark(word.place);
  for (const ir::Loop& loop : program.loops) mark(loop.budget);
  for (const ir::Call& call : program.calls) mark(call.out);
  return used;
}

Storage WordOf(Type type) {
  switch (type) {
    case Type::kI16:
      return Storage::kWord16;
    case Type::kI32:
      return Storage::kWord32;
    case Type::kI64:
      return Storage::kWord64;
    case Type::kF32:
      return Storage::kFloat32;
    case Type::kF64:
      return Storage::kFloat64;
    case Type::kNone:
    case Type::kBit:
    case Type::kI8:
      break;
  }
  PLCXX_UNREACHABLE();
}

constexpr size_t kWords = 5;
size_t WordIndex(Storage storage) { return static_cast<size_t>(storage) - static_cast<size_t>(Storage::kWord16); }
uint32_t WordBytes(Storage storage) { return ir::Bytes(WordMemberOf(storage).type); }

struct Builder {
  const ir::Program& program;
  Layout layout;
  std::vector<std::vector<Use>> uses;    // by SpaceId; of volatile spaces
  std::vector<std::vector<Span>> spans;  // by SpaceId; of volatile spaces, apart from each other and ascending
  uint32_t bits = 0, bytes = 0;
  uint32_t words[kWords] = {};

  void CollectUses(const std::vector<bool>& used);
  void JoinSpans();
  void PlaceSpaces();
  void PlaceVolatile(SpaceId id);
  void PlaceStretches();
  void PlaceStates();
  void LayOut();
  void Locate(PlaceStorage& stored) const;
  void ResolvePlaces(const std::vector<bool>& used);
  PlaceStorage InMemory(const Place& place) const;
  uint32_t MemberOffset(std::string_view name) const;
};

void Builder::CollectUses(const std::vector<bool>& used) {
  for (const ir::Space& space : program.spaces) {
    uses.emplace_back(space.lifetime == ir::Lifetime::kVolatile ? space.bytes : 0);
  }
  spans.resize(uses.size());
  for (uint32_t i = 0; i < program.places.size(); ++i) {
    const Place& place = program.places[PlaceId(i)];
    if (!used[i] || place.is_field()) continue;
    PLCXX_CHECK(!place.indexed || (place.type != Type::kBit && place.low < place.high));
    if (uses[place.space.index].empty()) continue;
    if (place.indexed) {
      spans[place.space.index].push_back({place.low, place.high, Type::kNone});
      continue;
    }
    if (ir::Bytes(place.type) > 1) {
      spans[place.space.index].push_back({place.offset, place.offset + ir::Bytes(place.type), place.type});
      continue;
    }
    Use& use = uses[place.space.index][place.offset];
    if (place.type == Type::kBit) {
      use.bits |= static_cast<uint8_t>(1u << place.bit);
    } else {
      use.whole = true;
    }
  }
}

void Builder::JoinSpans() {
  for (uint32_t s = 0; s < spans.size(); ++s) {
    std::vector<Span>& all = spans[s];
    std::stable_sort(all.begin(), all.end(), [](const Span& a, const Span& b) { return a.begin < b.begin; });
    size_t kept = 0;
    for (size_t i = 0; i < all.size(); ++i) {
      Span* const last = kept > 0 ? &all[kept - 1] : nullptr;
      if (last == nullptr || last->end <= all[i].begin) {
        all[kept++] = all[i];
        continue;
      }
      const bool same = last->end == all[i].end && last->type == all[i].type;  // of one type: of one size
      if (!same) last->type = Type::kNone;
      last->end = std::max(last->end, all[i].end);
    }
    all.resize(kept);
    for (Span& span : all) {
      for (uint32_t b = span.begin; b < span.end; ++b) {
        if (uses[s][b].bits != 0 || uses[s][b].whole) span.type = Type::kNone;
      }
    }
  }
}

void Builder::PlaceVolatile(SpaceId id) {
  std::vector<ByteStorage>& stored = layout.bytes[id.index];
  size_t next = 0;  // of the spans
  for (uint32_t b = 0; b < stored.size(); ++b) {
    const std::vector<Span>& found = spans[id.index];
    if (next < found.size() && found[next].begin == b) {
      const Span& span = found[next++];
      if (span.type == Type::kNone) {
        layout.stretches.push_back({.space = id, .begin = span.begin, .end = span.end});
      } else {
        const Storage storage = WordOf(span.type);
        const uint32_t index = words[WordIndex(storage)]++;
        for (uint32_t k = span.begin; k < span.end; ++k) stored[k].whole = {.storage = storage, .index = index};
      }
      b = span.end - 1;
      continue;
    }
    const Use& use = uses[id.index][b];
    if (use.whole) {
      stored[b].whole = {.storage = Storage::kByte, .index = bytes++};
      continue;
    }
    for (uint8_t bit = 0; bit < 8; ++bit) {
      if ((use.bits >> bit & 1) != 0) stored[b].bits[bit] = {.storage = Storage::kBit, .index = bits++};
    }
  }
}

void Builder::PlaceSpaces() {
  layout.bytes.resize(program.spaces.size());
  for (uint32_t s = 0; s < program.spaces.size(); ++s) {
    const ir::Space& space = program.spaces[SpaceId(s)];
    if (space.lifetime == ir::Lifetime::kRoutine) continue;
    layout.bytes[s].resize(space.bytes);
    if (space.lifetime == ir::Lifetime::kVolatile) {
      PlaceVolatile(SpaceId(s));
      continue;
    }
    for (uint32_t b = 0; b < space.bytes; ++b) {
      layout.bytes[s][b].whole = {.storage = Storage::kRetentiveByte, .index = layout.retentive_bytes + b};
    }
    layout.retentive_bytes += space.bytes;
  }
}

/// After the single bytes: a program that gets one more of these moves no stretch's name.
void Builder::PlaceStretches() {
  for (Stretch& stretch : layout.stretches) {
    stretch.index = bytes;
    for (uint32_t b = stretch.begin; b < stretch.end; ++b) {
      layout.bytes[stretch.space.index][b].whole = {.storage = Storage::kByte, .index = bytes++};
    }
  }
}

void Builder::PlaceStates() {
  std::vector<uint32_t> counts(ir::StateKindCount(), 0);
  for (const ir::StateInstance& state : program.states) {
    layout.states.push_back({.index = counts[static_cast<size_t>(state.kind)]++});
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
  const auto add_word = [&](Storage storage) {
    const WordMember& member = WordMemberOf(storage);
    const uint32_t size = ir::Bytes(member.type);
    add(std::string(member.name), std::string(ir::CppName(member.type)), words[WordIndex(storage)], size, size);
  };
  if (layout.retentive_bytes > 0) {
    const uint32_t size = RoundUp(kRetentiveHeader + layout.retentive_bytes, 4);
    add("retentive", "Retentive", 1, size, 4);
  }
  add_word(Storage::kWord64);
  add_word(Storage::kFloat64);
  add_word(Storage::kWord32);
  add_word(Storage::kFloat32);
  for (uint32_t k = 0; k < ir::StateKindCount(); ++k) {
    const auto kind = static_cast<ir::StateKind>(k);
    uint32_t count = 0;
    for (const ir::StateInstance& state : program.states) count += state.kind == kind ? 1 : 0;
    add(std::string(ir::Info(kind).text), "plcxx::" + std::string(ir::Info(kind).struct_name), count, StructBytes(kind),
        StructAlignment(kind));
  }
  add_word(Storage::kWord16);
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

void Builder::Locate(PlaceStorage& stored) const {
  switch (stored.storage) {
    case Storage::kBit:
      stored.offset = MemberOffset("bit") + stored.index;
      break;
    case Storage::kByte:
    case Storage::kPackedBit:
    case Storage::kWide:
    case Storage::kIndexed:
      stored.offset = MemberOffset("byte") + stored.index;
      break;
    case Storage::kWord16:
    case Storage::kWord32:
    case Storage::kWord64:
    case Storage::kFloat32:
    case Storage::kFloat64:
      stored.offset = MemberOffset(WordMemberOf(stored.storage).name) + WordBytes(stored.storage) * stored.index;
      break;
    case Storage::kRetentiveByte:
    case Storage::kRetentiveBit:
    case Storage::kRetentiveWide:
    case Storage::kRetentiveIndexed:
      stored.offset = MemberOffset("retentive") + kRetentiveHeader + stored.index;
      break;
    case Storage::kNone:
    case Storage::kField:
    case Storage::kLocal:
      break;
  }
}

PlaceStorage Builder::InMemory(const Place& place) const {
  const bool retentive = program.spaces[place.space].lifetime == ir::Lifetime::kRetentive;
  const ByteStorage& byte = layout.bytes[place.space.index][place.indexed ? place.low : place.offset];
  PlaceStorage stored = byte.whole;
  if (place.indexed) {
    stored.storage = retentive ? Storage::kRetentiveIndexed : Storage::kIndexed;
  } else if (place.type == Type::kBit) {
    if (stored.storage == Storage::kNone) return byte.bits[place.bit];
    stored.storage = retentive ? Storage::kRetentiveBit : Storage::kPackedBit;
    stored.bit = place.bit;
  } else if (ir::Bytes(place.type) > 1 && !IsWord(stored.storage)) {
    stored.storage = retentive ? Storage::kRetentiveWide : Storage::kWide;
  }
  Locate(stored);
  return stored;
}

void Builder::ResolvePlaces(const std::vector<bool>& used) {
  for (uint32_t s = 0; s < layout.bytes.size(); ++s) {
    const bool big_endian = program.spaces[SpaceId(s)].order == ir::ByteOrder::kBig;
    uint32_t in_word = 0;  // number of the byte in its word
    for (uint32_t b = 0; b < layout.bytes[s].size(); ++b) {
      ByteStorage& stored = layout.bytes[s][b];
      Locate(stored.whole);
      for (PlaceStorage& bit : stored.bits) Locate(bit);
      if (!IsWord(stored.whole.storage)) continue;
      const uint32_t size = WordBytes(stored.whole.storage);
      stored.whole.offset += big_endian ? size - 1 - in_word : in_word;
      in_word = in_word + 1 == size ? 0 : in_word + 1;
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
      const StateStorage& state = layout.states[place.state.index];
      stored = {
          .storage = Storage::kField, .index = state.index, .offset = state.offset + FieldOffset(kind, place.field)};
    } else if (program.spaces[place.space].lifetime == ir::Lifetime::kRoutine) {
      stored.storage = Storage::kLocal;
    } else if (used[i]) {
      stored = InMemory(place);
    }
  }
}

}  // namespace

Layout MakeLayout(const ir::Program& program) {
  const std::vector<bool> used = UsedPlaces(program);
  Builder builder{.program = program, .layout = {}, .uses = {}, .spans = {}};
  builder.CollectUses(used);
  builder.JoinSpans();
  builder.PlaceSpaces();
  builder.PlaceStretches();
  builder.PlaceStates();
  builder.LayOut();
  builder.ResolvePlaces(used);
  return std::move(builder.layout);
}

}  // namespace plcxx::emit::layout
