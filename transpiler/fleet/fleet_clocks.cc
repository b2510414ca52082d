// What the planes of a timer mean while its clock runs: runtime/clocks.h, runtime/unit_timers.h.

#include <algorithm>
#include <array>
#include <optional>

#include "transpiler/fleet/fleet.h"
#include "transpiler/ir/op.h"

namespace plcxx::fleet {
namespace {

using ir::StateKind;

/// The fields that a clock has in its keeping.
std::array<uint8_t, 2> ClockedFields(StateKind kind) {
  const char* const second = kind == StateKind::kUnitTimer ? "value" : "last_ms";
  return {ir::FieldIndex(kind, "elapsed_ms"), ir::FieldIndex(kind, second)};
}

}  // namespace

std::optional<uint64_t> Fleet::ByClock(unsigned lane, ir::StateId state, uint8_t field) const {
  const uint32_t at = library_->layout.clocks[state.index];
  if (at == kNowhere || clocks_[at].runs == 0) return std::nullopt;
  const Clock& clock = clocks_[at];
  const StateKind kind = program().states[state].kind;
  const std::array clocked = ClockedFields(kind);
  if (std::ranges::find(clocked, field) == clocked.end()) return std::nullopt;
  const auto planes_of = [&](const char* name) { return PlanesOfField(lane, state, ir::FieldIndex(kind, name), 0); };
  const auto time = static_cast<uint32_t>(planes_of("elapsed_ms"));
  if (kind == StateKind::kOnDelayTimer) {
    if (field == clocked[1]) return clock.last;
    return planes_of("input") != 0 ? clock.last - time : 0;
  }
  const bool counts =
      clock.counts_by_input != 0 ? planes_of("previous") != 0 && planes_of("output") == 0 : planes_of("running") != 0;
  const uint64_t elapsed = counts ? clock.last - time : time;
  if (field == clocked[0]) return elapsed;
  return std::min(elapsed, planes_of("preset") * clock.unit_ms) / clock.unit_ms;
}

void Fleet::StopClock(ir::StateId state) {
  const uint32_t at = library_->layout.clocks[state.index];
  if (at == kNowhere || clocks_[at].runs == 0) return;
  const auto [first, second] = ClockedFields(program().states[state].kind);
  for (unsigned lane = 0; lane < lanes(); ++lane) {
    const std::optional<uint64_t> value = ByClock(lane, state, first), other = ByClock(lane, state, second);
    SetPlanesOfField(lane, state, first, *value, 0);
    SetPlanesOfField(lane, state, second, *other, 0);
  }
  clocks_[at].runs = 0;
}

}  // namespace plcxx::fleet
