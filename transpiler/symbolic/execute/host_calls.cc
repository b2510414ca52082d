// Host calls as functions of what the host has been told.
#include <algorithm>
#include <string>

#include "transpiler/symbolic/execute/host_writes.h"

namespace plcxx::execute {
namespace {

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

bool HostWrites(const ir::Program& program, ir::HostAccess access, ir::SpaceId id, uint32_t offset) {
  const ir::Space& space = program.spaces[id];
  switch (access) {
    case ir::HostAccess::kNone:
    case ir::HostAccess::kReadsState:
    case ir::HostAccess::kReadsRetentive:
      return false;
    case ir::HostAccess::kWritesRetentive:
      return space.lifetime == ir::Lifetime::kRetentive;
    case ir::HostAccess::kWritesState:
      return WhatControlWrites(space, offset) != ControlWrite::kNothing;
  }
  PLCXX_UNREACHABLE();
}

bool MayWrite(const ir::Program& program, const ir::HostFunction& host, ir::SpaceId id, uint32_t offset) {
  if (!HostWrites(program, host.access, id, offset)) return false;
  if (host.routine_exchange || host.access != ir::HostAccess::kWritesState) return true;
  const ir::Space& space = program.spaces[id];
  const auto first = std::ranges::find_if(
      space.zones, [offset](const ir::Zone& zone) { return zone.begin <= offset && offset < zone.end; });
  return first->direction != ir::Direction::kInput;
}

ControlWrite WhatControlWrites(const ir::Space& space, uint32_t offset) {
  // What is in no zone is the program's own: people may look at it, the control does not write it.
  ControlWrite write = ControlWrite::kNothing;
  bool is_first = true;
  if (!space.host_visible) return write;
  for (const ir::Zone& zone : space.zones) {
    if (offset < zone.begin || offset >= zone.end) continue;
    if (zone.direction == ir::Direction::kInput) return ControlWrite::kValues;
    if (!is_first && zone.direction == ir::Direction::kInternal) write = ControlWrite::kClears;
    is_first = false;
  }
  return write;
}

}  // namespace plcxx::execute
