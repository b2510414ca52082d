#include "transpiler/prove/compiled/verify.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "transpiler/prove/compiled/constant_arguments.h"
#include "transpiler/prove/compiled/host_surroundings.h"
#include "transpiler/prove/compiled/local_sweep.h"
#include "transpiler/prove/compiled/replaced_call.h"
#include "transpiler/prove/compiled/state_image.h"
#include "transpiler/prove/compiled/units.h"
#include "transpiler/prove/execute/execute.h"
#include "transpiler/prove/meaning/meaning.h"
#include "transpiler/prove/solver/solver.h"
#include "transpiler/prove/solver/sweep.h"

namespace plcxx::prove {
namespace {

constexpr size_t kMostDifferences = 8;
constexpr size_t kMostValues = 60;     // of a state that is shown
constexpr uint32_t kMostRounds = 512;  // of one loop; of init, where nothing is unknown, more
constexpr uint32_t kMostRoundsOfInit = 4096;

/// What all proofs of one program share.
struct Program {
  Program(const emit::Emittable& printed, CompiledCode& compiled, const VerifyLimits& given)
      : emittable(printed),
        ir(*printed.program),
        code(compiled),
        limits(given),
        cells(MakeCells(ir)),
        image(ir, printed.layout, cells),
        units(MakeUnits(printed, cells)),
        calls(units.all.size()) {}

  std::string CppName(const Unit& unit) const { return emittable.namespace_name + "::" + unit.name; }

  const emit::Emittable& emittable;
  const ir::Program& ir;
  CompiledCode& code;
  const VerifyLimits& limits;
  Cells cells;
  StateImage image;
  Units units;
  std::vector<std::unique_ptr<ReplacedCall>> calls;  // by UnitId: of those that are proved
};

/// The calls that are replaced while one function is executed, on either side.
class Replaced : public ReplacedParts {
 public:
  Replaced(const Program& program, Terms& terms, TermId hash, CallLog::Matching matching)
      : program_(program), hash_(hash), log_(terms, matching) {}

  std::optional<std::vector<CellChange>> Call(Memory& memory, ir::RoutineId routine) override {
    const ReplacedCall* call = Of(program_.units.of_routines[routine.index]);
    return call == nullptr ? std::nullopt : std::optional(call->OnCells(memory, hash_, log_));
  }
  std::optional<std::vector<CellChange>> Part(Memory& memory, ir::RegionId region, uint32_t& at) override {
    const UnitId unit = program_.units.At(program_.emittable, region, at);
    const ReplacedCall* call = Of(unit);
    if (call == nullptr) return std::nullopt;
    at = call->unit().part.end;
    return call->OnCells(memory, hash_, log_);
  }
  CallLog& log() { return log_; }
  const ReplacedCall* OfFunction(std::string_view name) const {
    const auto call = std::ranges::find_if(program_.calls, [&](const auto& one) {
      return one != nullptr && name.ends_with(one->unit().name) && program_.CppName(one->unit()) == name;
    });
    return call == program_.calls.end() ? nullptr : call->get();
  }

 private:
  const ReplacedCall* Of(UnitId unit) const { return unit.valid() ? program_.calls[unit.index].get() : nullptr; }

  const Program& program_;
  TermId hash_;
  CallLog log_;
};

/// The host, and the functions that are replaced.
class Surroundings : public HostSurroundings {
 public:
  Surroundings(Terms& terms, const Program& program, TermId now, Replaced* replaced,
               std::function<TermId(uint32_t slot)> initial)
      : HostSurroundings(terms, program.emittable, program.image, now, std::move(initial)),
        terms_(terms),
        replaced_(replaced) {}

  bool Replaces(std::string_view function) const override {
    return replaced_ != nullptr && replaced_->OfFunction(function) != nullptr;
  }
  TermId CallHost(CodeMemory& memory, const HostRequest& request, std::string& refusal) override {
    const ReplacedCall* call = replaced_ == nullptr ? nullptr : replaced_->OfFunction(request.function);
    if (call != nullptr) return call->OnCode(terms_, memory, request, replaced_->log(), refusal);
    return HostSurroundings::CallHost(memory, request, refusal);
  }

