#include "transpiler/dialects/host50/lowering/section_writer.h"

#include "transpiler/dialects/host50/lowering/jumps.h"
#include "transpiler/dialects/host50/lowering/network_writer.h"
#include "transpiler/dialects/host50/lowering/routines.h"
#include "transpiler/dialects/host50/lowering/slices.h"
#include "transpiler/dialects/host50/lowering/statement_writer.h"

namespace plcxx::host50 {

SectionWriter::SectionWriter(const Context& context, Routines& routines, Jumps& jumps, StatementWriter& statements,
                             NetworkWriter& networks, Slices& slices)
    : Context(context),
      routines_(routines),
      jumps_(jumps),
      statements_(statements),
      networks_(networks),
      slices_(slices) {}

void SectionWriter::End() {
  statements_.AddComments(tree_.sections[now_.section].end_comments);
  if (statements_.has_comments()) {
    // A statement without code carries what nothing else follows.
    statements_.Add(statements_.TakeLastComment(), {});
  }
  builder_.SetRange({});
  if (now_.end_is_used) builder_.Label(now_.end_label);
}

void SectionWriter::LowerWhole(const Section& section) {
  if (jumps_.HasWayBack(now_.section)) {
    // A subroutine's count is its own in each call, so it is no local that it would share with its caller.
    jumps_.Count(section.kind == SectionKind::kSlow ? ir::Lifetime::kRoutine : ir::Lifetime::kVolatile);
    jumps_.AllowAll();
  }
  for (uint32_t i = 0; i < section.networks.count; ++i) {
    networks_.Begin(NetworkId(section.networks.first + i));
    networks_.Lower(NetworkId(section.networks.first + i));
  }
}

void SectionWriter::Lower(SectionId id, ir::RegionId body) {
  const Section& section = tree_.sections[id];
  now_ = {.section = id,
          .network = {},
          .jumps_left = {},
          .end_label = tree_.networks.size() + id.index,
          .period_ms = section.kind == SectionKind::kFast ? 1 : settings_.slowdiv};
  builder_.SetRegion(body);
  builder_.SetRange({});
  statements_.AddComments(section.comments);
  if (section.kind == SectionKind::kSlow && settings_.slices == SlicesOption::kSliced) {
    slices_.Lower(section);
  } else {
    LowerWhole(section);
  }
  End();
}

void SectionWriter::LowerAll() {
  for (uint32_t i = 0; i < tree_.sections.size(); ++i) {
    const ir::RoutineId routine = routines_.Of(SectionId(i));
    if (routine.valid()) Lower(SectionId(i), program_.routines[routine].body);
  }
}

}  // namespace plcxx::host50
