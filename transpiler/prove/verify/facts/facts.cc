#include "transpiler/prove/verify/facts/facts.h"

#include <algorithm>
#include <map>
#include <utility>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/facts.h"
#include "transpiler/prove/verify/facts/fact_run.h"
#include "transpiler/prove/verify/verify.h"

namespace plcxx::prove::verify::facts {
namespace {

using verify::Unit;
using verify::UnitId;

class FactProver {
 public:
  FactProver(const emit::Emittable& checked, const FactLimits& limits)
      : program_(checked), limits_(limits), visited_(program_.units.all.size()) {}

  std::vector<FactProof> Run(std::span<const ir::RoutineId> routines);

 private:
  /// The unit's own facts and those of all that it calls.
  void Visit(UnitId id);
  void FindOwn(const Unit& unit, ir::RegionId region, std::vector<ir::InstId>& own) const;
  std::vector<ir::InstId> OwnFacts(const Unit& unit) const;
  /// By the function alone; what is left stays open.
  void ProveAlone(const Unit& unit);
  void ProveFromOutside(ir::RoutineId routine);
  /// Whether the unit, or what it calls, has an open fact.
  bool ReachesOpen(UnitId id) const;
  void Show(const std::string& text) const {
    if (limits_.progress) limits_.progress(text);
  }

  CheckedProgram program_;
  const FactLimits& limits_;
  std::vector<bool> visited_;  // by UnitId
  std::map<ir::InstId, FactProof> proofs_;
  std::vector<ir::InstId> open_;
};

void FactProver::FindOwn(const Unit& unit, ir::RegionId region, std::vector<ir::InstId>& own) const {
  if (!region.valid()) return;
  const bool is_part = region == unit.part.region;
  const std::vector<ir::InstId>& insts = program_.ir.regions[region].insts;
  const auto end = is_part ? unit.part.end : static_cast<uint32_t>(insts.size());
  for (uint32_t at = is_part ? unit.part.begin : 0; at < end;) {
    const UnitId chunk = program_.units.At(program_.emittable, region, at);
    if (chunk.valid() && &program_.units[chunk] != &unit) {
      at = program_.units[chunk].part.end;
      continue;
    }
    const ir::Inst& inst = program_.ir[insts[at]];
    if (ir::IsFalseFact(program_.ir, inst)) own.push_back(insts[at]);
    for (const ir::RegionId owned : ir::OwnedRegions(program_.ir, inst)) FindOwn(unit, owned, own);
    ++at;
  }
}

std::vector<ir::InstId> FactProver::OwnFacts(const Unit& unit) const {
  std::vector<ir::InstId> own;
  if (unit.part.region.valid()) {
    FindOwn(unit, unit.part.region, own);
    return own;
  }
  const ir::Routine& routine = program_.ir.routines[unit.part.routine];
  for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) FindOwn(unit, region, own);
  return own;
}

void FactProver::ProveAlone(const Unit& unit) {
  std::vector<ir::InstId> left = OwnFacts(unit);
  if (left.empty()) return;
  const solver::Deadline deadline(solver::Clock::kProcessor, limits_.routine_ms);
  for (const ir::InstId call : left) proofs_[call] = {.call = call, .reason = {}, .violation = {}};
  for (const Calls calls : {Calls::kAnything, Calls::kFollowed}) {
    if (left.empty() || (calls == Calls::kFollowed && unit.callees.empty())) break;
    Show("facts of " + unit.name);
    FactRun run(program_, unit, calls, limits_, deadline);
    const std::vector<Shown> shown = run.Run();
    std::vector<ir::InstId> still;
    for (const ir::InstId call : left) {
      FactProof& proof = proofs_[call];
      const auto found = std::ranges::find(shown, call, &Shown::call);
      if (!run.refusal().empty()) {
        proof.reason = run.refusal();
      } else if (found == shown.end() || found->result == FactResult::kProved) {
        proof.result = FactResult::kProved;
        proof.reason.clear();
        continue;
      } else {
        proof.result = found->result;
        proof.reason = found->reason;
        proof.value = found->value;
        if (found->violation) proof.violation = *found->violation;
        if (found->result == FactResult::kViolated) continue;
      }
      still.push_back(call);
    }
    left = std::move(still);
  }
  open_.insert(open_.end(), left.begin(), left.end());
}

void FactProver::Visit(UnitId id) {
  if (!id.valid() || visited_[id.index]) return;
  visited_[id.index] = true;
  for (const UnitId callee : program_.units[id].callees) Visit(callee);
  ProveAlone(program_.units[id]);
}

bool FactProver::ReachesOpen(UnitId id) const {
  std::vector<bool> seen(program_.units.all.size());
  std::vector<UnitId> work = {id};
  while (!work.empty()) {
    const UnitId at = work.back();
    work.pop_back();
    if (!at.valid() || seen[at.index]) continue;
    seen[at.index] = true;
    const std::vector<ir::InstId> own = OwnFacts(program_.units[at]);
    const auto is_open = [this](ir::InstId call) { return std::ranges::find(open_, call) != open_.end(); };
    if (std::ranges::any_of(own, is_open)) return true;
    work.insert(work.end(), program_.units[at].callees.begin(), program_.units[at].callees.end());
  }
  return false;
}

/// Everything that is still open, as far as this routine comes to it.
void FactProver::ProveFromOutside(ir::RoutineId routine) {
  const Unit& unit = program_.units[program_.units.of_routines[routine.index]];
  Show("facts of all that " + unit.name + " calls");
  const solver::Deadline deadline(solver::Clock::kProcessor, limits_.routine_ms);
  FactRun run(program_, unit, Calls::kFollowed, limits_, deadline);
  const std::vector<Shown> shown = run.Run();
  for (const ir::InstId call : open_) {
    FactProof& proof = proofs_[call];
    if (proof.result == FactResult::kViolated) continue;
    const auto found = std::ranges::find(shown, call, &Shown::call);
    if (!run.refusal().empty()) {
      if (proof.reason.empty()) proof.reason = run.refusal();
    } else if (found != shown.end() && found->result != FactResult::kProved) {
      proof.result = found->result;
      proof.reason = found->reason;
      proof.value = found->value;
      if (found->violation) proof.violation = *found->violation;
    }
  }
}

std::vector<FactProof> FactProver::Run(std::span<const ir::RoutineId> routines) {
  for (const ir::RoutineId routine : routines) Visit(program_.units.of_routines[routine.index]);
  if (!open_.empty()) {
    // Proved unless some routine shows otherwise: of all that the control calls, whichever were asked for.
    for (const ir::InstId call : open_) proofs_[call].reason.clear();
    for (const ir::RoutineId routine : verify::RoutinesToVerify(program_.ir)) {
      if (ReachesOpen(program_.units.of_routines[routine.index])) ProveFromOutside(routine);
    }
    for (const ir::InstId call : open_) {
      FactProof& proof = proofs_[call];
      if (proof.result == FactResult::kNotDecided && proof.reason.empty()) proof.result = FactResult::kProved;
    }
  }
  std::vector<FactProof> proofs;
  for (auto& [call, proof] : proofs_) proofs.push_back(std::move(proof));
  return proofs;
}

}  // namespace

std::vector<FactProof> ProveFacts(const emit::Emittable& checked, std::span<const ir::RoutineId> routines,
                                  const FactLimits& limits) {
  return FactProver(checked, limits).Run(routines);
}

}  // namespace plcxx::prove::verify::facts
