#include "transpiler/fleet/layout.h"

namespace plcxx::fleet {
namespace {

/// What the program names of a byte.
struct Use {
  bool indexed = false;
  uint8_t bits = 0;
};

std::vector<std::vector<Use>> FindUses(const ir::Program& program) {
  std::vector<std::vector<Use>> uses;
  for (const ir::Space& space : program.spaces) uses.emplace_back(space.bytes);
  for (const ir::Place& place : program.places) {
    const sim::PlaceAccess access = sim::AccessTo(program, place);
    if (access.kind == sim::AccessKind::kAbsent || access.kind == sim::AccessKind::kField) continue;
    std::vector<Use>& bytes = uses[access.owner];
    if (access.indexed) {
      for (uint32_t at = access.low; at < access.high; ++at) bytes[at].indexed = true;
      continue;
    }
    const bool is_bit = access.kind == sim::AccessKind::kBit;
    for (uint32_t i = 0; i < access.bytes; ++i) {
      Use& use = bytes[access.offset + i];
      use.bits = static_cast<uint8_t>(use.bits | (is_bit ? 1u << access.bit : 0xFFu));
    }
  }
  return uses;
}

}  // namespace

Layout LayOut(const ir::Program& program, const SameEverywhere& same) {
  Layout layout;
  for (const std::vector<Use>& uses : FindUses(program)) {
    const auto space = static_cast<uint32_t>(layout.bytes.size());
    std::vector<ByteHome>& homes = layout.bytes.emplace_back(uses.size());
    for (size_t at = 0; at < uses.size(); ++at) {
      if (uses[at].indexed) {
        homes[at].row = layout.rows++;
        continue;
      }
      if (uses[at].bits != 0 && same.Byte(space, static_cast<uint32_t>(at))) {
        homes[at].scalar = layout.scalars++;
        continue;
      }
      for (uint8_t bit = 0; bit < 8; ++bit) {
        if ((uses[at].bits >> bit & 1) != 0) homes[at].planes[bit] = layout.planes++;
      }
    }
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
