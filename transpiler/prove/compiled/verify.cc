#include "transpiler/prove/compiled/verify.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "transpiler/prove/compiled/host_surroundings.h"
#include "transpiler/prove/compiled/local_sweep.h"
#include "transpiler/prove/compiled/state_image.h"
#include "transpiler/prove/execute/execute.h"
#include "transpiler/prove/meaning/meaning.h"
#include "transpiler/prove/solver/solver.h"
#include "transpiler/prove/solver/sweep.h"

namespace plcxx::prove {
namespace {

constexpr size_t kMostDifferences = 8;
constexpr size_t kMostValues = 60;  // of a state that is shown

/// One routine: both executions, and their comparison.
class RoutineVerifier {
 public:
  RoutineVerifier(const emit::Emittable& emittable, CompiledCode& code, const VerifyLimits& limits, ir::RoutineId id)
      : emittable_(emittable),
        program_(*emittable.program),
        code_(code),
        limits_(limits),
        id_(id),
        routine_(program_.routines[id]),
        cells_(MakeCells(program_)),
        image_(program_, emittable.layout, cells_) {}

  RoutineProof Run();

 private:
  struct Question {
    std::string what;
    TermPair pair;  // the IR's, the code's
  };

  bool is_init() const { return routine_.kind == ir::RoutineKind::kInit; }
  Environment MakeEnvironment();
  void Observe(Memory& memory, ir::HostFunctionId function, TermId when);
  TermId InitialSlot(uint32_t slot);
  CodeOutcome ExecuteCode();
  void Ask(Memory& memory, const CodeOutcome& outcome);
  void Decide();
  CodeDifference Show(Solver& solver, const Question& question);
  std::vector<TermId> VariablesOf(const TermPair& pair) const;

