// Values that are read before they are loaded, on some path (specification 6.7, 6.9).

#include <string>

#include "transpiler/dialects/technol/analysis/flow_checks.h"
#include "transpiler/dialects/technol/parser/parser.h"

namespace plcxx::technol {
namespace {

/// What holds nothing usable at a point, by reason.
struct Missing {
  Resources since_entry = 0;  // of a module or mechanism
  Resources since_wait = 0;
  Resources undefined = 0;  // flags

  bool Join(const Missing& other) {
    const Missing before = *this;
    since_entry |= other.since_entry;
    since_wait |= other.since_wait;
    undefined |= other.undefined;
    return since_entry != before.since_entry || since_wait != before.since_wait || undefined != before.undefined;
  }
};
constexpr Missing kAtEntry = {.since_entry = kAllResources & ~kFlags, .since_wait = 0, .undefined = kFlags};
constexpr Missing kAtResume = {.since_entry = 0, .since_wait = kAllResources, .undefined = 0};

/// What a stretch of a path does to it.
struct Change {
  Resources sets = 0;       // written, or left undefined
  Resources undefines = 0;  // of these

  Change Then(const Change& next) const {
    return {.sets = sets | next.sets, .undefines = (undefines & ~next.sets) | next.undefines};
  }
  bool Join(const Change& other) {
    const Change before = *this;
    sets &= other.sets;
    undefines |= other.undefines;
    return sets != before.sets || undefines != before.undefines;
  }
  Missing Of(const Missing& before) const {
    return {.since_entry = before.since_entry & ~sets,
            .since_wait = before.since_wait & ~sets,
            .undefined = (before.undefined & ~sets) | undefines};
  }
};

class LoadChecker {
 public:
  LoadChecker(const Flow& flow, diag::Engine& diagnostics)
      : flow_(flow), program_(flow.program()), diagnostics_(diagnostics) {}

  void Run();

 private:
  Effects EffectsAt(InstructionId id) const {
    const uint32_t width = flow_.WidthBefore(id);
    return EffectsOf(program_, program_.instructions[id], width == 0 ? 16 : width);
  }
  Change ChangeAt(InstructionId id) const;
  void Summarize(uint32_t subprogram);
  void Check(InstructionId entry, const Missing& initial);
  void Look(InstructionId id, const Missing& missing);
  InstructionId WaitBefore(InstructionId id) const;

