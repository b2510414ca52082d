// Checks of writes: the same bit or word written more than once.

#include <algorithm>
#include <optional>

#include "transpiler/checks/checks.h"

namespace plcxx::checks {
namespace {

/// Calls visit(bit) for each bit that the access covers; an operation on an instance covers all its fields.
template <class Visit>
void ForBits(const Context& context, const BitNumbering& numbering, const Access& access, Visit&& visit) {
  if (access.place.valid()) {
    const BitSpan span = numbering.Of(context.program.places[access.place]);
    for (uint32_t bit = span.first; bit < span.last; ++bit) visit(bit);
  } else if (access.state.valid()) {
    ir::Place place;
    place.state = access.state;
    const auto fields = ir::Info(context.program.states[access.state].kind).fields;
    const auto count = static_cast<uint8_t>(fields.size());
    for (place.field = 0; place.field < count; ++place.field) visit(numbering.Of(place).first);
  }
}

/// What the control's own routines keep for themselves is no coil of the program.
bool IsProgramPlace(const Context& context, const Access& access) {
  const ir::Place& place = context.program.places[access.place];
  return !place.indexed && (place.is_field() || context.program.spaces[place.space].host_visible);
}

}  // namespace

void WrittenInBothParts(const Context& context, const diag::Message<diag::Text>& message) {
  const BitNumbering numbering(context.program);
  struct Writer {
    const Access* access = nullptr;  // the first of all parts
    uint32_t part = 0;
  };
  ByBit<Writer> writers(numbering);
  for (uint32_t p = 0; p < context.parts.size(); ++p) {
    ByBit<bool> reported(numbering);
    for (const Access& access : context.parts[p].accesses) {
      if (access.kind != AccessKind::kWrite || !IsProgramPlace(context, access)) continue;
      const Access* other = nullptr;
      bool known = false;
      ForBits(context, numbering, access, [&](uint32_t bit) {
        Writer& writer = writers[bit];
        if (writer.access == nullptr) {
          writer = {&access, p};
        } else if (writer.part != p) {
          known |= reported[bit];
          reported[bit] = true;
          if (other == nullptr) other = writer.access;
        }
      });
      if (other == nullptr || known) continue;
      context.diagnostics.Report(access.range, message, context.program.places[access.place].name)
          .notes.push_back({other->range, "the other part writes it here"});
    }
  }
}

void DoubleCoil(const Context& context, const diag::Message<diag::Text>& message) {
  const BitNumbering numbering(context.program);
  for (const PartAccesses& part : context.parts) {
    ByBit<const Access*> last(numbering);  // unconditional write that nothing has read yet
    for (const Access& access : part.accesses) {
      if (access.kind == AccessKind::kRead || access.kind == AccessKind::kDrive || access.kind == AccessKind::kTouch) {
        ForBits(context, numbering, access, [&](uint32_t bit) { last[bit] = nullptr; });
      }
      if (access.kind != AccessKind::kWrite || access.arm != 0 || !IsProgramPlace(context, access)) continue;
      const Access* other = nullptr;
      ForBits(context, numbering, access, [&](uint32_t bit) {
        if (other == nullptr) other = last[bit];
        last[bit] = &access;
      });
      if (other == nullptr) continue;
      context.diagnostics.Report(access.range, message, context.program.places[access.place].name)
          .notes.push_back({other->range, "written here already, and nothing reads it in between"});
    }
  }
}

void DeadStore(const Context& context, const diag::Message<diag::Text>& message) {
  const BitNumbering numbering(context.program);
  for (const PartAccesses& part : context.parts) {
    ByBit<std::vector<uint32_t>> pending(numbering);      // writes that nothing has read yet
    std::vector<uint32_t> lost(part.accesses.size(), 0);  // by access: bits overwritten unread
    for (uint32_t i = 0; i < part.accesses.size(); ++i) {
      const Access& access = part.accesses[i];
      if (access.kind == AccessKind::kLoopEnd) {
        pending.ForTouched([](std::vector<uint32_t>& writes) { writes.clear(); });
      } else if (access.kind != AccessKind::kWrite) {
        ForBits(context, numbering, access, [&](uint32_t bit) { pending[bit].clear(); });
      } else if (IsProgramPlace(context, access)) {
        std::vector<uint32_t> dead;
        ForBits(context, numbering, access, [&](uint32_t bit) {
          auto& writes = pending[bit];
          std::erase_if(writes, [&](uint32_t earlier) {
            const Access& other = part.accesses[earlier];
            if (!part.Encloses(access.arm, other.arm)) return false;
            const BitSpan span = numbering.Of(context.program.places[other.place]);
            if (++lost[earlier] == span.last - span.first) dead.push_back(earlier);
            return true;
          });
          // Writes of many exclusive arms need not all be remembered.
          if (writes.size() < 16) writes.push_back(i);
        });
        for (const uint32_t earlier : dead) {
          const Access& other = part.accesses[earlier];
          context.diagnostics.Report(other.range, message, context.program.places[other.place].name)
              .notes.push_back({access.range, "overwritten here before anything reads it"});
        }
      }
    }
  }
}

}  // namespace plcxx::checks
