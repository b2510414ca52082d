#include "transpiler/fleet/layout.h"

namespace plcxx::fleet {
namespace {

/// By space and offset: which bits of a byte the program names.
std::vector<std::vector<uint8_t>> FindUses(const ir::Program& program) {
  std::vector<std::vector<uint8_t>> uses;
  for (const ir::Space& space : program.spaces) uses.emplace_back(space.bytes);
  for (const ir::Place& place : program.places) {
    const sim::PlaceAccess access = sim::AccessTo(program, place);
    if (access.kind == sim::AccessKind::kAbsent || access.kind == sim::AccessKind::kField) continue;
    std::vector<uint8_t>& bytes = uses[access.owner];
    if (access.indexed) {
      for (uint32_t at = access.low; at < access.high; ++at) bytes[at] = 0xFF;
      continue;
    }
    const bool is_bit = access.kind == sim::AccessKind::kBit;
    for (uint32_t i = 0; i < access.bytes; ++i) {
      uint8_t& bits = bytes[access.offset + i];
      bits = static_cast<uint8_t>(bits | (is_bit ? 1u << access.bit : 0xFFu));
    }
  }
  return uses;
}

void PlaceBytes(Layout& layout, const std::vector<uint8_t>& uses, uint32_t space, const SameEverywhere& same) {
  for (uint32_t at = 0; at < uses.size(); ++at) {
    ByteHome& home = layout.bytes[space][at];
    if (uses[at] != 0 && same.Byte(space, at)) {
      home.scalar = layout.scalars++;
      continue;
    }
    for (uint8_t bit = 0; bit < 8; ++bit) {
      if ((uses[at] >> bit & 1) != 0) home.planes[bit] = layout.planes++;
    }
  }
}

}  // namespace

Layout LayOut(const ir::Program& program, const SameEverywhere& same) {
  Layout layout;
  const std::vector<std::vector<uint8_t>> uses = FindUses(program);
  for (const std::vector<uint8_t>& bytes : uses) layout.bytes.emplace_back(bytes.size());
  for (const bool retentive : {true, false}) {
    for (uint32_t space = 0; space < uses.size(); ++space) {
      if ((program.spaces[ir::SpaceId(space)].lifetime == ir::Lifetime::kRetentive) == retentive)
        PlaceBytes(layout, uses[space], space, same);
    }
    if (retentive) layout.retentive_planes = layout.planes;
  }
  for (uint32_t s = 0; s < program.states.size(); ++s) {
    const ir::StateInstance& state = program.states[ir::StateId(s)];
    layout.clocks.push_back(same.HasClock(ir::StateId(s)) ? layout.clock_count++ : kNowhere);
    std::vector<uint32_t>& fields = layout.fields.emplace_back();
    for (const ir::FieldInfo& field : ir::Info(state.kind).fields) {
      fields.push_back(layout.planes);
      layout.planes += (field.type == ir::Type::kBit ? 1 : 8 * ir::Bytes(field.type)) * field.count;
    }
  }
  return layout;
}

}  // namespace plcxx::fleet
