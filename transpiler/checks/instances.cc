// Checks of state instances: who drives them, who reads them.

#include "transpiler/checks/checks.h"

namespace plcxx::checks {
namespace {

std::string_view NameOf(const Context& context, ir::StateId state) { return context.program.states[state].name; }

}  // namespace

void DrivenInBothParts(const Context& context, const diag::Message<diag::Text>& message) {
  // By instance: the first place that drives it, and in which part.
  std::vector<const Access*> first(context.program.states.size(), nullptr);
  std::vector<const PartAccesses*> part(context.program.states.size(), nullptr);
  for (const PartAccesses& here : context.parts) {
    std::vector<bool> reported(context.program.states.size(), false);
    for (const Access& access : here.accesses) {
      if (access.kind != AccessKind::kDrive) continue;
      const uint32_t i = access.state.index;
      if (first[i] == nullptr) {
        first[i] = &access;
        part[i] = &here;
      } else if (part[i] != &here && !reported[i]) {
        reported[i] = true;
        context.diagnostics.Report(access.range, message, NameOf(context, access.state))
            .notes.push_back({first[i]->range, "the other part drives it here"});
      }
    }
  }
}

void DrivenTwice(const Context& context, const diag::Message<diag::Text>& message) {
  for (const PartAccesses& part : context.parts) {
    std::vector<std::vector<const Access*>> drives(context.program.states.size());
    for (const Access& access : part.accesses) {
      if (access.kind != AccessKind::kDrive) continue;
      auto& earlier = drives[access.state.index];
      for (const Access* other : earlier) {
        if (part.Exclusive(access.arm, other->arm)) continue;
        context.diagnostics.Report(access.range, message, NameOf(context, access.state))
            .notes.push_back({other->range, "driven here already"});
        break;
      }
      // Each further statement is compared with a few: a generated program may drive one instance very often.
      if (earlier.size() < 16) earlier.push_back(&access);
    }
  }
}

void ReadNeverDriven(const Context& context, const diag::Message<diag::Text>& message) {
  const ir::Program& program = context.program;
  std::vector<bool> driven(program.states.size(), false);
  const BitNumbering numbering(program);
  ByBit<bool> written(numbering);
  for (const PartAccesses& part : context.parts) {
    for (const Access& access : part.accesses) {
      if (access.kind == AccessKind::kDrive) driven[access.state.index] = true;
      if (access.kind == AccessKind::kWrite && access.state.valid())
        written[numbering.Of(program.places[access.place]).first] = true;
    }
  }
  for (const PartAccesses& part : context.parts) {
    for (const Access& access : part.accesses) {
      if (access.kind != AccessKind::kRead || !access.state.valid() || driven[access.state.index]) continue;
      if (written[numbering.Of(program.places[access.place]).first]) continue;
      driven[access.state.index] = true;  // once for each instance
      context.diagnostics.Report(access.range, message, NameOf(context, access.state));
    }
  }
}

void SlicedCarryRead(const Context& context, const diag::Message<diag::Text>& message) {
  const ir::Program& program = context.program;
  std::vector<bool> fast(program.states.size(), false);
  for (const PartAccesses& part : context.parts) {
    if (part.part != ir::RoutineKind::kFast) continue;
    for (const Access& access : part.accesses) {
      if (access.kind == AccessKind::kDrive) fast[access.state.index] = true;
    }
  }
  for (const PartAccesses& part : context.parts) {
    if (part.part != ir::RoutineKind::kSlow || part.slices <= 1) continue;
    for (const Access& access : part.accesses) {
      if (access.kind != AccessKind::kRead || !access.state.valid() || !fast[access.state.index]) continue;
      const ir::Place& place = program.places[access.place];
      const ir::StateKind kind = program.states[place.state].kind;
      if (kind != ir::StateKind::kRingCounter || place.field != ir::FieldIndex(kind, "carry")) continue;
      context.diagnostics.Report(access.range, message, place.name);
    }
  }
}

}  // namespace plcxx::checks
