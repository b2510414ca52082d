#include "transpiler/fleet/fleet.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "transpiler/support/check.h"

namespace plcxx::fleet {
namespace {

constexpr size_t kAlignment = 64;
// Of an on-delay timer.
constexpr uint8_t kElapsedMs = 0, kLastMs = 1, kTimerInput = 2;

/// `mask` chooses of each bit.
uint64_t Choose(uint64_t mask, uint64_t yes, uint64_t no) { return (mask & yes) | (~mask & no); }

/// The chosen bits of a row, but those that are forced (which may be none).
void CopyRow(const std::vector<uint8_t>& chosen, const uint8_t* forced, const uint8_t* from, uint8_t* to) {
  for (size_t lane = 0; lane < chosen.size(); ++lane) {
    const int free = chosen[lane] & ~(forced != nullptr ? forced[lane] : 0);
    to[lane] = static_cast<uint8_t>((to[lane] & ~free) | (from[lane] & free));
  }
}

}  // namespace

void Fleet::Free::operator()(void* memory) const { std::free(memory); }

Fleet::Fleet(std::shared_ptr<const Library> library) : library_(std::move(library)), has_stored_(lanes() / 64, 0) {
  const size_t bytes = (library_->state_bytes + kAlignment - 1) / kAlignment * kAlignment;
  memory_.reset(std::aligned_alloc(kAlignment, bytes));
  PLCXX_CHECK(memory_ != nullptr);
  std::memset(memory_.get(), 0, bytes);
  const size_t planes = std::max(library_->layout.planes, 1u), rows = std::max(library_->layout.rows, 1u);
  words_ = static_cast<uint64_t*>(memory_.get());
  rows_ = reinterpret_cast<uint8_t*>(PlaneAt(static_cast<uint32_t>(planes)));
  if (library_->forces) {
    forced_ = reinterpret_cast<uint64_t*>(RowAt(static_cast<uint32_t>(rows)));
    forced_rows_ = reinterpret_cast<uint8_t*>(forced_ + planes * (lanes() / 64));
  }
  uint8_t* const after = library_->forces ? forced_rows_ + rows * lanes() : RowAt(static_cast<uint32_t>(rows));
  clocks_ = reinterpret_cast<Clock*>(after);
  scalars_ = after + sizeof(Clock) * std::max(library_->layout.clock_count, 1u);
  stored_planes_.resize(planes * (lanes() / 64));
  stored_rows_.resize(rows * lanes());
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
  for (size_t at = 0; at < size_t{layout.rows} * lanes(); ++at)
    rows_[at] = static_cast<uint8_t>(rows_[at] & (forced_rows_ != nullptr ? forced_rows_[at] : 0));
  std::fill_n(clocks_, layout.clock_count, Clock{});
  std::fill_n(scalars_, layout.scalars, uint8_t{0});
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
}

bool Fleet::Holds(ir::SpaceId space, uint32_t offset, uint8_t bit) const {
  const auto& homes = library_->layout.bytes[space.index];
  return offset < homes.size() && homes[offset].holds(bit);
}

bool Fleet::Bit(unsigned lane, ir::SpaceId space, uint32_t offset, uint8_t bit) const {
  if (!Holds(space, offset, bit)) return false;
  const ByteHome& home = library_->layout.At(space.index, offset);
  if (home.is_scalar()) return (scalars_[home.scalar] >> bit & 1) != 0;
  return home.is_row() ? (RowAt(home.row)[lane] >> bit & 1) != 0 : PlaneBit(home.planes[bit], lane);
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
  if (!home.is_row()) return SetPlaneBit(home.planes[bit], lane, value);
  const size_t at = size_t{home.row} * lanes() + lane;
  if (forced_rows_ != nullptr && (forced_rows_[at] & mask) != 0) return;
  rows_[at] = static_cast<uint8_t>((rows_[at] & ~mask) | (value ? mask : 0));
}

uint32_t Fleet::FieldPlane(ir::StateId state, uint8_t field, uint32_t element) const {
  const ir::FieldInfo& info = ir::Info(program().states[state].kind).fields[field];
  const uint32_t planes = info.type == ir::Type::kBit ? 1 : 8 * ir::Bytes(info.type);
  return library_->layout.fields[state.index][field] + element * planes;
}

uint64_t Fleet::Field(unsigned lane, ir::StateId state, uint8_t field, uint32_t element) const {
  const ir::Type type = ir::Info(program().states[state].kind).fields[field].type;
  const uint32_t bits = type == ir::Type::kBit ? 1 : 8 * ir::Bytes(type);
  const uint32_t first = FieldPlane(state, field, element);
  if (const uint32_t at = library_->layout.clocks[state.index]; at != kNowhere && clocks_[at].runs != 0) {
    if (field == kLastMs) return clocks_[at].last;
    if (field == kElapsedMs) {
      uint32_t start = 0;
      for (uint32_t i = 0; i < bits; ++i) start |= uint32_t{PlaneBit(first + i, lane)} << i;
      return Field(lane, state, kTimerInput) != 0 ? clocks_[at].last - start : 0;
    }
  }
  uint64_t value = 0;
  for (uint32_t i = 0; i < bits; ++i) value |= uint64_t{PlaneBit(first + i, lane)} << i;
  return value;
}

void Fleet::StopClock(ir::StateId state) {
  const uint32_t at = library_->layout.clocks[state.index];
  if (at == kNowhere || clocks_[at].runs == 0) return;
  std::vector<uint64_t> elapsed(lanes());
  for (unsigned lane = 0; lane < lanes(); ++lane) elapsed[lane] = Field(lane, state, kElapsedMs);
  const uint32_t last = clocks_[at].last;
  clocks_[at].runs = 0;
  for (unsigned lane = 0; lane < lanes(); ++lane) {
    for (uint32_t i = 0; i < 32; ++i) {
      SetPlaneBit(FieldPlane(state, kElapsedMs, 0) + i, lane, (elapsed[lane] >> i & 1) != 0);
      SetPlaneBit(FieldPlane(state, kLastMs, 0) + i, lane, (last >> i & 1) != 0);
    }
  }
}

void Fleet::SetField(unsigned lane, ir::StateId state, uint8_t field, uint64_t value, uint32_t element) {
  const ir::Type type = ir::Info(program().states[state].kind).fields[field].type;
  const uint32_t bits = type == ir::Type::kBit ? 1 : 8 * ir::Bytes(type);
  const uint32_t first = FieldPlane(state, field, element);
  StopClock(state);
  for (uint32_t i = 0; i < bits; ++i) SetPlaneBit(first + i, lane, (value >> i & 1) != 0);
}

/// Calls visit(offset, bit, bit of the value) for each bit of a place in memory.
template <class Visit>
void Fleet::ForEachPart(const ir::Place& place, Visit&& visit) const {
  const sim::PlaceAccess access = sim::AccessTo(program(), place);
  if (access.kind == sim::AccessKind::kAbsent) return;
  if (access.kind == sim::AccessKind::kBit) return visit(access.offset, access.bit, 0u);
  for (uint32_t i = 0; i < access.bytes; ++i) {
    const uint32_t significance = access.big_endian ? access.bytes - 1 - i : i;
    for (uint8_t bit = 0; bit < 8; ++bit) visit(access.offset + i, bit, 8 * significance + bit);
  }
}

uint64_t Fleet::Read(unsigned lane, const ir::Place& place) const {
  if (place.is_field()) return Field(lane, place.state, place.field);
  uint64_t value = 0;
  ForEachPart(place, [&](uint32_t offset, uint8_t bit, uint32_t at) {
    value |= uint64_t{Bit(lane, place.space, offset, bit)} << at;
  });
  return value;
}

void Fleet::Write(unsigned lane, const ir::Place& place, uint64_t value) {
  if (place.is_field()) return SetField(lane, place.state, place.field, value);
  ForEachPart(place, [&](uint32_t offset, uint8_t bit, uint32_t at) {
    SetBit(lane, place.space, offset, bit, (value >> at & 1) != 0);
  });
}

void Fleet::ForceBit(unsigned lane, ir::SpaceId space, uint32_t offset, uint8_t bit, bool forced) {
  PLCXX_CHECK(forced_ != nullptr);
  if (!Holds(space, offset, bit)) return;
  const ByteHome& home = library_->layout.At(space.index, offset);
  if (home.is_scalar()) return;  // nothing that the host sees
  if (home.is_row()) {
    uint8_t& mask = forced_rows_[size_t{home.row} * lanes() + lane];
    mask = static_cast<uint8_t>(forced ? mask | (1u << bit) : mask & ~(1u << bit));
    return;
  }
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
  if (home.is_row() || home.is_scalar()) return {};
  return {PlaneAt(home.planes[bit]), lanes() / 64};
}

void Fleet::CopyRetentive(const uint64_t* mask, bool loads) {
  const unsigned words = lanes() / 64;
  LaneSet chosen(words);
  for (unsigned w = 0; w < words; ++w) chosen[w] = mask[w] & (loads ? has_stored_[w] : ~uint64_t{0});
  // As bytes of a row: all bits of a lane.
  std::vector<uint8_t> chosen_bytes(lanes());
  for (unsigned lane = 0; lane < lanes(); ++lane)
    chosen_bytes[lane] = static_cast<uint8_t>(0 - (chosen[lane / 64] >> (lane % 64) & 1));
  for (uint32_t s = 0; s < program().spaces.size(); ++s) {
    if (program().spaces[ir::SpaceId(s)].lifetime != ir::Lifetime::kRetentive) continue;
    for (const ByteHome& home : library_->layout.bytes[s]) {
      for (const uint32_t plane : home.planes) {
        for (unsigned w = 0; plane != kNowhere && w < words; ++w) {
          const size_t at = size_t{plane} * words + w;
          if (loads) {
            const uint64_t free = chosen[w] & ~(forced_ != nullptr ? forced_[at] : 0);
            words_[at] = Choose(free, stored_planes_[at], words_[at]);
          } else {
            stored_planes_[at] = Choose(chosen[w], words_[at], stored_planes_[at]);
          }
        }
      }
      if (!home.is_row()) continue;
      const size_t at = size_t{home.row} * lanes();
      const uint8_t* const forced = loads && forced_rows_ != nullptr ? forced_rows_ + at : nullptr;
      CopyRow(chosen_bytes, forced, loads ? &stored_rows_[at] : rows_ + at, loads ? rows_ + at : &stored_rows_[at]);
    }
  }
  for (unsigned w = 0; !loads && w < words; ++w) has_stored_[w] |= mask[w];
}

void Fleet::StoreRetentive() { CopyRetentive(AllLanes().data(), false); }

void Fleet::HostCalled(uint32_t function, const uint64_t* mask, const uint64_t* arguments, uint64_t* results,
                       uint64_t* seconds, uint64_t* has_second) {
  const ir::HostFunctionId id(function);
  if (answers_) answers_({id, lanes(), mask, arguments, results, seconds, has_second});
  if (id == program().schedule.retentive_load) CopyRetentive(mask, true);
  if (id == program().schedule.retentive_store) CopyRetentive(mask, false);
}

std::vector<uint8_t> Fleet::Snapshot(unsigned lane, const std::vector<std::vector<uint8_t>>& others) const {
  std::vector<uint8_t> bytes;
  for (uint32_t s = 0; s < program().spaces.size(); ++s) {
    if (!program().spaces[ir::SpaceId(s)].host_visible) continue;
    for (uint32_t offset = 0; offset < library_->layout.bytes[s].size(); ++offset) {
      const ByteHome& home = library_->layout.At(s, offset);
      uint8_t byte = home.is_row() ? RowAt(home.row)[lane] : others[s][offset];
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
