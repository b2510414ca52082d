#include "transpiler/prove/verify/verify.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "transpiler/prove/verify/unit_verifier.h"
#include "transpiler/prove/verify/verified_program.h"
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

/// All functions of a program, callees first.
class Verification {
 public:
  Verification(const emit::Emittable& emittable, CompiledCode& code, const CodeShape& shape, const VerifyLimits& limits)
      : program_(emittable, code, shape, limits),
        visited_(program_.units.all.size()),
        open_(program_.units.all.size()) {}

  void ProveRoutine(ir::RoutineId routine) { Prove(program_.units.of_routines[routine.index]); }
  std::vector<RoutineProof> TakeProofs() { return std::move(proofs_); }

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

  void Prove(UnitId id);
  /// Of calls that are replaced, also in functions that are followed.
  void Collect(const Unit& unit, Granted& granted) const;
  Try ProveWith(const Unit& unit, Loops loops, Granted& granted, const solver::Deadline& deadline) const;
  /// For all constants that it is called with.
  Try ProveCases(const Unit& unit, Callees callees, Loops loops, const solver::Deadline& deadline) const;
  Try RunInStep(const Unit& unit, const ArgumentCase& given, Callees callees, const solver::Deadline& deadline) const;
  Try RunOnce(const Unit& unit, const ArgumentCase& given, const Treatment& treatment,
              const solver::Deadline& deadline) const;
  /// `greatest_result`: of a proved unit; may be none.
  void Replace(UnitId id, const std::vector<std::string>& parameters, std::set<std::string> open,
               std::optional<uint64_t> greatest_result);

  VerifiedProgram program_;
  std::vector<bool> visited_;                // by UnitId
  std::vector<std::set<std::string>> open_;  // by UnitId, of those that are replaced
  std::vector<RoutineProof> proofs_;
};

