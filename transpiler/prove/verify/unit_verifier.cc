#include "transpiler/prove/verify/unit_verifier.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "transpiler/ir/items.h"
#include "transpiler/prove/verify/local_sweep.h"
#include "transpiler/prove/verify/operand_pairs.h"
#include "transpiler/symbolic/meaning/meaning.h"
#include "transpiler/symbolic/solver/model.h"
#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/intervals.h"
#include "transpiler/symbolic/terms/samples.h"

namespace plcxx::prove::verify {
namespace {

constexpr size_t kMostDifferences = 8;
constexpr size_t kMostShown = 64;  // questions that are looked at for numbers that differ
constexpr uint32_t kSamplesOfDifference = 256;
constexpr size_t kMostValues = 60;      // of a state that is shown
constexpr uint32_t kMostRounds = 512;   // of one loop; of init, where nothing is unknown, more
constexpr uint32_t kFewRounds = 8;      // where calls are replaced in order, and loops are not by heads
constexpr uint32_t kMostUnrolled = 32;  // where that is tried after all else
constexpr uint32_t kMostRoundsOfInit = 4096;
constexpr uint32_t kBranchMs = 200;   // for a question about the ways to calls
constexpr uint32_t kQuickShare = 10;  // of the time
constexpr uint32_t kMostQuickMs = 400;
constexpr uint32_t kGlanceMs = 1000;        // for each of two ways to look at what is left
constexpr uint32_t kMostTerms = 4'000'000;  // of one side

}  // namespace

execute::Environment UnitVerifier::MakeEnvironment(solver::Solver& solver) {
  execute::Environment environment;
  environment.now = now_;
  environment.most_rounds = MostRounds();
  environment.replaced = replaced_.get();
  environment.most_terms = kMostTerms;
  if (treatment_.loops != Loops::kUnrolled || program_.shape.IsUpToFaults()) environment.loops = &policy_;
  environment.never_holds = [this, &solver](ir::InstId, terms::TermId condition) {
    return NeverHolds(solver, condition);
  };
  environment.initial = [this](execute::CellId cell) {
    const bool power_on =
        is_init() && execute::CellAt(program_.ir, program_.cells, cell).kind != execute::CellKind::kCalls;
    return power_on ? image_.CellAtPowerOn(terms_, cell) : CellBefore(cell);
  };
  environment.stored = [this](execute::CellId id) {
    const execute::Cell cell = execute::CellAt(program_.ir, program_.cells, id);
    return terms_.Extract(StoredByte(terms_, program_.ir.spaces[cell.space].name, cell.offset), cell.bit, 1);
  };
  // What either side has written into the inputs stays there where the host does not write it again.
  environment.may_be_left = [](execute::CellId) { return true; };
  environment.observe = [this](execute::Memory& memory, ir::HostFunctionId function, terms::TermId when) {
    Observe(memory, function, when);
  };
  return environment;
}

bool UnitVerifier::NeverHolds(solver::Solver& solver, terms::TermId condition) const {
  return terms_.IsFalse(condition) ||
         (!terms_.IsTrue(condition) &&
          solver.Check({&condition, 1}, workplace_.deadline.LimitFor(kBranchMs)) == solver::Answer::kNever);
}

void UnitVerifier::Observe(execute::Memory& memory, ir::HostFunctionId function, terms::TermId when) {
  const ir::HostFunction& host = program_.ir.host_functions[function];
  const bool retentive = host.access == ir::HostAccess::kReadsRetentive;
  if (!retentive && !MayReadState(host.access, program_.shape.passes)) return;
  const uint32_t begin = retentive ? image_.retentive_begin() : 0;
  const uint32_t end = retentive ? image_.retentive_end() : image_.size();
  std::vector<terms::TermId> bytes;
  for (uint32_t at = begin; at < end; ++at) {
    if (image_[at].kind == ByteKind::kNothing) continue;
    bytes.push_back(image_.ByteFor(terms_, at, [&memory](execute::CellId cell) { return memory.Read(cell); }, hash_));
  }
  const execute::CellId counter = program_.cells.OfCalls(function);
  const terms::TermId calls = memory.Read(counter);
  memory.Write(counter, terms_.Ite(when, HavingSeen(terms_, host.name, calls, bytes), calls));
}

terms::TermId UnitVerifier::InitialSlot(uint32_t slot) {
  if (slot >= locals_begin()) return local_bytes_[slot - locals_begin()];
  if (slot >= image_.size())
    return image_.CellBefore(terms_, execute::CellId(program_.cells.calls + slot - image_.size()));
  // Before init the memory may hold anything.
  if (is_init()) return terms_.Variable("State byte " + std::to_string(slot), 8);
  if (image_[slot].kind == ByteKind::kNothing) return image_.ByteBefore(terms_, slot);
  return image_.ByteFor(
      terms_, slot, [this](execute::CellId cell) { return CellBefore(cell); }, image_.HashBefore(terms_));
}

terms::TermId UnitVerifier::CellBefore(execute::CellId id) {
  const execute::Cell cell = execute::CellAt(program_.ir, program_.cells, id);
  const auto& constant_bytes = program_.shape.is_constant;
  const bool constant = cell.kind == execute::CellKind::kBit && cell.space.index < constant_bytes.size() &&
                        cell.offset < constant_bytes[cell.space.index].size() &&
                        constant_bytes[cell.space.index][cell.offset];
  return constant ? image_.CellAtPowerOn(terms_, id) : image_.CellBefore(terms_, id);
}

bool UnitVerifier::IsDead(uint32_t slot) const {
  const auto& dead = program_.shape.dead_behind;
  if (unit_.part.routine.index >= dead.size()) return false;
  return std::ranges::any_of(dead[unit_.part.routine.index],
                             [slot](const auto& range) { return range.first <= slot && slot < range.second; });
}

void UnitVerifier::NoteFault(terms::TermId when, terms::TermId code) {
  faulted_ = terms_.Or(faulted_, when);
  const bool open = terms_.IsConst(code) && std::ranges::find(program_.shape.open_faults, terms_.Value(code)) !=
                                                program_.shape.open_faults.end();
  if (open) open_faults_ = terms_.Or(open_faults_, when);
  if (relation_ != nullptr) relation_->Assume(terms_.Not(when));
}

void UnitVerifier::MakeArguments() {
  const auto variable = [this](ir::PlaceId id) {
    return terms_.Variable(program_.emittable.place_names[id.index], meaning::WidthOf(program_.ir.places[id].type));
  };
  const bool passes_state = program_.shape.passes == Passes::kStateAndHost;
  if (passes_state) arguments_.push_back({.kind = CodeArgument::Kind::kState, .name = "m", .value = {}});
  for (size_t i = 0; i < unit_.values.size(); ++i) {
    const ir::PlaceId id = unit_.values[i];
    values_.push_back(given_[i] ? terms_.Const(*given_[i], meaning::WidthOf(program_.ir.places[id].type))
                                : variable(id));
    arguments_.push_back({.name = program_.emittable.place_names[id.index], .value = values_.back()});
  }
  for (const ir::PlaceId id : unit_.references) {
    references_.push_back(variable(id));
    slots_.push_back(locals_begin() + static_cast<uint32_t>(local_bytes_.size()));
    const uint32_t bytes = ir::Bytes(program_.ir.places[id].type);
    const terms::TermId wide = terms_.Zext(references_.back(), static_cast<uint8_t>(8 * bytes));
    for (uint32_t i = 0; i < bytes; ++i) local_bytes_.push_back(terms_.Extract(wide, static_cast<uint8_t>(8 * i), 8));
    arguments_.push_back({.kind = CodeArgument::Kind::kMemory,
                          .name = program_.emittable.place_names[id.index],
                          .value = {},
                          .slot = slots_.back(),
                          .bytes = bytes});
  }
  if (passes_state) arguments_.push_back({.kind = CodeArgument::Kind::kHost, .name = "host", .value = {}});
}

/// Callers of a unit that is proved believe its footprint: what is missing there would be lost in them.
void UnitVerifier::CheckFootprint(const execute::Memory& memory) const {
  const std::vector<bool>& known = unit_.footprint.written;
  for (uint32_t i = 0; i < program_.cells.count; ++i) {
    if (!memory.IsWritten(execute::CellId(i)) || known[i]) continue;
    const execute::Cell cell = execute::CellAt(program_.ir, program_.cells, execute::CellId(i));
    PLCXX_CHECK(cell.kind == execute::CellKind::kBit);
    // Calls that are replaced give whole bytes.
    const auto byte = known.begin() + program_.cells.OfBit(cell.space, cell.offset, 0).index;
    PLCXX_CHECK(std::find(byte, byte + 8, true) != byte + 8 ||
                program_.ir.spaces[cell.space].lifetime == ir::Lifetime::kRoutine);
  }
}

std::string UnitVerifier::ExecuteProgram(execute::Memory& memory) {
  if (!is_inner()) return execute::Execute(memory, unit_.part.routine, values_);
  for (size_t i = 0; i < values_.size(); ++i) memory.WritePlace(program_.ir.places[unit_.values[i]], values_[i]);
  for (size_t i = 0; i < references_.size(); ++i)
    memory.WritePlace(program_.ir.places[unit_.references[i]], references_[i]);
  return execute::ExecutePart(memory, unit_.part);
}

CodeOutcome UnitVerifier::ExecuteCode(solver::Solver& solver) {
  UnitEnvironment environment(
      terms_, program_, now_, replaced_.get(), relation_.get(), [this](uint32_t slot) { return InitialSlot(slot); },
      [&](terms::TermId condition) { return NeverHolds(solver, condition); });
  CodeRun run;
  run.function = program_.CppName(unit_);
  run.state_bytes = image_.size();
  run.further_slots = program_.cells.CallCells() + static_cast<uint32_t>(local_bytes_.size());
  run.arguments = arguments_;
  run.most_terms = kMostTerms;
  run.most_rounds = MostRounds();
  if (treatment_.loops != Loops::kUnrolled) {
    run.loops = relation_ != nullptr ? CodeRun::Loops::kAtHeads : CodeRun::Loops::kFirstRounds;
    run.rounds = policy_.rounds;
  } else if (program_.shape.IsUpToFaults()) {
    // What goes round more often has to be shown to be no execution without a fault.
    run.loops = CodeRun::Loops::kFirstRounds;
    run.rounds = policy_.rounds;
  }
  run.globals = program_.shape.globals;
  if (program_.shape.passes == Passes::kNothing) run.language = CodeRun::Language::kSource;
  return workplace_.code.Execute(terms_, environment, run);
}

/// A fault of which C knows nothing must not be recorded: what comes after it is not compared.
void UnitVerifier::AskAboutFaults(const CodeOutcome& outcome, terms::TermId given) {
  const bool calls_control =
      std::ranges::any_of(unit_.callees, [this](UnitId callee) { return program_.unknown[callee.index] != nullptr; });
  const bool by_heads = relation_ != nullptr && has_loops_;
  if (terms_.IsFalse(open_faults_) || calls_control || by_heads) return;
  terms::TermId undefined = terms_.Bit(false);
  for (const Obligation& obligation : outcome.obligations) undefined = terms_.Or(undefined, obligation.never);
  questions_.push_back({.what = "a fault where C has none",
                        .pair = {terms_.And(open_faults_, terms_.Not(undefined)), terms_.Bit(false)},
                        .given = given,
                        .guess = {}});
}

/// The host tells calls apart by each of what it is told: asked one by one these questions are small, and many alike.
void UnitVerifier::AskAboutCalls(const std::string& what, terms::TermId given, const solver::TermPair& calls) {
  std::vector<solver::TermPair> open = {calls};
  // What a later call is told holds what the earlier ones were: without this set each of them is met on every way.
  std::set<std::pair<uint32_t, uint32_t>> seen;
  while (!open.empty()) {
    const solver::TermPair pair = open.back();
    open.pop_back();
    if (!seen.emplace(pair.a.index, pair.b.index).second) continue;
    const terms::Term& a = terms_[pair.a];
    const terms::Term& b = terms_[pair.b];
    const bool alike = a.kind == terms::TermKind::kApply && b.kind == a.kind && a.a == b.a && a.c == b.c;
    if (!alike || pair.a == pair.b) {
      questions_.push_back({.what = what, .pair = pair, .given = given, .guess = {}});
      continue;
    }
    for (size_t i = 0; i < a.c; ++i) {
      const solver::TermPair told{terms_.Arguments(a)[i], terms_.Arguments(b)[i]};
      if (told.a != told.b) open.push_back(told);
    }
  }
}

void UnitVerifier::Ask(execute::Memory& memory, const CodeOutcome& outcome) {
  const auto cell = [&memory](execute::CellId id) { return memory.Read(id); };
  const terms::TermId given = GivenAtEnd(outcome);
  const auto ask = [&](std::string what, terms::TermId program, terms::TermId code) {
    questions_.push_back({.what = std::move(what), .pair = {program, code}, .given = given, .guess = {}});
  };
  if (program_.shape.IsUpToFaults() && relation_ == nullptr && has_loops_) {
    questions_.push_back({.what = "rounds of a loop",
                          .pair = {terms_.Bit(false), terms_.And(LeftOut(outcome), terms_.Not(faulted_))},
                          .given = {},
                          .guess = {},
                          .of = Question::Of::kLeftOut});
  }
  AskAboutFaults(outcome, has_loops_ && relation_ == nullptr ? terms_.Not(LeftOut(outcome)) : terms::TermId());
  for (uint32_t at = 0; at < image_.size(); ++at) {
    if (image_[at].kind == ByteKind::kNothing || IsDead(at)) continue;
    ask(image_.NameOf(at), image_.ByteFor(terms_, at, cell, hash_), outcome.slots[at]);
    ++proof_.bytes;
  }
  for (uint32_t i = 0; i < program_.ir.host_functions.size(); ++i) {
    const ir::HostFunctionId host(i);
    if (!program_.emittable.host_used[i] || host == program_.ir.schedule.now) continue;
    AskAboutCalls("calls of " + program_.ir.host_functions[host].name, given,
                  {memory.Read(program_.cells.OfCalls(host)), outcome.slots[image_.size() + i]});
    ++proof_.host_functions;
  }
  for (const execute::CellId chain : {program_.cells.OfOrder(), program_.cells.OfActions()})
    AskAboutCalls("order of calls", given,
                  {memory.Read(chain), outcome.slots[image_.size() + chain.index - program_.cells.calls]});
  for (size_t i = 0; i < references_.size(); ++i) {
    const ir::PlaceId id = unit_.references[i];
    const terms::TermId value = memory.ReadPlace(program_.ir.places[id]);
    const uint32_t bytes = ir::Bytes(program_.ir.places[id].type);
    const terms::TermId wide = terms_.Zext(value, static_cast<uint8_t>(8 * bytes));
    for (uint32_t k = 0; k < bytes; ++k)
      ask(program_.emittable.place_names[id.index], terms_.Extract(wide, static_cast<uint8_t>(8 * k), 8),
          outcome.slots[slots_[i] + k]);
  }
  if (unit_.result.valid() && outcome.result.valid()) {
    ask("the result", memory.ReadPlace(program_.ir.places[unit_.result]), outcome.result);
  }
  if (replaced_ != nullptr) {
    for (const CallLog::Claim& claim : replaced_->log().claims())
      ask("what " + claim.call->unit().name + " is called with", claim.program, claim.code);
  }
  for (const Obligation& obligation : outcome.obligations) {
    const bool all = treatment_.loops == Loops::kFirstRounds || !obligation.given.valid();
    const terms::TermId there = all ? given : terms_.And(obligation.given, terms_.Not(faulted_));
    questions_.push_back({.what = obligation.text,
                          .pair = {terms_.Bit(false), obligation.never},
                          .given = there,
                          .guess = {},
                          .of = Question::Of::kObligation});
    ++proof_.obligations;
  }
}

std::vector<terms::TermId> UnitVerifier::VariablesOf(const solver::TermPair& pair) const {
  std::vector<bool> seen(terms_.size());
  std::vector<terms::TermId> open = {pair.a, pair.b}, variables;
  while (!open.empty()) {
    const terms::TermId id = open.back();
    open.pop_back();
    if (seen[id.index]) continue;
    seen[id.index] = true;
    if (terms_[id].kind == terms::TermKind::kVariable) variables.push_back(id);
    terms_.ForEachOperand(terms_[id], [&open](terms::TermId operand) { open.push_back(operand); });
  }
  std::ranges::sort(variables);
  return variables;
}

uint32_t UnitVerifier::MostRounds() const {
  if (is_init()) return kMostRoundsOfInit;
  return treatment_.loops == Loops::kUnrolled && !program_.shape.IsUpToFaults() ? kMostUnrolled : kMostRounds;
}

terms::TermId UnitVerifier::LeftOut(const CodeOutcome& outcome) {
  return terms_.Or(policy_.left_out, outcome.left_out);
}

terms::TermId UnitVerifier::GivenAtEnd(const CodeOutcome& outcome) {
  terms::TermId given;
  if (has_loops_) given = relation_ != nullptr ? relation_->Given() : terms_.Not(LeftOut(outcome));
  if (terms_.IsFalse(faulted_)) return given;
  const terms::TermId goes_on = terms_.Not(faulted_);
  return given.valid() ? terms_.And(given, goes_on) : goes_on;
}

solver::TermPair UnitVerifier::Where(terms::TermId given, const solver::TermPair& pair) {
  if (!given.valid()) return pair;
  const terms::TermId none = terms_.Const(0, terms_.Width(pair.a));
  return {terms_.Ite(given, pair.a, none), terms_.Ite(given, pair.b, none)};
}

solver::TermPair UnitVerifier::Asked(const Question& question) { return Where(question.given, question.pair); }

CodeDifference UnitVerifier::Show(solver::Solver& solver, const Question& question) {
  CodeDifference difference{.what = question.what};
  const solver::TermPair asked = Asked(question);
  const std::vector<terms::TermId> variables = VariablesOf(asked);
  const auto show = [&](uint64_t expected, uint64_t compiled, auto&& value_of) {
    difference.has_values = true;
    difference.expected = expected;
    difference.compiled = compiled;
    for (size_t i = 0; i < variables.size() && difference.state.size() < kMostValues; ++i) {
      const uint64_t value = value_of(i);
      if (value != 0) difference.state.push_back({terms_.VariableName(terms_[variables[i]].a), value});
    }
    return difference;
  };
  const terms::TermId differ = terms_.Ne(asked.a, asked.b);
  if (solver.Check({&differ, 1}, workplace_.deadline.LimitFor(program_.limits.question_ms)) ==
      solver::Answer::kPossible) {
    const std::array roots = {differ, question.pair.a, question.pair.b};
    const std::vector<uint64_t> values = solver::ModelValues(terms_, solver, terms::ConeOf(terms_, roots));
    if (values[differ.index] != 0) {
      return show(values[question.pair.a.index], values[question.pair.b.index],
                  [&](size_t i) { return values[variables[i].index]; });
    }
  }
  // The solver made up results of functions that it does not know. With other numbers the two may differ all the same.
  std::vector<terms::TermId> roots = {differ, question.pair.a, question.pair.b};
  roots.insert(roots.end(), variables.begin(), variables.end());
  for (const std::vector<uint64_t>& values : terms::SampleValues(terms_, roots, kSamplesOfDifference))
    if (values[0] != 0) return show(values[1], values[2], [&](size_t i) { return values[3 + i]; });
  return difference;
}

bool UnitVerifier::HaveEqualOperands(solver::Solver& solver, const Question& question,
                                     const solver::SweepLimits& limits) {
  const terms::TermId given = question.given.valid() ? question.given : terms_.Bit(true);
  for (const Choices choices : {Choices::kAsked, Choices::kTakenApart}) {
    std::vector<solver::TermPair> pairs;
    for (const PairWhere& operands : OperandPairs(terms_, {question.pair, given}, choices))
      pairs.push_back(Where(operands.given, operands.pair));
    if (pairs.empty()) continue;
    const std::vector<solver::Verdict> verdicts = solver::Compare(terms_, solver, pairs, limits);
    if (std::ranges::all_of(verdicts, [](solver::Verdict one) { return one == solver::Verdict::kEqual; })) return true;
  }
  return false;
}

std::vector<solver::Verdict> UnitVerifier::Compare(solver::Solver& solver, std::span<const Question> questions) {
  std::vector<solver::TermPair> pairs;
  for (const Question& question : questions) pairs.push_back(Asked(question));
  solver::SweepLimits sweep;
  sweep.pair_ms = program_.limits.question_ms;
  sweep.total_ms = workplace_.deadline.RestMs();
  sweep.clock = solver::Clock::kProcessor;
  sweep.answered = &workplace_.answered;
  if (program_.limits.progress) {
    sweep.progress = [this](size_t done, size_t all) {
      program_.limits.progress(unit_.name + ": " + std::to_string(done) + " of " + std::to_string(all));
    };
  }
  // Most are decided soon as they are. What is left has been rewritten more: both sides are made alike first.
  solver::SweepLimits quick = sweep;
  quick.total_ms = std::min<uint64_t>(sweep.total_ms / kQuickShare, kMostQuickMs);
  quick.pair_ms = sweep.pair_ms / kQuickShare;
  quick.progress = {};
  std::vector<solver::Verdict> verdicts = solver::Compare(terms_, solver, pairs, quick);
  std::vector<size_t> open;
  for (size_t i = 0; i < pairs.size(); ++i) {
    proof_.asked += pairs[i].a != pairs[i].b ? 1 : 0;
    if (verdicts[i] == solver::Verdict::kUndecided) open.push_back(i);
  }
  const solver::Deadline some(solver::Clock::kProcessor, workplace_.deadline.RestMs() / kQuickShare);
  std::erase_if(open, [&](size_t i) {
    const bool are_equal = !some.IsOver() && HaveEqualOperands(solver, questions[i], quick);
    if (are_equal) verdicts[i] = solver::Verdict::kEqual;
    return are_equal;
  });
  if (open.empty()) return verdicts;
  std::vector<solver::TermPair> rest;
  for (const size_t i : open) rest.push_back(pairs[i]);
  const uint64_t most_ms = treatment_.is_glance ? kGlanceMs : workplace_.deadline.RestMs();
  rest = MakeAlike(terms_, solver, rest, std::min(workplace_.deadline.RestMs() / 2, most_ms), workplace_.answered);
  sweep.total_ms = std::min(workplace_.deadline.RestMs(), most_ms);
  const std::vector<solver::Verdict> later = solver::Compare(terms_, solver, rest, sweep);
  for (size_t k = 0; k < open.size(); ++k) verdicts[open[k]] = later[k];
  return verdicts;
}

bool UnitVerifier::DecideLoops(solver::Solver& solver) {
  std::vector<Question> questions;
  for (const LoopClaim& claim : relation_->claims())
    questions.push_back({.what = claim.what, .pair = claim.pair, .given = claim.given, .guess = claim.guess});
  proof_.claims = questions.size();
  const std::vector<solver::Verdict> verdicts = Compare(solver, questions);
  Blame least = Blame::kMemory;
  const LoopClaim* refuted = nullptr;  // the first of refuted_
  for (size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i] == solver::Verdict::kEqual) continue;
    const LoopClaim& claim = relation_->claims()[i];
    if (!claim.guess.empty()) {
      if (claim.blame < least) refuted_.clear();
      least = std::min(least, claim.blame);
      if (refuted_.empty()) refuted = &claim;
      if (claim.blame == least && std::ranges::find(refuted_, claim.guess) == refuted_.end())
        refuted_.push_back(claim.guess);
    } else if (proof_.reason.empty()) {
      SayOfLoop(verdicts[i] == solver::Verdict::kDifferent ? claim.what : "not within the time: " + claim.what, claim);
      if (verdicts[i] == solver::Verdict::kDifferent) proof_.differences.push_back(Show(solver, questions[i]));
    }
  }
  if (refuted != nullptr && proof_.reason.empty())
    SayOfLoop("what its loops keep is not found: " + refuted->what, *refuted);
  return refuted_.empty() && proof_.reason.empty();
}

