#include "transpiler/fleet/lane.h"

#include "transpiler/sim/place_access.h"
#include "transpiler/support/check.h"

namespace plcxx::fleet {

HostOnlyBytes FindHostOnly(const ir::Program& program) {
  std::vector<std::vector<bool>> is_host_only;
  for (const ir::Space& space : program.spaces) {
    is_host_only.emplace_back(space.bytes, space.host_visible && space.lifetime == ir::Lifetime::kVolatile);
  }
  const auto is_written = [&](ir::PlaceId id) {
    if (!id.valid()) return;
    const ir::Place& place = program.places[id];
    if (place.is_field() || !place.space.valid()) return;
    const uint32_t begin = place.indexed ? place.low : place.offset;
    const uint32_t end = place.indexed ? place.high : place.offset + ir::Bytes(place.type);
    std::vector<bool>& bytes = is_host_only[place.space.index];
    for (uint32_t i = begin; i < end && i < bytes.size(); ++i) bytes[i] = false;
  };
  for (const ir::Inst& inst : program.insts) {
    if (inst.op == ir::OpKind::kStore) is_written(ir::PlaceId(inst.payload));
  }
  for (const ir::Call& call : program.calls) is_written(call.out);
  HostOnlyBytes ends;
  for (const std::vector<bool>& bytes : is_host_only) {
    std::vector<uint32_t>& of_space = ends.emplace_back(bytes.size());
    for (auto i = static_cast<uint32_t>(bytes.size()); i-- > 0;) {
      const bool goes_on = i + 1 < bytes.size() && bytes[i + 1];
      of_space[i] = !bytes[i] ? i : goes_on ? of_space[i + 1] : i + 1;
    }
  }
  return ends;
}

void Lane::PowerOn() {
  const ir::Program& program = fleet_.program();
  for (uint32_t i = 0; i < kept_.size(); ++i) {
    const ir::Space& space = program.spaces[ir::SpaceId(i)];
    if (!space.host_visible) continue;
    kept_[i].assign(space.bytes, 0);
    for (const ir::InitialByte& initial : space.initial) {
      if (initial.offset < space.bytes) kept_[i][initial.offset] = initial.value;
    }
  }
}

std::span<const uint8_t> Lane::MemoryFrom(ir::SpaceId space, uint32_t offset) const {
  const std::vector<uint8_t>& bytes = kept_[space.index];
  if (offset >= bytes.size()) return {};
  return std::span(bytes).subspan(offset, host_only_[space.index][offset] - offset);
}

uint64_t Lane::Read(const ir::Place& place) {
  uint64_t value = fleet_.Read(lane_, place);
  if (place.is_field() || !place.space.valid() || kept_[place.space.index].empty()) return value;
  sim::ForEachBitOf(fleet_.program(), place, [&](ir::SpaceId space, uint32_t offset, uint8_t bit, uint32_t at) {
    if (fleet_.Holds(space, offset, bit)) return;
    value |= uint64_t{kept_[space.index][offset] >> bit & 1U} << at;
  });
  return value;
}

void Lane::Write(const ir::Place& place, uint64_t value) {
  fleet_.Write(lane_, place, value);
  if (place.is_field() || !place.space.valid() || kept_[place.space.index].empty()) return;
  sim::ForEachBitOf(fleet_.program(), place, [&](ir::SpaceId space, uint32_t offset, uint8_t bit, uint32_t at) {
    uint8_t& byte = kept_[space.index][offset];
    const auto mask = static_cast<uint8_t>(1U << bit);
    byte = static_cast<uint8_t>((value >> at & 1) != 0 ? byte | mask : byte & ~mask);
  });
}

void Lane::RunPeriod(uint32_t) { PLCXX_UNREACHABLE(); }
void Lane::RunFastOnly(uint32_t) { PLCXX_UNREACHABLE(); }
void Lane::RunElapse(uint32_t) { PLCXX_UNREACHABLE(); }
void Lane::Force(const ir::Place&, uint64_t) { PLCXX_UNREACHABLE(); }
void Lane::Release(const ir::Place&) { PLCXX_UNREACHABLE(); }
void Lane::EnableStatement(ir::StatementId, bool) { PLCXX_UNREACHABLE(); }
std::vector<uint8_t> Lane::Snapshot() { PLCXX_UNREACHABLE(); }

}  // namespace plcxx::fleet
