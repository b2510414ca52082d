// Host calls as functions of what the host has been told.
#include <string>

#include "transpiler/prove/execute/execute.h"

namespace plcxx::prove {
namespace {

TermId Named(Terms& terms, std::string_view what, std::string_view function, uint8_t width,
             std::span<const TermId> arguments) {
  return terms.Apply(terms.Function(std::string(what) + " " + std::string(function), width), arguments);
}

}  // namespace

TermId CallsAfter(Terms& terms, std::string_view function, TermId calls, std::span<const TermId> arguments) {
  std::vector<TermId> all{calls};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return Named(terms, "told", function, 64, all);
}

TermId AnswerOf(Terms& terms, std::string_view function, TermId calls, uint8_t width) {
  return Named(terms, "answer of", function, width, {&calls, 1});
}

TermId GivesSecond(Terms& terms, std::string_view function, TermId calls) {
  return Named(terms, "has second answer of", function, 1, {&calls, 1});
}

TermId SecondAnswerOf(Terms& terms, std::string_view function, TermId calls, uint8_t width) {
  return Named(terms, "second answer of", function, width, {&calls, 1});
}

TermId ByteFromHost(Terms& terms, std::string_view function, TermId calls, std::string_view space, uint32_t offset) {
  return Named(terms, std::string(space) + "." + std::to_string(offset) + " by", function, 8, {&calls, 1});
}

TermId HasCopy(Terms& terms, std::string_view function, TermId calls) {
  return Named(terms, "copy of", function, 1, {&calls, 1});
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
      if (!space.host_visible) return false;
      for (const ir::Zone& zone : space.zones) {
        if (zone.begin <= offset && offset < zone.end) return zone.direction == ir::Direction::kInput;
      }
      // What is in no zone is the program's own: people may look at it, the control does not write it.
      return false;
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::prove