 private:
  Terms& terms_;
  Replaced* replaced_;
};

/// What is done with calls of functions that are proved; the first is the cheapest, the last finds differences.
enum class Callees : uint8_t { kReplacedInOrder, kReplacedByArguments, kFollowed };

/// One function: both executions, and their comparison.
class UnitVerifier {
 public:
  UnitVerifier(const Program& program, const Unit& unit, const ArgumentCase& given, Callees callees)
      : program_(program),
        unit_(unit),
        given_(given),
        callees_(callees),
        routine_(program.ir.routines[unit.part.routine]),
        image_(program.image) {}

  RoutineProof Run();
  /// Not decided, and looking into what it calls, or at it in its callers, would not help.
  bool gave_up() const { return gave_up_; }

 private:
  struct Question {
    std::string what;
    TermPair pair;  // the IR's, the code's
  };

  /// A chunk or subroutine: it works on its caller's locals.
  bool is_inner() const { return unit_.part.region.valid() || emit::SharesLocals(routine_.kind); }
  bool is_init() const { return !is_inner() && routine_.kind == ir::RoutineKind::kInit; }
  uint32_t locals_begin() const { return image_.size() + program_.ir.host_functions.size(); }
  Environment MakeEnvironment();
  void Observe(Memory& memory, ir::HostFunctionId function, TermId when);
  TermId InitialSlot(uint32_t slot);
  void MakeArguments();
  std::string ExecuteProgram(Memory& memory);
  CodeOutcome ExecuteCode();
  void Ask(Memory& memory, const CodeOutcome& outcome);
  void Decide();
  CodeDifference Show(Solver& solver, const Question& question);
  std::vector<TermId> VariablesOf(const TermPair& pair) const;