  const emit::Emittable& emittable_;
  const ir::Program& program_;
  CompiledCode& code_;
  const VerifyLimits& limits_;
  ir::RoutineId id_;
  const ir::Routine& routine_;
  Cells cells_;
  StateImage image_;
  Terms terms_;
  TermId now_, hash_;
  std::vector<TermId> arguments_;
  std::vector<Question> questions_;
  RoutineProof proof_;
};

Environment RoutineVerifier::MakeEnvironment() {
  Environment environment;
  environment.now = now_;
  environment.initial = [this](CellId cell) {
    const bool power_on = is_init() && CellAt(program_, cells_, cell).kind != CellKind::kCalls;
    return power_on ? image_.CellAtPowerOn(terms_, cell) : image_.CellBefore(terms_, cell);
  };
  environment.observe = [this](Memory& memory, ir::HostFunctionId function, TermId when) {
    Observe(memory, function, when);
  };
  return environment;
}

void RoutineVerifier::Observe(Memory& memory, ir::HostFunctionId function, TermId when) {
  const ir::HostFunction& host = program_.host_functions[function];
  const bool retentive = host.access == ir::HostAccess::kReadsRetentive;
  const uint32_t begin = retentive ? image_.retentive_begin() : 0;
  const uint32_t end = retentive ? image_.retentive_end() : image_.size();
  std::vector<TermId> bytes;
  for (uint32_t at = begin; at < end; ++at) {
    if (image_[at].kind == ByteKind::kNothing) continue;
    bytes.push_back(image_.ByteFor(terms_, at, [&memory](CellId cell) { return memory.Read(cell); }, hash_));
  }
  const CellId counter = cells_.OfCalls(function);
  const TermId calls = memory.Read(counter);
  memory.Write(counter, terms_.Ite(when, HavingSeen(terms_, host.name, calls, bytes), calls));
}

TermId RoutineVerifier::InitialSlot(uint32_t slot) {
  if (slot >= image_.size()) return image_.CellBefore(terms_, cells_.OfCalls(ir::HostFunctionId(slot - image_.size())));
  // Before init the memory may hold anything.
  return is_init() ? terms_.Variable("State byte " + std::to_string(slot), 8) : image_.ByteBefore(terms_, slot);
}

CodeOutcome RoutineVerifier::ExecuteCode() {
  HostSurroundings surroundings(terms_, emittable_, image_, now_, [this](uint32_t slot) { return InitialSlot(slot); });
  CodeRun run;
  run.function = emittable_.namespace_name + "::" + emittable_.routine_names[id_.index];
  run.state_bytes = image_.size();
  run.further_slots = program_.host_functions.size();
  run.arguments = arguments_;
  return code_.Execute(terms_, surroundings, run);
}

void RoutineVerifier::Ask(Memory& memory, const CodeOutcome& outcome) {
  const auto cell = [&memory](CellId id) { return memory.Read(id); };
  for (uint32_t at = 0; at < image_.size(); ++at) {
    if (image_[at].kind == ByteKind::kNothing) continue;
    questions_.push_back({image_.NameOf(at), {image_.ByteFor(terms_, at, cell, hash_), outcome.slots[at]}});
    ++proof_.bytes;
  }
  for (uint32_t i = 0; i < program_.host_functions.size(); ++i) {
    const ir::HostFunctionId host(i);
    if (!emittable_.host_used[i] || host == program_.schedule.now) continue;
    questions_.push_back({"calls of " + program_.host_functions[host].name,
                          {memory.Read(cells_.OfCalls(host)), outcome.slots[image_.size() + i]}});
    ++proof_.host_functions;
  }
  if (routine_.result_place.valid()) {
    questions_.push_back({"the result", {memory.ReadPlace(program_.places[routine_.result_place]), outcome.result}});
  }
  for (const Obligation& obligation : outcome.obligations) {
    questions_.push_back({obligation.text, {terms_.Bit(false), obligation.never}});
    ++proof_.obligations;
  }
}

std::vector<TermId> RoutineVerifier::VariablesOf(const TermPair& pair) const {
  std::vector<bool> seen(terms_.size());
  std::vector<TermId> open = {pair.a, pair.b}, variables;
  while (!open.empty()) {
    const TermId id = open.back();
    open.pop_back();
    if (seen[id.index]) continue;
    seen[id.index] = true;
    if (terms_[id].kind == TermKind::kVariable) variables.push_back(id);
    terms_.ForEachOperand(terms_[id], [&open](TermId operand) { open.push_back(operand); });
  }
  std::ranges::sort(variables);
  return variables;
}

CodeDifference RoutineVerifier::Show(Solver& solver, const Question& question) {
  CodeDifference difference{.what = question.what};
  const TermId differ = terms_.Ne(question.pair.a, question.pair.b);
  if (solver.Check({&differ, 1}, limits_.question_ms) != Answer::kPossible) return difference;
  difference.has_values = true;
  difference.expected = solver.ValueOf(question.pair.a);
  difference.compiled = solver.ValueOf(question.pair.b);
  for (const TermId variable : VariablesOf(question.pair)) {
    const uint64_t value = solver.ValueOf(variable);
    if (value != 0 && difference.state.size() < kMostValues)
      difference.state.push_back({terms_.VariableName(terms_[variable].a), value});
  }
  return difference;
}

void RoutineVerifier::Decide() {
  LoadedSolver loaded = LoadSolver(terms_);
  if (loaded.solver == nullptr) {
    proof_.reason = loaded.reason;
    return;
  }
  std::vector<TermPair> pairs;
  for (const Question& question : questions_) pairs.push_back(question.pair);
  SweepLimits sweep;
  sweep.pair_ms = limits_.question_ms;
  sweep.total_ms = limits_.routine_ms;
  if (limits_.progress) {
    sweep.progress = [this](size_t done, size_t all) {
      limits_.progress(routine_.name + ": " + std::to_string(done) + " of " + std::to_string(all));
    };
  }
  pairs = MakeAlike(terms_, *loaded.solver, pairs, limits_.routine_ms / 2);
  for (const TermPair& pair : pairs) proof_.asked += pair.a != pair.b ? 1 : 0;
  const std::vector<Verdict> verdicts = Compare(terms_, *loaded.solver, pairs, sweep);
  proof_.result = ProofResult::kProved;
  for (size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i] == Verdict::kDifferent) {
      proof_.result = ProofResult::kDifferent;
      if (proof_.differences.size() < kMostDifferences)
        proof_.differences.push_back(Show(*loaded.solver, questions_[i]));
    } else if (verdicts[i] == Verdict::kUndecided && proof_.result == ProofResult::kProved) {
      proof_.result = ProofResult::kNotDecided;
      proof_.reason = "not within the time: " + questions_[i].what;
    }
  }
}

RoutineProof RoutineVerifier::Run() {
  proof_.routine = routine_.name;
  if (limits_.progress) limits_.progress(routine_.name);
  image_.MakeVariables(terms_);
  now_ = terms_.Variable("now", 32);
  hash_ = is_init() ? terms_.Const(image_.layout_hash(), 32) : image_.HashBefore(terms_);
  for (const ir::Parameter& parameter : routine_.parameters)
    arguments_.push_back(terms_.Variable("parameter " + parameter.name, WidthOf(parameter.type)));
  Memory memory(terms_, program_, cells_, MakeEnvironment());
  proof_.reason = Execute(memory, id_, arguments_);
  if (!proof_.reason.empty()) return std::move(proof_);
  const CodeOutcome outcome = ExecuteCode();
  proof_.instructions = outcome.instructions;
  proof_.reason = outcome.refusal;
  if (!proof_.reason.empty()) return std::move(proof_);
  Ask(memory, outcome);
  Decide();
  return std::move(proof_);
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
                                 std::span<const ir::RoutineId> routines, const VerifyLimits& limits) {
  std::vector<RoutineProof> proofs;
  for (const ir::RoutineId routine : routines)
    proofs.push_back(RoutineVerifier(emittable, code, limits, routine).Run());
  return proofs;
}

}  // namespace plcxx::prove