void UnitVerifier::SayOfLoop(std::string reason, const LoopClaim& claim) {
  proof_.reason = std::move(reason);
  proof_.statement = ir::StatementOfLoop(program_.ir, claim.loop);
}

void UnitVerifier::Decide(solver::Solver& solver) {
  const std::vector<solver::Verdict> verdicts = Compare(solver, questions_);
  proof_.result = ProofResult::kProved;
  size_t asked = 0;
  bool all_rounds = false;
  std::string undefined;  // what the code's language leaves open
  for (size_t i = 0; i < verdicts.size(); ++i) {
    if (questions_[i].of == Question::Of::kLeftOut) {
      all_rounds = verdicts[i] == solver::Verdict::kEqual;
      continue;
    }
    const bool open = program_.shape.IsUpToFaults() && questions_[i].of == Question::Of::kObligation;
    if (open && verdicts[i] == solver::Verdict::kDifferent) {
      if (undefined.empty()) undefined = questions_[i].what;
      continue;
    }
    if (verdicts[i] == solver::Verdict::kDifferent) {
      if (proof_.differences.size() == kMostDifferences) continue;
      const bool may_ask = ++asked <= kMostShown;
      CodeDifference difference = may_ask ? Show(solver, questions_[i]) : CodeDifference();
      if (difference.has_values) {
        proof_.result = ProofResult::kDifferent;
        proof_.differences.push_back(std::move(difference));
      } else if (proof_.result == ProofResult::kProved) {
        proof_.result = ProofResult::kNotDecided;
        proof_.reason = "no numbers show a difference, and no proof that there are none: " + questions_[i].what;
      }
    } else if (verdicts[i] == solver::Verdict::kUndecided && proof_.result == ProofResult::kProved) {
      proof_.result = ProofResult::kNotDecided;
      proof_.reason = "not within the time: " + questions_[i].what;
    }
  }
  if (proof_.result == ProofResult::kDifferent) proof_.reason.clear();
  if (!undefined.empty() && proof_.result != ProofResult::kNotDecided) {
    // What differs after it may come from there.
    proof_.result = ProofResult::kNotDecided;
    proof_.differences.clear();
    proof_.reason = "C leaves open what the language says: " + undefined;
    return;
  }
  if (!has_loops_ || all_rounds) return;
  // A state at the head of a loop need not be one that is reached; and rounds that were left out are not proved.
  if (proof_.result == ProofResult::kDifferent && relation_ != nullptr) {
    proof_.result = ProofResult::kNotDecided;
    proof_.reason = "behind its loops: " + proof_.differences.front().what;
  } else if (proof_.result == ProofResult::kProved && relation_ == nullptr) {
    SayOfRounds();
  }
}