  const Program& program_;
  const Unit& unit_;
  const ArgumentCase& given_;
  Callees callees_;
  const ir::Routine& routine_;
  StateImage image_;
  Terms terms_;
  TermId now_, hash_;
  std::vector<CodeArgument> arguments_;
  std::vector<TermId> values_, references_;  // of the arguments, in the unit's order
  std::vector<uint32_t> slots_;              // of the references
  std::vector<TermId> local_bytes_;
  std::unique_ptr<Replaced> replaced_;
  std::vector<Question> questions_;
  RoutineProof proof_;
  bool gave_up_ = false;
};

Environment UnitVerifier::MakeEnvironment() {
  Environment environment;
  environment.now = now_;
  environment.most_rounds = is_init() ? kMostRoundsOfInit : kMostRounds;
  environment.replaced = replaced_.get();
  environment.initial = [this](CellId cell) {
    const bool power_on = is_init() && CellAt(program_.ir, program_.cells, cell).kind != CellKind::kCalls;
    return power_on ? image_.CellAtPowerOn(terms_, cell) : image_.CellBefore(terms_, cell);
  };
  environment.observe = [this](Memory& memory, ir::HostFunctionId function, TermId when) {
    Observe(memory, function, when);
  };
  return environment;
}

void UnitVerifier::Observe(Memory& memory, ir::HostFunctionId function, TermId when) {
  const ir::HostFunction& host = program_.ir.host_functions[function];
  const bool retentive = host.access == ir::HostAccess::kReadsRetentive;
  const uint32_t begin = retentive ? image_.retentive_begin() : 0;
  const uint32_t end = retentive ? image_.retentive_end() : image_.size();
  std::vector<TermId> bytes;
  for (uint32_t at = begin; at < end; ++at) {
    if (image_[at].kind == ByteKind::kNothing) continue;
    bytes.push_back(image_.ByteFor(terms_, at, [&memory](CellId cell) { return memory.Read(cell); }, hash_));
  }
  const CellId counter = program_.cells.OfCalls(function);
  const TermId calls = memory.Read(counter);
  memory.Write(counter, terms_.Ite(when, HavingSeen(terms_, host.name, calls, bytes), calls));
}

TermId UnitVerifier::InitialSlot(uint32_t slot) {
  if (slot >= locals_begin()) return local_bytes_[slot - locals_begin()];
  if (slot >= image_.size())
    return image_.CellBefore(terms_, program_.cells.OfCalls(ir::HostFunctionId(slot - image_.size())));
  // Before init the memory may hold anything.
  return is_init() ? terms_.Variable("State byte " + std::to_string(slot), 8) : image_.ByteBefore(terms_, slot);
}

void UnitVerifier::MakeArguments() {
  const auto variable = [this](ir::PlaceId id) {
    return terms_.Variable(program_.emittable.place_names[id.index], WidthOf(program_.ir.places[id].type));
  };
  arguments_.push_back({.kind = CodeArgument::Kind::kState, .name = "m", .value = {}});
  for (size_t i = 0; i < unit_.values.size(); ++i) {
    const ir::PlaceId id = unit_.values[i];
    values_.push_back(given_[i] ? terms_.Const(*given_[i], WidthOf(program_.ir.places[id].type)) : variable(id));
    arguments_.push_back({.name = program_.emittable.place_names[id.index], .value = values_.back()});
  }
  for (const ir::PlaceId id : unit_.references) {
    references_.push_back(variable(id));
    slots_.push_back(locals_begin() + static_cast<uint32_t>(local_bytes_.size()));
    const uint32_t bytes = ir::Bytes(program_.ir.places[id].type);
    const TermId wide = terms_.Zext(references_.back(), static_cast<uint8_t>(8 * bytes));
    for (uint32_t i = 0; i < bytes; ++i) local_bytes_.push_back(terms_.Extract(wide, static_cast<uint8_t>(8 * i), 8));
    arguments_.push_back({.kind = CodeArgument::Kind::kMemory,
                          .name = program_.emittable.place_names[id.index],
                          .value = {},
                          .slot = slots_.back(),
                          .bytes = bytes});
  }
  arguments_.push_back({.kind = CodeArgument::Kind::kHost, .name = "host", .value = {}});
}

std::string UnitVerifier::ExecuteProgram(Memory& memory) {
  if (!is_inner()) return Execute(memory, unit_.part.routine, values_);
  for (size_t i = 0; i < values_.size(); ++i) memory.WritePlace(program_.ir.places[unit_.values[i]], values_[i]);
  for (size_t i = 0; i < references_.size(); ++i)
    memory.WritePlace(program_.ir.places[unit_.references[i]], references_[i]);
  return ExecutePart(memory, unit_.part);
}

CodeOutcome UnitVerifier::ExecuteCode() {
  Surroundings surroundings(terms_, program_, now_, replaced_.get(),
                            [this](uint32_t slot) { return InitialSlot(slot); });
  CodeRun run;
  run.function = program_.CppName(unit_);
  run.state_bytes = image_.size();
  run.further_slots = program_.ir.host_functions.size() + static_cast<uint32_t>(local_bytes_.size());
  run.arguments = arguments_;
  run.most_rounds = is_init() ? kMostRoundsOfInit : kMostRounds;
  return program_.code.Execute(terms_, surroundings, run);
}

void UnitVerifier::Ask(Memory& memory, const CodeOutcome& outcome) {
  const auto cell = [&memory](CellId id) { return memory.Read(id); };
  for (uint32_t at = 0; at < image_.size(); ++at) {
    if (image_[at].kind == ByteKind::kNothing) continue;
    questions_.push_back({image_.NameOf(at), {image_.ByteFor(terms_, at, cell, hash_), outcome.slots[at]}});
    ++proof_.bytes;
  }
  for (uint32_t i = 0; i < program_.ir.host_functions.size(); ++i) {
    const ir::HostFunctionId host(i);
    if (!program_.emittable.host_used[i] || host == program_.ir.schedule.now) continue;
    questions_.push_back({"calls of " + program_.ir.host_functions[host].name,
                          {memory.Read(program_.cells.OfCalls(host)), outcome.slots[image_.size() + i]}});
    ++proof_.host_functions;
  }
  for (size_t i = 0; i < references_.size(); ++i) {
    const ir::PlaceId id = unit_.references[i];
    const TermId value = memory.ReadPlace(program_.ir.places[id]);
    const uint32_t bytes = ir::Bytes(program_.ir.places[id].type);
    const TermId wide = terms_.Zext(value, static_cast<uint8_t>(8 * bytes));
    for (uint32_t k = 0; k < bytes; ++k)
      questions_.push_back({program_.emittable.place_names[id.index],
                            {terms_.Extract(wide, static_cast<uint8_t>(8 * k), 8), outcome.slots[slots_[i] + k]}});
  }
  if (unit_.result.valid() && outcome.result.valid()) {
    questions_.push_back({"the result", {memory.ReadPlace(program_.ir.places[unit_.result]), outcome.result}});
  }
  if (replaced_ != nullptr) {
    for (const CallLog::Claim& claim : replaced_->log().claims())
      questions_.push_back({"what " + claim.call->unit().name + " is called with", {claim.program, claim.code}});
  }
  for (const Obligation& obligation : outcome.obligations) {
    questions_.push_back({obligation.text, {terms_.Bit(false), obligation.never}});
    ++proof_.obligations;
  }
}

std::vector<TermId> UnitVerifier::VariablesOf(const TermPair& pair) const {
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

CodeDifference UnitVerifier::Show(Solver& solver, const Question& question) {
  CodeDifference difference{.what = question.what};
  const TermId differ = terms_.Ne(question.pair.a, question.pair.b);
  if (solver.Check({&differ, 1}, program_.limits.question_ms) != Answer::kPossible) return difference;
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

void UnitVerifier::Decide() {
  LoadedSolver loaded = LoadSolver(terms_);
  if (loaded.solver == nullptr) {
    proof_.reason = loaded.reason;
    return;
  }
  std::vector<TermPair> pairs;
  for (const Question& question : questions_) pairs.push_back(question.pair);
  SweepLimits sweep;
  sweep.pair_ms = program_.limits.question_ms;
  sweep.total_ms = program_.limits.routine_ms;
  if (program_.limits.progress) {
    sweep.progress = [this](size_t done, size_t all) {
      program_.limits.progress(unit_.name + ": " + std::to_string(done) + " of " + std::to_string(all));
    };
  }
  pairs = MakeAlike(terms_, *loaded.solver, pairs, program_.limits.routine_ms / 2);
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

RoutineProof UnitVerifier::Run() {
  proof_.routine = is_inner() ? unit_.name : routine_.name;
  proof_.exported = !is_inner();
  if (program_.limits.progress) program_.limits.progress(proof_.routine);
  image_.MakeVariables(terms_);
  now_ = terms_.Variable("now", 32);
  hash_ = is_init() ? terms_.Const(image_.layout_hash(), 32) : image_.HashBefore(terms_);
  if (callees_ != Callees::kFollowed) {
    const bool in_order = callees_ == Callees::kReplacedInOrder;
    replaced_ = std::make_unique<Replaced>(program_, terms_, hash_,
                                           in_order ? CallLog::Matching::kByOrder : CallLog::Matching::kByArguments);
  }
  MakeArguments();
  Memory memory(terms_, program_.ir, program_.cells, MakeEnvironment());
  proof_.reason = ExecuteProgram(memory);
  gave_up_ = !proof_.reason.empty();
  if (gave_up_) return std::move(proof_);
  const CodeOutcome outcome = ExecuteCode();
  proof_.instructions = outcome.instructions;
  proof_.reason = outcome.refusal;
  if (!proof_.reason.empty()) return std::move(proof_);
  Ask(memory, outcome);
  Decide();
  gave_up_ = proof_.result == ProofResult::kNotDecided;
  return std::move(proof_);
}

/// Both are proofs of one function, each for other arguments.
void Add(RoutineProof& all, RoutineProof one) {
  // What differs says more than what is not decided.
  const auto weight = [](ProofResult result) {
    return result == ProofResult::kDifferent ? 2 : result == ProofResult::kNotDecided ? 1 : 0;
  };
  if (weight(one.result) > weight(all.result)) {
    all.result = one.result;
    all.reason = std::move(one.reason);
    all.differences = std::move(one.differences);
  }
  all.obligations += one.obligations;
  all.instructions += one.instructions;
  all.asked += one.asked;
}

/// All functions of a program, callees first.
class Verification {
 public:
  Verification(const emit::Emittable& emittable, CompiledCode& code, const VerifyLimits& limits)
      : program_(emittable, code, limits), visited_(program_.units.all.size()), open_(program_.units.all.size()) {}

  void ProveRoutine(ir::RoutineId routine) { Prove(program_.units.of_routines[routine.index]); }
  std::vector<RoutineProof> TakeProofs() { return std::move(proofs_); }

 private:
  /// What the proof of a function takes for granted.
  struct Granted {
    std::vector<std::string> functions;
    std::set<std::string> open;  // of these, and of what they call, those that are not decided
  };

  void Prove(UnitId id);
  RoutineProof ProveCases(const Unit& unit, Callees callees, bool& gave_up) const;
  /// Of calls that are replaced, also in functions that are followed.
  void Collect(const Unit& unit, Granted& granted) const;

  Program program_;
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

RoutineProof Verification::ProveCases(const Unit& unit, Callees callees, bool& gave_up) const {
  RoutineProof all;
  gave_up = false;
  bool first = true;
  for (const ArgumentCase& given : ArgumentCases(program_.ir, unit)) {
    UnitVerifier verifier(program_, unit, given, callees);
    RoutineProof one = verifier.Run();
    gave_up = gave_up || verifier.gave_up();
    if (std::exchange(first, false)) {
      all = std::move(one);
    } else {
      Add(all, std::move(one));
    }
    if (all.result != ProofResult::kProved) break;
  }
  return all;
}

void Verification::Prove(UnitId id) {
  if (!id.valid() || visited_[id.index]) return;
  visited_[id.index] = true;
  const Unit& unit = program_.units[id];
  for (const UnitId callee : unit.callees) Prove(callee);
  const bool inner = unit.part.region.valid() || emit::SharesLocals(program_.ir.routines[unit.part.routine].kind);
  const auto parameters = program_.code.Parameters(program_.CppName(unit));
  // What the compiler has put into its callers is proved there.
  if (inner && !parameters) return;
  Granted granted;
  Collect(unit, granted);
  RoutineProof proof;
  std::optional<RoutineProof> but_for_open;
  bool gave_up = false;
  for (const Callees callees : {Callees::kReplacedInOrder, Callees::kReplacedByArguments, Callees::kFollowed}) {
    // What is not so for unknown functions may be so for these: only who follows calls finds differences.
    const bool followed = callees == Callees::kFollowed;
    if (!followed && (granted.functions.empty() || but_for_open)) continue;
    proof = ProveCases(unit, callees, gave_up);
    if (proof.result == ProofResult::kProved) {
      if (!followed) proof.relies_on = granted.functions;
      if (followed) granted.open.clear();
      if (granted.open.empty()) break;
      but_for_open = proof;
    } else if (gave_up && granted.open.empty()) {
      break;
    }
  }
  if (proof.result == ProofResult::kNotDecided && but_for_open) {
    proof = std::move(*but_for_open);
    gave_up = false;
    proof.result = ProofResult::kNotDecided;
    proof.reason = "all is proved but";
    for (const std::string& name : granted.open) proof.reason += (name == *granted.open.begin() ? " " : ", ") + name;
  } else if (gave_up) {
    granted.open.insert(unit.name);
  }
  const bool takes_over = proof.result != ProofResult::kDifferent && (gave_up || proof.reason.empty() || but_for_open);
  const bool init = !inner && program_.ir.routines[unit.part.routine].kind == ir::RoutineKind::kInit;
  if (takes_over && !init && parameters) {
    auto call = std::make_unique<ReplacedCall>(program_.emittable, program_.cells, program_.image, unit, *parameters);
    if (!call->is_opaque()) {
      program_.calls[id.index] = std::move(call);
      open_[id.index] = std::move(granted.open);
    }
  }
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
                                 std::span<const ir::RoutineId> routines, const VerifyLimits& limits) {
  Verification verification(emittable, code, limits);
  for (const ir::RoutineId routine : routines) verification.ProveRoutine(routine);
  return verification.TakeProofs();
}

}  // namespace plcxx::prove
