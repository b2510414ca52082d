#include "transpiler/fleet/fleet.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "plcxx/texts.h"
#include "transpiler/support/check.h"

namespace plcxx::fleet {
namespace {

constexpr size_t kAlignment = 64;

/// `mask` chooses of each bit.
uint64_t Choose(uint64_t mask, uint64_t yes, uint64_t no) { return (mask & yes) | (~mask & no); }

/// Of retentive memory: planes that are stored together.
constexpr size_t kPlanesOfABlock = 64;
size_t Blocks(const Layout& layout) { return layout.retentive_planes / kPlanesOfABlock + 1; }

}  // namespace

void Fleet::Free::operator()(void* memory) const { std::free(memory); }

Fleet::Fleet(std::shared_ptr<const Library> library) : library_(std::move(library)), has_stored_(lanes() / 64, 0) {
  const size_t bytes = (library_->state_bytes + kAlignment - 1) / kAlignment * kAlignment;
  memory_.reset(std::aligned_alloc(kAlignment, bytes));
  PLCXX_CHECK(memory_ != nullptr);
  std::memset(memory_.get(), 0, bytes);
  const size_t planes = std::max(library_->layout.planes, 1u);
  words_ = static_cast<uint64_t*>(memory_.get());
  if (library_->forces) forced_ = words_ + planes * (lanes() / 64);
  auto* const after = reinterpret_cast<uint8_t*>(words_ + planes * (lanes() / 64) * (library_->forces ? 2 : 1));
  clocks_ = reinterpret_cast<Clock*>(after);
  scalars_ = after + sizeof(Clock) * std::max(library_->layout.clock_count, 1u);
  touched_ = scalars_ + std::max(library_->layout.scalars, 1u);
  stored_planes_.resize(size_t{library_->layout.retentive_planes} * (lanes() / 64));
  host_.context = this;
  host_.call = [](void* context, uint32_t function, const uint64_t* mask, const uint64_t* arguments, uint64_t* results,
                  uint64_t* seconds, uint64_t* has_second) {
    static_cast<Fleet*>(context)->HostCalled(function, mask, arguments, results, seconds, has_second);
  };
}

void Fleet::Run(Piece piece, uint32_t now_ms) {
  host_.now = now_ms;
  library_->run(memory_.get(), &host_, static_cast<uint32_t>(piece));
}

void Fleet::PowerOn() {
  const Layout& layout = library_->layout;
  for (size_t at = 0; at < size_t{layout.planes} * (lanes() / 64); ++at)
    words_[at] &= forced_ != nullptr ? forced_[at] : 0;
  std::fill_n(clocks_, layout.clock_count, Clock{});
  std::fill_n(scalars_, layout.scalars, uint8_t{0});
  std::fill_n(touched_, Blocks(layout), uint8_t{1});
  for (uint32_t s = 0; s < program().spaces.size(); ++s) {
    const ir::Space& space = program().spaces[ir::SpaceId(s)];
    for (const ir::InitialByte& initial : space.initial) {
      if (initial.offset >= space.bytes) continue;
      for (unsigned lane = 0; lane < lanes(); ++lane) {
        for (uint8_t bit = 0; bit < 8; ++bit)
          SetBit(lane, ir::SpaceId(s), initial.offset, bit, (initial.value >> bit & 1) != 0);
      }
    }
  }
  Run(Piece::kInit, 0);
}

void Fleet::SetPlaneBit(uint32_t plane, unsigned lane, bool value) {
  const size_t at = size_t{plane} * (lanes() / 64) + lane / 64;
  const uint64_t mask = uint64_t{1} << (lane % 64);
  if (forced_ != nullptr && (forced_[at] & mask) != 0) return;
  words_[at] = (words_[at] & ~mask) | (value ? mask : 0);
  if (plane < library_->layout.retentive_planes) touched_[plane / kPlanesOfABlock] = 1;
}

bool Fleet::Holds(ir::SpaceId space, uint32_t offset, uint8_t bit) const {
  const auto& homes = library_->layout.bytes[space.index];
  return offset < homes.size() && homes[offset].holds(bit);
}

bool Fleet::Bit(unsigned lane, ir::SpaceId space, uint32_t offset, uint8_t bit) const {
  if (!Holds(space, offset, bit)) return false;
  const ByteHome& home = library_->layout.At(space.index, offset);
  if (home.is_scalar()) return (scalars_[home.scalar] >> bit & 1) != 0;
  return PlaneBit(home.planes[bit], lane);
}

uint8_t Fleet::Byte(unsigned lane, ir::SpaceId space, uint32_t offset) const {
  const auto& homes = library_->layout.bytes[space.index];
  if (offset >= homes.size()) return 0;
  const ByteHome& home = homes[offset];
  if (home.is_scalar()) return scalars_[home.scalar];
  unsigned byte = 0;
  for (unsigned bit = 0; bit < 8; ++bit) {
    if (home.planes[bit] != kNowhere) byte |= (PlaneBit(home.planes[bit], lane) ? 1U : 0U) << bit;
  }
  return static_cast<uint8_t>(byte);
}

void Fleet::SetBit(unsigned lane, ir::SpaceId space, uint32_t offset, uint8_t bit, bool value) {
  if (!Holds(space, offset, bit)) return;
  const ByteHome& home = library_->layout.At(space.index, offset);
  const auto mask = static_cast<uint8_t>(1u << bit);
  if (home.is_scalar()) {
    uint8_t& byte = scalars_[home.scalar];
    byte = static_cast<uint8_t>((byte & ~mask) | (value ? mask : 0));
    return;
  }
  SetPlaneBit(home.planes[bit], lane, value);
}

uint32_t Fleet::FieldPlane(ir::StateId state, uint8_t field, uint32_t element) const {
  const ir::FieldInfo& info = ir::Info(program().states[state].kind).fields[field];
  const uint32_t planes = info.type == ir::Type::kBit ? 1 : 8 * ir::Bytes(info.type);
  return library_->layout.fields[state.index][field] + element * planes;
}

uint64_t Fleet::PlanesOfField(unsigned lane, ir::StateId state, uint8_t field, uint32_t element) const {
  const ir::Type type = ir::Info(program().states[state].kind).fields[field].type;
  const uint32_t bits = type == ir::Type::kBit ? 1 : 8 * ir::Bytes(type);
  const uint32_t first = FieldPlane(state, field, element);
  uint64_t value = 0;
  for (uint32_t i = 0; i < bits; ++i) value |= uint64_t{PlaneBit(first + i, lane)} << i;
  return value;
}

uint64_t Fleet::Field(unsigned lane, ir::StateId state, uint8_t field, uint32_t element) const {
  const std::optional<uint64_t> value = ByClock(lane, state, field);
  return value ? *value : PlanesOfField(lane, state, field, element);
}

void Fleet::SetPlanesOfField(unsigned lane, ir::StateId state, uint8_t field, uint64_t value, uint32_t element) {
  const ir::Type type = ir::Info(program().states[state].kind).fields[field].type;
  const uint32_t bits = type == ir::Type::kBit ? 1 : 8 * ir::Bytes(type);
  const uint32_t first = FieldPlane(state, field, element);
  for (uint32_t i = 0; i < bits; ++i) SetPlaneBit(first + i, lane, (value >> i & 1) != 0);
}

void Fleet::SetField(unsigned lane, ir::StateId state, uint8_t field, uint64_t value, uint32_t element) {
  StopClock(state);
  SetPlanesOfField(lane, state, field, value, element);
}

uint64_t Fleet::Read(unsigned lane, const ir::Place& place) const {
  if (place.is_field()) return Field(lane, place.state, place.field);
  const sim::PlaceAccess access = sim::AccessTo(program(), place);
  if (access.kind == sim::AccessKind::kAbsent) return 0;
  if (access.kind == sim::AccessKind::kBit) return Bit(lane, place.space, access.offset, access.bit) ? 1 : 0;
  uint64_t value = 0;
  for (uint32_t i = 0; i < access.bytes; ++i) {
    const uint32_t significance = access.big_endian ? access.bytes - 1 - i : i;
    value |= uint64_t{Byte(lane, place.space, access.offset + i)} << (8 * significance);
  }
  return value;
}

void Fleet::Write(unsigned lane, const ir::Place& place, uint64_t value) {
  if (place.is_field()) return SetField(lane, place.state, place.field, value);
  sim::ForEachBitOf(program(), place, [&](ir::SpaceId space, uint32_t offset, uint8_t bit, uint32_t at) {
    SetBit(lane, space, offset, bit, (value >> at & 1) != 0);
  });
}

void Fleet::ForceBit(unsigned lane, ir::SpaceId space, uint32_t offset, uint8_t bit, bool forced) {
  PLCXX_CHECK(forced_ != nullptr);
  if (!Holds(space, offset, bit)) return;
  const ByteHome& home = library_->layout.At(space.index, offset);
  if (home.is_scalar()) return;  // nothing that the host sees
  uint64_t& word = forced_[size_t{home.planes[bit]} * (lanes() / 64) + lane / 64];
  const uint64_t mask = uint64_t{1} << (lane % 64);
  word = forced ? word | mask : word & ~mask;
}

void Fleet::ForceField(unsigned lane, ir::StateId state, uint8_t field, bool forced) {
  PLCXX_CHECK(forced_ != nullptr);
  const ir::Type type = ir::Info(program().states[state].kind).fields[field].type;
  const uint32_t bits = type == ir::Type::kBit ? 1 : 8 * ir::Bytes(type);
  const uint64_t mask = uint64_t{1} << (lane % 64);
  for (uint32_t i = 0; i < bits; ++i) {
    uint64_t& word = forced_[size_t{FieldPlane(state, field, 0) + i} * (lanes() / 64) + lane / 64];
    word = forced ? word | mask : word & ~mask;
  }
}

std::span<uint64_t> Fleet::PlaneOf(ir::SpaceId space, uint32_t offset, uint8_t bit) {
  if (!Holds(space, offset, bit)) return {};
  const ByteHome& home = library_->layout.At(space.index, offset);
  if (home.is_scalar()) return {};
  const uint32_t plane = home.planes[bit];
  if (plane < library_->layout.retentive_planes) touched_[plane / kPlanesOfABlock] = 1;
  return {PlaneAt(plane), lanes() / 64};
}

void Fleet::LoadRetentive(const uint64_t* mask) {
  const size_t words = lanes() / 64;
  for (size_t at = 0; at < stored_planes_.size(); ++at) {
    const uint64_t free = mask[at % words] & has_stored_[at % words] & ~(forced_ != nullptr ? forced_[at] : 0);
    words_[at] = Choose(free, stored_planes_[at], words_[at]);
  }
}

void Fleet::StoreRetentive(const uint64_t* mask) {
  const size_t words = lanes() / 64, size = kPlanesOfABlock * words;
  const bool all = std::all_of(mask, mask + words, [](uint64_t word) { return word == ~uint64_t{0}; });
  for (size_t block = 0; block < Blocks(library_->layout); ++block) {
    if (touched_[block] == 0) continue;
    const size_t end = std::min((block + 1) * size, stored_planes_.size());
    for (size_t at = block * size; at < end; ++at)
      stored_planes_[at] = Choose(mask[at % words], words_[at], stored_planes_[at]);
    if (all) touched_[block] = 0;
  }
  for (size_t w = 0; w < words; ++w) has_stored_[w] |= mask[w];
}

void Fleet::StoreRetentive() { StoreRetentive(AllLanes().data()); }

void Fleet::StoreRetentive(unsigned lane) {
  LaneSet one(lanes() / 64, 0);
  one[lane / 64] = uint64_t{1} << (lane % 64);
  StoreRetentive(one.data());
}

void Fleet::SendText(unsigned lane, std::string_view text) {
  const ir::StateId inbox = program().text_inbox;
  if (!inbox.valid()) return;
  const auto field = [](std::string_view name) { return ir::FieldIndex(ir::StateKind::kTextInbox, name); };
  plcxx::TextInbox box{};
  for (uint32_t i = 0; i < plcxx::kLongestText; ++i)
    box.text[i] = static_cast<char>(Field(lane, inbox, field("text"), i));
  box.length = static_cast<uint8_t>(Field(lane, inbox, field("length")));
  plcxx::SendText(box, text.data(), text.size());
  for (uint32_t i = 0; i < plcxx::kLongestText; ++i)
    SetField(lane, inbox, field("text"), static_cast<unsigned char>(box.text[i]), i);
  SetField(lane, inbox, field("length"), box.length);
  SetField(lane, inbox, field("pending"), box.pending ? 1 : 0);
}

void Fleet::BecomeAll(const Fleet& other, unsigned lane) {
  PLCXX_CHECK(library_ == other.library_ && forced_ == nullptr);
  const Layout& layout = library_->layout;
  const size_t words = lanes() / 64;
  const auto of_lane = [lane](const uint64_t* from) {
    return (from[lane / 64] >> (lane % 64) & 1) != 0 ? ~uint64_t{0} : 0;
  };
  for (size_t at = 0; at < layout.planes * words; at += words)
    std::fill_n(words_ + at, words, of_lane(other.words_ + at));
  std::copy_n(other.clocks_, layout.clock_count, clocks_);
  std::copy_n(other.scalars_, layout.scalars, scalars_);
  std::fill_n(touched_, Blocks(layout), uint8_t{1});
  for (size_t at = 0; at < stored_planes_.size(); at += words)
    std::fill_n(&stored_planes_[at], words, of_lane(&other.stored_planes_[at]));
  std::ranges::fill(has_stored_, of_lane(other.has_stored_.data()));
}

void Fleet::HostCalled(uint32_t function, const uint64_t* mask, const uint64_t* arguments, uint64_t* results,
                       uint64_t* seconds, uint64_t* has_second) {
  const ir::HostFunctionId id(function);
  if (answers_) answers_({id, lanes(), mask, arguments, results, seconds, has_second});
  if (id == program().schedule.retentive_load) LoadRetentive(mask);
  if (id == program().schedule.retentive_store) StoreRetentive(mask);
}

std::vector<uint8_t> Fleet::Snapshot(unsigned lane, const std::vector<std::vector<uint8_t>>& others) const {
  std::vector<uint8_t> bytes;
  for (uint32_t s = 0; s < program().spaces.size(); ++s) {
    if (!program().spaces[ir::SpaceId(s)].host_visible) continue;
    for (uint32_t offset = 0; offset < library_->layout.bytes[s].size(); ++offset) {
      const ByteHome& home = library_->layout.At(s, offset);
      uint8_t byte = others[s][offset];
      for (uint8_t bit = 0; bit < 8; ++bit) {
        if (home.planes[bit] == kNowhere) continue;
        const int mask = 1 << bit;
        byte = static_cast<uint8_t>((byte & ~mask) | (PlaneBit(home.planes[bit], lane) ? mask : 0));
      }
      bytes.push_back(byte);
    }
  }
  for (uint32_t i = 0; i < program().states.size(); ++i) {
    const auto fields = ir::Info(program().states[ir::StateId(i)].kind).fields;
    for (uint8_t f = 0; f < static_cast<uint8_t>(fields.size()); ++f) {
      for (uint32_t element = 0; element < fields[f].count; ++element) {
        const uint64_t value = Field(lane, ir::StateId(i), f, element);
        for (uint32_t b = 0; b < ir::Bytes(fields[f].type); ++b)
          bytes.push_back(static_cast<uint8_t>(value >> (8 * b)));
      }
    }
  }
  return bytes;
}

}  // namespace plcxx::fleet