void UnitVerifier::SayOfRounds() {
  proof_.result = ProofResult::kNotDecided;
  proof_.reason = "a loop may go round more than " + std::to_string(policy_.rounds) + " times";
}

RoutineProof UnitVerifier::Run() {
  proof_.routine = is_inner() ? unit_.name : routine_.name;
  proof_.exported = !is_inner();
  if (program_.limits.progress) program_.limits.progress(proof_.routine);
  solver::LoadedSolver loaded = solver::LoadSolver(terms_);
  if (loaded.solver == nullptr) {
    proof_.reason = loaded.reason;
    gave_up_ = true;
    return std::move(proof_);
  }
  image_.MakeVariables(terms_);
  now_ = terms_.Variable("now", 32);
  hash_ = is_init() ? terms_.Const(image_.layout_hash(), 32) : image_.HashBefore(terms_);
  const bool in_order = treatment_.callees == Callees::kReplacedInOrder;
  faulted_ = open_faults_ = terms_.Bit(false);
  const bool replaces = treatment_.callees != Callees::kFollowed;
  if (replaces || program_.shape.passes == Passes::kNothing) {
    const auto matching = in_order ? CallLog::Matching::kByOrder : CallLog::Matching::kByArguments;
    const auto never = [this, &loaded](terms::TermId condition) { return NeverHolds(*loaded.solver, condition); };
    replaced_ = std::make_unique<Replaced>(program_, workplace_, hash_, CallLog(terms_, matching, never), replaces,
                                           [this](terms::TermId when, terms::TermId code) { NoteFault(when, code); });
  }
  MakeArguments();
  const execute::Environment environment = MakeEnvironment(*loaded.solver);
  if (treatment_.loops == Loops::kInStep && !in_order) {
    relation_ = std::make_unique<LoopRelation>(terms_, program_.emittable, program_.cells, image_, environment.initial,
                                               treatment_.dropped);
  }
  if (in_order) policy_.rounds = kFewRounds;
  if (treatment_.loops == Loops::kUnrolled) policy_.rounds = kMostUnrolled;
  policy_.heads = relation_.get();
  policy_.left_out = terms_.Bit(false);
  execute::Memory memory(terms_, program_.ir, program_.cells, environment);
  proof_.reason = ExecuteProgram(memory);
  has_loops_ = policy_.has_heads || !terms_.IsFalse(policy_.left_out);
  gave_up_ = !proof_.reason.empty();
  if (gave_up_) return std::move(proof_);
  CheckFootprint(memory);
  const CodeOutcome outcome = ExecuteCode(*loaded.solver);
  has_loops_ = has_loops_ || (relation_ != nullptr && relation_->has_code()) ||
               (outcome.left_out.valid() && !terms_.IsFalse(outcome.left_out));
  proof_.instructions = outcome.instructions;
  proof_.reason = outcome.refusal;
  if (!proof_.reason.empty()) return std::move(proof_);
  // Of loops by their first rounds nothing is proved, and of callees that are unknown no difference counts.
  if (in_order && has_loops_ && !program_.shape.IsUpToFaults()) {
    SayOfRounds();
    gave_up_ = true;
    return std::move(proof_);
  }
  if (relation_ != nullptr && !DecideLoops(*loaded.solver)) {
    gave_up_ = true;
    return std::move(proof_);
  }
  if (unit_.result.valid())
    greatest_result_ = terms::Intervals(terms_).Of(memory.ReadPlace(program_.ir.places[unit_.result])).high;
  Ask(memory, outcome);
  Decide(*loaded.solver);
  gave_up_ = proof_.result == ProofResult::kNotDecided;
  return std::move(proof_);
}
}  // namespace plcxx::prove::verify