void Verification::Collect(const Unit& unit, Granted& granted) const {
  for (const UnitId id : unit.callees) {
    const Unit& callee = program_.units[id];
    if (program_.calls[id.index] == nullptr) {
      Collect(callee, granted);
    } else if (std::ranges::find(granted.functions, callee.name) == granted.functions.end()) {
      granted.functions.push_back(callee.name);
      granted.open.insert(open_[id.index].begin(), open_[id.index].end());
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
                                        const solver::Deadline& deadline) const {
  UnitVerifier verifier(program_, unit, given, treatment, deadline);
  return Shown(verifier);
}

/// What is guessed of loops and is not so is dropped, until all that is claimed of them is so, or too little is left.
Verification::Try Verification::RunInStep(const Unit& unit, const ArgumentCase& given, Callees callees,
                                          const solver::Deadline& deadline) const {
  Treatment treatment{.callees = callees, .loops = Loops::kInStep, .dropped = {}};
  bool second_chance = false;
  for (int i = 0;; ++i) {
    UnitVerifier verifier(program_, unit, given, treatment, deadline);
    Try tried = Shown(verifier);
    if (i == 0 && tried.has_loops && tried.proof.result != ProofResult::kProved) {
      // Before guesses are looked for that would not help: the first rounds may differ.
      Try first = RunOnce(
          unit, given, {.callees = Callees::kFollowed, .loops = Loops::kFirstRounds, .dropped = {}, .is_glance = true},
          deadline);
      if (first.proof.result == ProofResult::kDifferent) return first;
    }
    for (const std::string& guess : verifier.refuted()) ++treatment.dropped[guess];
    if (i == kMostRetries || deadline.IsOver()) return tried;
    if (!verifier.refuted().empty()) continue;
    // What the code keeps may have been dropped for what was said wrongly of the program's words; these are right now.
    const auto of_code = [](const auto& dropped) { return dropped.first.starts_with(kGuessOfCode); };
    const bool again = !second_chance && tried.has_loops && tried.proof.result != ProofResult::kProved;
    if (!again || std::erase_if(treatment.dropped, of_code) == 0) return tried;
    second_chance = true;
  }
}

Verification::Try Verification::ProveCases(const Unit& unit, Callees callees, Loops loops,
                                           const solver::Deadline& deadline) const {
  const bool in_step = loops == Loops::kInStep && callees != Callees::kReplacedInOrder;
  std::optional<Try> all;
  for (const ArgumentCase& given : ArgumentCases(program_.ir, unit)) {
    Try one = in_step ? RunInStep(unit, given, callees, deadline)
                      : RunOnce(unit, given, {.callees = callees, .loops = loops, .dropped = {}}, deadline);
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
Verification::Try Verification::ProveWith(const Unit& unit, Loops loops, Granted& granted,
                                          const solver::Deadline& deadline) const {
  Try tried;
  std::optional<RoutineProof> but_for_open;
  bool has_loops = false;
  for (const Callees callees : {Callees::kReplacedInOrder, Callees::kReplacedByArguments, Callees::kFollowed}) {
    // What is not so for unknown functions may be so for these: only who follows calls finds differences.
    const bool followed = callees == Callees::kFollowed;
    if (!followed && (granted.functions.empty() || but_for_open)) continue;
    // What was tried in order says least of why nothing is decided.
    if (deadline.IsOver() && followed && tried.gave_up) break;
    tried = ProveCases(unit, callees, loops, deadline);
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
void Verification::Replace(UnitId id, const std::vector<std::string>& parameters, std::set<std::string> open,
                           std::optional<uint64_t> greatest_result) {
  const Unit& unit = program_.units[id];
  std::optional<NumberRange> range = program_.code.ResultRange(program_.CppName(unit));
  if (!range && greatest_result) {
    const int bits = std::max(1, static_cast<int>(std::bit_width(*greatest_result)));
    if (bits < meaning::WidthOf(program_.ir.places[unit.result].type)) range = {.low = 0, .count = uint64_t{1} << bits};
  }
  auto call = std::make_unique<ReplacedCall>(program_.emittable, program_.cells, program_.image, unit,
                                             program_.shape.passes, parameters, range);
  if (call->is_opaque()) return;
  program_.calls[id.index] = std::move(call);
  open_[id.index] = std::move(open);
}

void Verification::Prove(UnitId id) {
  if (!id.valid() || visited_[id.index]) return;
  visited_[id.index] = true;
  const Unit& unit = program_.units[id];
  for (const UnitId callee : unit.callees) Prove(callee);
  if (program_.is_unknown[id.index]) return;
  if (!unit.part.region.valid() &&
      std::ranges::find(program_.shape.in_callers, unit.part.routine) != program_.shape.in_callers.end())
    return;
  const bool inner = unit.part.region.valid() || emit::SharesLocals(program_.ir.routines[unit.part.routine].kind);
  auto parameters = program_.code.Parameters(program_.CppName(unit));
  // Nothing has been left out of code that is not optimized.
  if (parameters && program_.shape.passes == Passes::kNothing)
    parameters = ParametersOf(program_.emittable, unit, program_.shape.passes);
  // What the compiler has put into its callers is proved there.
  if (inner && !parameters) return;
  Granted granted;
  Collect(unit, granted);
  const solver::Deadline deadline(solver::Clock::kProcessor, program_.limits.routine_ms);
  Try tried = ProveWith(unit, Loops::kInStep, granted, deadline);
  const auto is_open = [&tried] {
    return tried.proof.result == ProofResult::kNotDecided && !tried.but_for_open.has_value();
  };
  if (tried.has_loops && is_open() && !deadline.IsOver()) {
    // The first rounds may differ; and unrolled they may end soon enough.
    const RoutineProof in_step = std::move(tried.proof);
    tried = ProveCases(unit, Callees::kFollowed, Loops::kFirstRounds, deadline);
    if (tried.proof.result != ProofResult::kDifferent) {
      tried = ProveWith(unit, Loops::kUnrolled, granted, deadline);
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
    Replace(id, *parameters, std::move(granted.open), proved ? tried.greatest_result : std::nullopt);
  if (program_.limits.is_decided) program_.limits.is_decided(proof);
  proofs_.push_back(std::move(proof));
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
  Verification verification(emittable, code, shape, limits);
  for (const ir::RoutineId routine : routines) verification.ProveRoutine(routine);
  return verification.TakeProofs();
}

}  // namespace plcxx::prove::verify
