#include "transpiler/prove/verify/verify.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "transpiler/prove/verify/unit_verifier.h"
#include "transpiler/prove/verify/verified_program.h"
#include "transpiler/support/work_in_order.h"
#include "transpiler/symbolic/meaning/meaning.h"
#include "transpiler/symbolic/solver/deadline.h"

namespace plcxx::prove::verify {
namespace {

constexpr int kMostRetries = 80;  // with other guesses of what loops have in common

/// Both are proofs of one function, each for other arguments.
void Add(RoutineProof& all, RoutineProof one) {
  // What differs says more than what is not decided.
  const auto weight = [](ProofResult result) {
    return result == ProofResult::kDifferent ? 2 : result == ProofResult::kNotDecided ? 1 : 0;
  };
  if (weight(one.result) > weight(all.result)) {
    all.result = one.result;
    all.reason = std::move(one.reason);
    all.statement = one.statement;
    all.differences = std::move(one.differences);
  }
  all.obligations += one.obligations;
  all.instructions += one.instructions;
  all.asked += one.asked;
  all.claims += one.claims;
}

/// All functions of a program, each after its callees, several at a time.
class Verification {
 public:
  Verification(const emit::Emittable& emittable, const CodeShape& shape, const VerifyLimits& limits)
      : program_(emittable, shape, Guarded(limits)),
        pieces_(program_.units.all.size()),
        chunks_(program_.ir.routines.size()),
        asked_before_(program_.units.all.size()),
        for_callers_(program_.units.all.size()),
        answered_(program_.units.all.size()) {}

  void AddRoutine(ir::RoutineId routine) { AddUnit(program_.units.of_routines[routine.index]); }
  /// Of those that were added, callees first.
  std::vector<RoutineProof> Prove(CompiledCode& code);

 private:
  /// What the proof of a function takes for granted.
  struct Granted {
    std::vector<std::string> functions;
    std::set<std::string> open;  // of these, and of what they call, those that are not decided
  };
  struct Try {
    RoutineProof proof;
    bool gave_up = false, has_loops = false;
    std::optional<uint64_t> greatest_result;  // as UnitVerifier says it
    std::optional<RoutineProof> but_for_open;
  };
  /// What one execution of a unit has shown.
  static Try Shown(UnitVerifier& verifier);

  /// What a function's callers are proved with.
  struct ForCallers {
    std::unique_ptr<ReplacedCall> call;  // none: it is followed
    std::set<std::string> open;          // of it and of what it calls, those that are not decided
  };

  /// Progress and proofs are told by one thread at a time: who is told need not know of threads.
  VerifyLimits Guarded(VerifyLimits limits);
  void AddUnit(UnitId id);
  Workplace WorkplaceOf(UnitId id, CompiledCode& code) const;
  /// None: it is not proved by itself. Of what others read it writes only what is for its callers.
  std::optional<RoutineProof> ProveUnit(UnitId id, CompiledCode& code);
  /// Of calls that are replaced, also in functions that are followed.
  void Collect(const Unit& unit, const Workplace& workplace, Granted& granted) const;
  Try ProveWith(const Unit& unit, Loops loops, Granted& granted, Workplace& workplace) const;
  /// For all constants that it is called with.
  Try ProveCases(const Unit& unit, Callees callees, Loops loops, Workplace& workplace) const;
  Try RunInStep(const Unit& unit, const ArgumentCase& given, Callees callees, Workplace& workplace) const;
  Try RunOnce(const Unit& unit, const ArgumentCase& given, const Treatment& treatment, Workplace& workplace) const;
  /// `greatest_result`: of a proved unit; may be none.
  ForCallers MakeForCallers(const Unit& unit, const CompiledCode& code, const std::vector<std::string>& parameters,
                            std::set<std::string> open, std::optional<uint64_t> greatest_result) const;

