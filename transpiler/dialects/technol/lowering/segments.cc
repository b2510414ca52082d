#include "transpiler/dialects/technol/lowering/segments.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/technol/lowering/locals.h"
#include "transpiler/dialects/technol/lowering/mechanism_places.h"

namespace plcxx::technol {

using ir::Type;
using ir::ValueId;

void Segments::Begin() {
  segments_.clear();
  loop_ = {};
  if (frame_.routine->segments_are_cases) {
    BeginCases();
  } else {
    BeginLabels();
  }
}

/// Entries are labels, which a `switch` in front of the instructions goes to.
void Segments::BeginLabels() {
  const Routine& routine = *frame_.routine;
  const ValueId selector = ChosenEntry();
  if (!selector.valid()) {
    // Its only entry may be below code that it jumps back to.
    const bool begins_below =
        routine.subprograms.size() == 1 && flow_.EntryOf(routine.subprograms.front()) != routine.instructions.front();
    if (begins_below) builder_.Jump(flow_.EntryOf(routine.subprograms.front()).index + 1);
    return;
  }
  ir::Switch choice;
  const auto choose = [&](uint64_t value, InstructionId at) {
    builder_.AddArm(choice, {value}, [&] { builder_.Jump(at.index + 1); });
  };
  for (size_t i = 0; i < routine.entries.size(); ++i) choose(i + 1, routine.entries[i]);
  for (size_t i = 0; routine.entry.valid() && i < routine.subprograms.size(); ++i) {
    const InstructionId entry = flow_.EntryOf(routine.subprograms[i]);
    if (entry != routine.instructions.front()) choose(i, entry);
  }
  choice.cases.push_back({.values = {}, .region = builder_.NewRegion()});
  builder_.SwitchOn(selector, std::move(choice));
}

ValueId Segments::ChosenEntry() {
  const Routine& routine = *frame_.routine;
  if (routine.entry.valid()) return builder_.Load(routine.entry);
  if (routine.entries.empty()) return {};
  registers_.Spill();
  if (!routine.goes_back) return builder_.Load(mechanisms_.Step(routine.unit));
  // The step itself stays until a wait: a mechanism that the guard leaves keeps the one with which it came (6.4).
  chosen_ = locals_.AddOwn("step", Type::kI16);
  builder_.Store(chosen_, builder_.Load(mechanisms_.Step(routine.unit)));
  const ir::RegionId iteration = builder_.NewRegion();
  loop_ = builder_.LoopWith(
      {.kind = ir::LoopBound::kBudget, .budget = locals_("rounds_left", Type::kI32), .body = iteration});
  builder_.SetRegion(iteration);
  return builder_.Load(chosen_);
}

/// The first segment is the default: step 0.
void Segments::BeginCases() {
  const Routine& routine = *frame_.routine;
  const ir::RegionId around = builder_.region();
  const ValueId step = ChosenEntry();
  ir::Switch choice;
  const std::vector<InstructionId>& entries = routine.entries;
  AddCase(choice, {}, routine.instructions.front(), entries.front());
  for (size_t i = 0; i + 1 < entries.size(); ++i) AddCase(choice, {i + 1}, entries[i], entries[i + 1]);
  AddCase(choice, {entries.size()}, entries.back(), entries.back());
  choice.cases.back().falls_through = false;
  builder_.SwitchOn(step, std::move(choice));
  if (routine.tail) segments_[*routine.tail].region = routine.tail_goes_back ? builder_.region() : around;
  registers_.Forget();
}

/// Runs on into the next case where an instruction of it goes on, or jumps, to `end`.
void Segments::AddCase(ir::Switch& choice, std::vector<uint64_t> values, InstructionId first, InstructionId end) {
  const ir::RegionId region = builder_.NewRegion();
  segments_[first].region = region;
  bool runs_on = false, jumps_on = false;
  const std::vector<InstructionId>& all = frame_.routine->instructions;
  for (auto at = std::ranges::lower_bound(all, first); at != all.end() && *at < end; ++at) {
    flow_.ForEachSuccessor(*at, [&](InstructionId to, Edge edge) {
      runs_on |= to == end && edge == Edge::kOn;
      jumps_on |= to == end && edge == Edge::kJump;
    });
  }
  segments_[end].is_jumped_to |= jumps_on;
  choice.cases.push_back({.values = std::move(values), .region = region, .falls_through = runs_on || jumps_on});
}

/// A label that begins a segment also ends the one before it, for the jumps in that.
void Segments::Enter(InstructionId id) {
  const auto found = segments_.find(id);
  if (found == segments_.end()) return;
  registers_.Spill();
  if (found->second.is_jumped_to) builder_.Label(EndBefore(id));
  builder_.SetRegion(found->second.region);
  registers_.Forget();
}

void Segments::JumpToEntry(size_t step, ValueId condition, ir::RegionId refused) {
  const auto go = [&] {
    builder_.Store(chosen_, builder_.Constant(step, 16));
    builder_.Repeat(loop_, {}, refused);
  };
  if (!condition.valid()) return go();
  const ir::RegionId taken = builder_.NewRegion();
  program_[builder_.If(condition, taken)].payload = static_cast<uint32_t>(ir::IfOrigin::kJumps);
  builder_.Into(taken, go);
}

}  // namespace plcxx::technol
