// Host calls as functions of what the host has been told.
#include <string>

#include "transpiler/ir/zones.h"
#include "transpiler/symbolic/execute/host_writes.h"

namespace plcxx::execute {
namespace {

constexpr uint8_t kAllBits = 0xFF;

terms::TermId Named(terms::Terms& terms, std::string_view what, std::string_view function, uint8_t width,
                    std::span<const terms::TermId> arguments) {
  return terms.Apply(terms.Function(std::string(what) + " " + std::string(function), width), arguments);
}

}  // namespace

terms::TermId CallsAfter(terms::Terms& terms, std::string_view function, terms::TermId calls,
                         std::span<const terms::TermId> arguments) {
  std::vector<terms::TermId> all{calls};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return Named(terms, "told", function, 64, all);
}

terms::TermId AnswerOf(terms::Terms& terms, std::string_view function, terms::TermId calls, uint8_t width) {
  return Named(terms, "answer of", function, width, {&calls, 1});
}

terms::TermId GivesSecond(terms::Terms& terms, std::string_view function, terms::TermId calls) {
  return Named(terms, "has second answer of", function, 1, {&calls, 1});
}

terms::TermId SecondAnswerOf(terms::Terms& terms, std::string_view function, terms::TermId calls, uint8_t width) {
  return Named(terms, "second answer of", function, width, {&calls, 1});
}

terms::TermId ByteFromHost(terms::Terms& terms, std::string_view function, terms::TermId calls, std::string_view space,
                           uint32_t offset) {
  return Named(terms, std::string(space) + "." + std::to_string(offset) + " by", function, 8, {&calls, 1});
}

terms::TermId BitsWrittenByHost(terms::Terms& terms, std::string_view function, terms::TermId calls,
                                std::string_view space, uint32_t offset) {
  return Named(terms, "bits of " + std::string(space) + "." + std::to_string(offset) + " written by", function, 8,
               {&calls, 1});
}

terms::TermId HasCopy(terms::Terms& terms, std::string_view function, terms::TermId calls) {
  return Named(terms, "copy of", function, 1, {&calls, 1});
}

bool HostSees(ir::HostAccess access, const ir::Space& space) {
  switch (access) {
    case ir::HostAccess::kNone:
    case ir::HostAccess::kWritesRetentive:
      return false;
    case ir::HostAccess::kReadsState:
    case ir::HostAccess::kWritesState:
      return space.host_visible;
    case ir::HostAccess::kReadsRetentive:
      return space.lifetime == ir::Lifetime::kRetentive;
  }
  PLCXX_UNREACHABLE();
}

uint8_t BitsHostWrites(const ir::Program& program, ir::HostAccess access, ir::SpaceId id, uint32_t offset) {
  const ir::Space& space = program.spaces[id];
  switch (access) {
    case ir::HostAccess::kNone:
    case ir::HostAccess::kReadsState:
    case ir::HostAccess::kReadsRetentive:
      return 0;
    case ir::HostAccess::kWritesRetentive:
      return space.lifetime == ir::Lifetime::kRetentive ? kAllBits : uint8_t{0};
    case ir::HostAccess::kWritesState: {
      const ControlBits bits = BitsControlWrites(space, offset);
      return static_cast<uint8_t>(bits.values | bits.clears);
    }
  }
  PLCXX_UNREACHABLE();
}

uint8_t BitsMayWrite(const ir::Program& program, const ir::HostFunction& host, ir::SpaceId id, uint32_t offset) {
  if (host.only_space.valid() && host.only_space != id) return 0;
  const uint8_t written = BitsHostWrites(program, host.access, id, offset);
  if (written == 0 || host.routine_exchange || host.access != ir::HostAccess::kWritesState) return written;
  return static_cast<uint8_t>(written & ~ir::BitsOf(program.spaces[id], offset, ir::Direction::kInput));
}

ControlBits BitsControlWrites(const ir::Space& space, uint32_t offset) {
  // What is in no zone is the program's own: people may look at it, the control does not write it.
  ControlBits bits;
  if (!space.host_visible) return bits;
  uint8_t earlier = 0;  // bits that a zone has said whose they are
  for (const ir::Zone& zone : space.zones) {
    const uint8_t own = ir::BitsOfZone(zone, offset);
    switch (zone.direction) {
      case ir::Direction::kInput:
        bits.values = static_cast<uint8_t>(bits.values | own);
        break;
      case ir::Direction::kInternal:
        bits.clears = static_cast<uint8_t>(bits.clears | (own & earlier));
        break;
      case ir::Direction::kOutput:
        break;
    }
    earlier = static_cast<uint8_t>(earlier | own);
  }
  bits.clears = static_cast<uint8_t>(bits.clears & ~bits.values);
  return bits;
}

ControlWrite WhatControlWrites(const ir::Space& space, uint32_t offset, uint8_t bit) {
  const ControlBits bits = BitsControlWrites(space, offset);
  if ((bits.values >> bit & 1) != 0) return ControlWrite::kValues;
  return (bits.clears >> bit & 1) != 0 ? ControlWrite::kClears : ControlWrite::kNothing;
}

}  // namespace plcxx::execute