  std::mutex telling_;
  VerifiedProgram program_;
  support::WorkInOrder work_;
  std::vector<UnitId> units_;                    // by PieceId
  std::vector<support::PieceId> pieces_;         // by UnitId; none: it is not asked for
  std::vector<std::vector<UnitId>> chunks_;      // by RoutineId, those that were added
  std::vector<UnitId> asked_before_;             // by UnitId: with whose answers it begins; may be none
  std::vector<ForCallers> for_callers_;          // by UnitId
  std::vector<solver::AnsweredForms> answered_;  // by UnitId
};

VerifyLimits Verification::Guarded(VerifyLimits limits) {
  if (limits.progress) {
    limits.progress = [this, tell = std::move(limits.progress)](const std::string& text) {
      const std::lock_guard<std::mutex> lock(telling_);
      tell(text);
    };
  }
  if (limits.is_decided) {
    limits.is_decided = [this, tell = std::move(limits.is_decided)](const RoutineProof& proof) {
      const std::lock_guard<std::mutex> lock(telling_);
      tell(proof);
    };
  }
  return limits;
}

void Verification::Collect(const Unit& unit, const Workplace& workplace, Granted& granted) const {
  for (const UnitId id : unit.callees) {
    const Unit& callee = program_.units[id];
    if (workplace.calls[id.index] == nullptr) {
      Collect(callee, workplace, granted);
    } else if (std::ranges::find(granted.functions, callee.name) == granted.functions.end()) {
      granted.functions.push_back(callee.name);
      const std::set<std::string>& open = for_callers_[id.index].open;
      granted.open.insert(open.begin(), open.end());
    }
  }
}

Verification::Try Verification::Shown(UnitVerifier& verifier) {
  Try tried;
  tried.proof = verifier.Run();
  tried.gave_up = verifier.gave_up();
  tried.has_loops = verifier.has_loops();
  tried.greatest_result = verifier.greatest_result();
  return tried;
}

Verification::Try Verification::RunOnce(const Unit& unit, const ArgumentCase& given, const Treatment& treatment,
                                        Workplace& workplace) const {
  UnitVerifier verifier(program_, workplace, unit, given, treatment);
  return Shown(verifier);
}

/// What is guessed of loops and is not so is dropped, until all that is claimed of them is so, or too little is left.
Verification::Try Verification::RunInStep(const Unit& unit, const ArgumentCase& given, Callees callees,
                                          Workplace& workplace) const {
  Treatment treatment{.callees = callees, .loops = Loops::kInStep, .dropped = {}};
  bool second_chance = false;
  for (int i = 0;; ++i) {
    UnitVerifier verifier(program_, workplace, unit, given, treatment);
    Try tried = Shown(verifier);
    if (i == 0 && tried.has_loops && tried.proof.result != ProofResult::kProved) {
      // Before guesses are looked for that would not help: the first rounds may differ.
      Try first = RunOnce(
          unit, given, {.callees = Callees::kFollowed, .loops = Loops::kFirstRounds, .dropped = {}, .is_glance = true},
          workplace);
      if (first.proof.result == ProofResult::kDifferent) return first;
    }
    for (const std::string& guess : verifier.refuted()) ++treatment.dropped[guess];
    if (i == kMostRetries || workplace.deadline.IsOver()) return tried;
    if (!verifier.refuted().empty()) continue;
    // What the code keeps may have been dropped for what was said wrongly of the program's words; these are right now.
    const auto of_code = [](const auto& dropped) { return dropped.first.starts_with(kGuessOfCode); };
    const bool again = !second_chance && tried.has_loops && tried.proof.result != ProofResult::kProved;
    if (!again || std::erase_if(treatment.dropped, of_code) == 0) return tried;
    second_chance = true;
  }
}

Verification::Try Verification::ProveCases(const Unit& unit, Callees callees, Loops loops, Workplace& workplace) const {
  const bool in_step = loops == Loops::kInStep && callees != Callees::kReplacedInOrder;
  std::optional<Try> all;
  for (const ArgumentCase& given : ArgumentCases(program_.ir, unit)) {
    Try one = in_step ? RunInStep(unit, given, callees, workplace)
                      : RunOnce(unit, given, {.callees = callees, .loops = loops, .dropped = {}}, workplace);
    if (!all) {
      all = std::move(one);
    } else {
      Add(all->proof, std::move(one.proof));
      all->gave_up = all->gave_up || one.gave_up;
      all->has_loops = all->has_loops || one.has_loops;
      all->greatest_result = std::max(all->greatest_result, one.greatest_result);
    }
    if (all->proof.result != ProofResult::kProved) break;
  }
  return std::move(*all);
}

/// Calls of proved functions as unknown functions first; `granted.open` becomes empty where nothing was left open.
Verification::Try Verification::ProveWith(const Unit& unit, Loops loops, Granted& granted, Workplace& workplace) const {
  Try tried;
  std::optional<RoutineProof> but_for_open;
  bool has_loops = false;
  for (const Callees callees : {Callees::kReplacedInOrder, Callees::kReplacedByArguments, Callees::kFollowed}) {
    // What is not so for unknown functions may be so for these: only who follows calls finds differences.
    const bool followed = callees == Callees::kFollowed;
    if (!followed && (granted.functions.empty() || but_for_open)) continue;
    // What was tried in order says least of why nothing is decided.
    if (workplace.deadline.IsOver() && followed && tried.gave_up) break;
    tried = ProveCases(unit, callees, loops, workplace);
    has_loops = has_loops || tried.has_loops;
    if (tried.proof.result == ProofResult::kProved) {
      if (!followed) tried.proof.relies_on = granted.functions;
      if (followed) granted.open.clear();
      if (granted.open.empty()) break;
      but_for_open = tried.proof;
    } else if (tried.gave_up && granted.open.empty() && !tried.has_loops) {
      break;
    }
  }
  tried.but_for_open = std::move(but_for_open);
  tried.has_loops = has_loops;
  return tried;
}

/// What the compiler says of a function's result; else as many bits as the proof has seen it to need, which the passes
/// of the program may rest on where it is called.
Verification::ForCallers Verification::MakeForCallers(const Unit& unit, const CompiledCode& code,
                                                      const std::vector<std::string>& parameters,
                                                      std::set<std::string> open,
                                                      std::optional<uint64_t> greatest_result) const {
  std::optional<NumberRange> range = code.ResultRange(program_.CppName(unit));
  if (!range && greatest_result) {
    const int bits = std::max(1, static_cast<int>(std::bit_width(*greatest_result)));
    if (bits < meaning::WidthOf(program_.ir.places[unit.result].type)) range = {.low = 0, .count = uint64_t{1} << bits};
  }
  auto call = std::make_unique<ReplacedCall>(program_.emittable, program_.cells, program_.image, unit,
                                             program_.shape.passes, parameters, range);
  if (call->is_opaque()) return {};
  return {.call = std::move(call), .open = std::move(open)};
}

void Verification::AddUnit(UnitId id) {
  if (!id.valid() || pieces_[id.index].valid()) return;
  std::vector<support::PieceId> needs;
  for (const UnitId callee : program_.units[id].callees) {
    AddUnit(callee);
    needs.push_back(pieces_[callee.index]);
  }
  if (program_.units[id].part.region.valid()) {
    // Chunks of one routine are much alike. Each begins with the answers of the one at half its number, so that most
    // is asked by a few, and many are proved side by side.
    std::vector<UnitId>& chunks = chunks_[program_.units[id].part.routine.index];
    if (!chunks.empty()) {
      asked_before_[id.index] = chunks[(chunks.size() - 1) / 2];
      needs.push_back(pieces_[asked_before_[id.index].index]);
    }
    chunks.push_back(id);
  }
  pieces_[id.index] = work_.Add(std::move(needs));
  units_.push_back(id);
}

Workplace Verification::WorkplaceOf(UnitId id, CompiledCode& code) const {
  std::vector<const ReplacedCall*> calls;
  for (const std::unique_ptr<ReplacedCall>& unknown : program_.unknown) calls.push_back(unknown.get());
  // Of others it may not be there yet.
  std::vector<bool> seen(calls.size());
  std::vector<UnitId> ways = program_.units[id].callees;
  while (!ways.empty()) {
    const UnitId at = ways.back();
    ways.pop_back();
    if (seen[at.index]) continue;
    seen[at.index] = true;
    if (calls[at.index] == nullptr) calls[at.index] = for_callers_[at.index].call.get();
    ways.insert(ways.end(), program_.units[at].callees.begin(), program_.units[at].callees.end());
  }
  const UnitId before = asked_before_[id.index];
  return {.code = code,
          .calls = std::move(calls),
          .deadline = solver::Deadline(solver::Clock::kProcessor, program_.limits.routine_ms),
          .answered = solver::AnsweredForms(before.valid() ? &answered_[before.index] : nullptr)};
}

std::optional<RoutineProof> Verification::ProveUnit(UnitId id, CompiledCode& code) {
  const Unit& unit = program_.units[id];
  if (program_.unknown[id.index] != nullptr) return std::nullopt;
  if (!unit.part.region.valid() &&
      std::ranges::find(program_.shape.in_callers, unit.part.routine) != program_.shape.in_callers.end())
    return std::nullopt;
  const bool inner = unit.part.region.valid() || emit::SharesLocals(program_.ir.routines[unit.part.routine].kind);
  auto parameters = code.Parameters(program_.CppName(unit));
  // Nothing has been left out of code that is not optimized.
  if (parameters && program_.shape.passes == Passes::kNothing)
    parameters = ParametersOf(program_.emittable, unit, program_.shape.passes);
  // What the compiler has put into its callers is proved there.
  if (inner && !parameters) return std::nullopt;
  Workplace workplace = WorkplaceOf(id, code);
  Granted granted;
  Collect(unit, workplace, granted);
  Try tried = ProveWith(unit, Loops::kInStep, granted, workplace);
  const auto is_open = [&tried] {
    return tried.proof.result == ProofResult::kNotDecided && !tried.but_for_open.has_value();
  };
  if (tried.has_loops && is_open() && !workplace.deadline.IsOver()) {
    // The first rounds may differ; and unrolled they may end soon enough.
    const RoutineProof in_step = std::move(tried.proof);
    tried = ProveCases(unit, Callees::kFollowed, Loops::kFirstRounds, workplace);
    if (tried.proof.result != ProofResult::kDifferent) {
      tried = ProveWith(unit, Loops::kUnrolled, granted, workplace);
      if (is_open()) tried.proof = in_step;
    }
  }
  RoutineProof& proof = tried.proof;
  if (proof.result == ProofResult::kNotDecided && tried.but_for_open) {
    proof = *tried.but_for_open;
    tried.gave_up = false;
    proof.result = ProofResult::kNotDecided;
    proof.reason = "all is proved but";
    for (const std::string& name : granted.open) proof.reason += (name == *granted.open.begin() ? " " : ", ") + name;
  } else if (tried.gave_up) {
    granted.open.insert(unit.name);
  }
  const bool takes_over =
      proof.result != ProofResult::kDifferent && (tried.gave_up || proof.reason.empty() || tried.but_for_open);
  const bool init = !inner && program_.ir.routines[unit.part.routine].kind == ir::RoutineKind::kInit;
  const bool proved = proof.result == ProofResult::kProved;
  if (takes_over && !init && parameters)
    for_callers_[id.index] =
        MakeForCallers(unit, code, *parameters, std::move(granted.open), proved ? tried.greatest_result : std::nullopt);
  answered_[id.index] = std::move(workplace.answered);
  return std::move(proof);
}

std::vector<RoutineProof> Verification::Prove(CompiledCode& code) {
  const size_t workers = std::clamp<size_t>(work_.size(), 1, program_.limits.jobs);
  std::vector<std::unique_ptr<CompiledCode>> copies;
  while (copies.size() + 1 < workers) copies.push_back(code.Copy());
  std::vector<std::optional<RoutineProof>> found(work_.size());  // by PieceId
  work_.Run(
      workers,
      [&](support::PieceId piece, size_t worker) {
        found[piece.index] = ProveUnit(units_[piece.index], worker == 0 ? code : *copies[worker - 1]);
      },
      [&](support::PieceId piece) {
        if (program_.limits.is_decided && found[piece.index]) program_.limits.is_decided(*found[piece.index]);
      });
  std::vector<RoutineProof> proofs;
  for (std::optional<RoutineProof>& proof : found) {
    if (proof) proofs.push_back(std::move(*proof));
  }
  return proofs;
}

}  // namespace

std::vector<ir::RoutineId> RoutinesToVerify(const ir::Program& program) {
  std::vector<ir::RoutineId> routines;
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    const ir::Routine& routine = program.routines[ir::RoutineId(i)];
    if (!emit::SharesLocals(routine.kind) && !routine.simulation_only) routines.emplace_back(i);
  }
  return routines;
}

std::vector<RoutineProof> Verify(const emit::Emittable& emittable, CompiledCode& code,
                                 std::span<const ir::RoutineId> routines, const VerifyLimits& limits,
                                 const CodeShape& shape) {
  Verification verification(emittable, shape, limits);
  for (const ir::RoutineId routine : routines) verification.AddRoutine(routine);
  return verification.Prove(code);
}

}  // namespace plcxx::prove::verify