  const Flow& flow_;
  const Program& program_;
  diag::Engine& diagnostics_;
  States<Change> changes_{program_};
  States<Missing> missing_{program_};
  std::vector<Change> summaries_;                 // of subprograms
  std::vector<std::optional<Missing>> at_entry_;  // of subprograms: over all calls
  std::vector<bool> reported_;                    // by instruction
};

/// One part of DR that is set counts as DR.
Change LoadChecker::ChangeAt(InstructionId id) const {
  const Instruction& instruction = program_.instructions[id];
  if (instruction.op == Op::kCall) {
    if (const auto callee = flow_.CalleeOf(instruction)) return summaries_[*callee];
  }
  const Effects effects = EffectsAt(id);
  Resources sets = effects.writes | effects.undefines;
  if ((sets & PartsOfDr(32)) != 0) sets |= PartsOfDr(32);
  return {.sets = sets, .undefines = effects.undefines};
}

void LoadChecker::Summarize(uint32_t subprogram) {
  Spread(
      flow_, flow_.EntryOf(subprogram), Change{}, changes_,
      [&](InstructionId id, const Change& before, Edge) { return before.Then(ChangeAt(id)); },
      [](Change& into, const Change& other) { return into.Join(other); });
  std::optional<Change> whole;
  for (const InstructionId id : changes_.Reached()) {
    if (program_.instructions[id].op != Op::kRet) continue;
    if (whole) {
      whole->Join(*changes_[id]);
    } else {
      whole = changes_[id];
    }
  }
  summaries_[subprogram] = whole.value_or(Change{.sets = kAllResources, .undefines = 0});
}

void LoadChecker::Check(InstructionId entry, const Missing& initial) {
  Spread(
      flow_, entry, initial, missing_,
      [&](InstructionId id, const Missing& before, Edge edge) {
        if (edge == Edge::kResume) return kAtResume;
        if (edge == Edge::kPast) return kAtEntry;
        return ChangeAt(id).Of(before);
      },
      [](Missing& into, const Missing& other) { return into.Join(other); });
  for (const InstructionId id : missing_.Reached()) {
    Look(id, *missing_[id]);
    if (program_.instructions[id].op != Op::kCall) continue;
    const auto callee = flow_.CalleeOf(program_.instructions[id]);
    if (!callee) continue;
    if (at_entry_[*callee]) {
      at_entry_[*callee]->Join(*missing_[id]);
    } else {
      at_entry_[*callee] = missing_[id];
    }
  }
}

/// The last one above in the same unit, else the first one below, from which a jump leads back.
InstructionId LoadChecker::WaitBefore(InstructionId id) const {
  const UnitId unit = program_.instructions[id].unit;
  const auto is_inside = [&](uint32_t i) { return program_.instructions[InstructionId(i)].unit == unit; };
  const auto is_wait = [&](uint32_t i) { return IsWait(program_.instructions[InstructionId(i)].op); };
  for (uint32_t i = id.index; i > 0 && is_inside(i - 1); --i) {
    if (is_wait(i - 1)) return InstructionId(i - 1);
  }
  for (uint32_t i = id.index; i < program_.instructions.size() && is_inside(i); ++i) {
    if (is_wait(i)) return InstructionId(i);
  }
  return {};
}

void LoadChecker::Look(InstructionId id, const Missing& missing) {
  const Instruction& instruction = program_.instructions[id];
  if (reported_[id.index] || instruction.faulty) return;
  const Resources reads = EffectsAt(id).reads;
  const auto report = [&](const auto& message, Resources resources) {
    reported_[id.index] = true;
    const bool flag = (resources & kFlags) != 0 && (resources & kRlo) == 0;
    const std::string name = NameOf(resources);
    Report(diagnostics_, program_, instruction, message,
           flag && &message != &diag::TechnolUndefinedFlag ? "flag " + name : name, ToText(program_, instruction));
  };
  const Resources loaded = kRlo | PartsOfDr(32);
  if ((reads & missing.since_wait) != 0) {
    reported_[id.index] = true;
    const std::string name = NameOf(reads & missing.since_wait);
    const InstructionId wait = WaitBefore(id);
    const auto& message = IsWait(instruction.op) ? diag::TechnolWaitAcrossWait : diag::TechnolAcrossWait;
    diag::Diagnostic& diagnostic =
        Report(diagnostics_, program_, instruction, message, name, ToText(program_, instruction));
    if (wait.valid()) diagnostic.notes.push_back({program_.instructions[wait].range, "the wait"});
    return;
  }
  if ((reads & missing.since_entry & loaded) != 0) {
    return report(diag::TechnolBeforeLoad, reads & missing.since_entry & loaded);
  }
  if ((reads & missing.undefined) != 0) return report(diag::TechnolUndefinedFlag, reads & missing.undefined);
  if ((reads & missing.since_entry) != 0) report(diag::TechnolRegisterUnset, reads & missing.since_entry);
}

void LoadChecker::Run() {
  if (!flow_.recursions().empty()) return;  // reported
  summaries_.resize(flow_.subprograms().size());
  at_entry_.resize(flow_.subprograms().size());
  reported_.resize(program_.instructions.size());
  for (const uint32_t subprogram : flow_.calls_first()) Summarize(subprogram);
  for (const Root& root : flow_.roots()) Check(root.at, kAtEntry);
  for (size_t i = flow_.calls_first().size(); i-- > 0;) {
    const uint32_t subprogram = flow_.calls_first()[i];
    if (at_entry_[subprogram]) Check(flow_.EntryOf(subprogram), *at_entry_[subprogram]);
  }
}

}  // namespace

void CheckLoads(const Flow& flow, diag::Engine& diagnostics) { LoadChecker(flow, diagnostics).Run(); }

}  // namespace plcxx::technol
