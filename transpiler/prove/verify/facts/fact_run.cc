#include "transpiler/prove/verify/facts/fact_run.h"

#include <algorithm>
#include <array>
#include <utility>

#include "transpiler/ir/facts.h"
#include "transpiler/symbolic/meaning/meaning.h"
#include "transpiler/symbolic/solver/deadline.h"
#include "transpiler/symbolic/solver/model.h"
#include "transpiler/symbolic/solver/sweep.h"
#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/intervals.h"

namespace plcxx::prove::verify::facts {
namespace {

using verify::Unit;
using verify::UnitId;

constexpr int kMostTries = 80;  // with other candidates for what loops have in common
constexpr uint32_t kMostRounds = 512;
constexpr uint32_t kMostTerms = 4'000'000;

/// Calls and chunks that are not looked into: what they may write is anything afterwards.
class AnythingParts : public execute::ReplacedParts {
 public:
  explicit AnythingParts(const CheckedProgram& program) : program_(program) {}

  std::optional<std::vector<execute::CellChange>> Call(execute::Memory& memory, ir::RoutineId routine,
                                                       terms::TermId) override {
    const UnitId unit = program_.units.of_routines[routine.index];
    if (!unit.valid()) return std::nullopt;
    return After(memory, program_.units[unit]);
  }
  std::optional<std::vector<execute::CellChange>> Part(execute::Memory& memory, ir::RegionId region, uint32_t& at,
                                                       terms::TermId) override {
    const UnitId unit = program_.units.At(program_.emittable, region, at);
    if (!unit.valid()) return std::nullopt;
    at = program_.units[unit].part.end;
    return After(memory, program_.units[unit]);
  }

 private:
  /// One variable for each byte and field, so that words stay words.
  std::vector<execute::CellChange> After(execute::Memory& memory, const Unit& unit) {
    terms::Terms& terms = memory.terms();
    const std::string after = " after " + unit.name + " " + std::to_string(++calls_);
    std::vector<execute::CellChange> changes;
    terms::TermId byte;
    for (uint32_t i = 0; i < program_.cells.count; ++i) {
      const execute::CellId id(i);
      const execute::Cell cell = execute::CellAt(program_.ir, program_.cells, id);
      const bool is_bit = cell.kind == execute::CellKind::kBit;
      if (!is_bit || cell.bit == 0) byte = {};
      if (!unit.footprint.written[i]) continue;
      if (!byte.valid()) {
        byte = terms.Variable(execute::CellName(program_.ir, cell) + after,
                              is_bit ? uint8_t{8} : execute::CellWidth(program_.ir, cell));
      }
      changes.push_back({id, is_bit ? terms.Extract(byte, cell.bit, 1) : byte});
    }
    return changes;
  }

  const CheckedProgram& program_;
  uint32_t calls_ = 0;
};

}  // namespace

/// The relation of loops, and which questions come from iterations that turn out to write more than was known.
struct FactRun::Attempt {
  class Heads : public execute::LoopHeads {
   public:
    Heads(verify::LoopRelation& relation, std::vector<Question>& questions)
        : relation_(relation), questions_(questions) {}

    void BeginSamples() override { samples_ = questions_.size(); }
    void Open() override {
      questions_.resize(samples_);  // the arbitrary iteration shows more
      relation_.Open();
      open_.push_back(questions_.size());
    }
    execute::ProgramLoop::Head AtHead(const execute::ProgramLoop& loop) override {
      questions_.resize(open_.back());
      return relation_.AtHead(loop);
    }
    void Holds(terms::TermId condition) override { relation_.Holds(condition); }
    void Close(terms::TermId again, std::span<const terms::TermId> values) override {
      relation_.Close(again, values);
      open_.pop_back();
    }

   private:
    verify::LoopRelation& relation_;
    std::vector<Question>& questions_;
    size_t samples_ = 0;        // the questions before the first iterations of the last loop
    std::vector<size_t> open_;  // by open loop: the questions before it
  };

  terms::Terms terms;
  std::unique_ptr<solver::Solver> solver;
  verify::StateImage image;
  terms::TermId now;
  std::vector<terms::TermId> arguments;
  std::vector<std::pair<execute::CellId, terms::TermId>> initial;  // that was asked for
  std::vector<Question> questions;
  std::unique_ptr<verify::LoopRelation> relation;
  bool has_heads = false;

  explicit Attempt(const verify::StateImage& before) : image(before) {}
};

bool FactRun::is_inner() const {
  return unit_.part.region.valid() || emit::SharesLocals(program_.ir.routines[unit_.part.routine].kind);
}

bool FactRun::AreClaimsShown(Attempt& attempt) {
  std::vector<solver::TermPair> pairs;
  terms::Terms& terms = attempt.terms;
  for (const verify::LoopClaim& claim : attempt.relation->claims()) {
    const terms::TermId none = terms.Const(0, terms.Width(claim.pair.a));
    pairs.push_back({terms.Ite(claim.given, claim.pair.a, none), terms.Ite(claim.given, claim.pair.b, none)});
  }
  solver::SweepLimits sweep;
  sweep.pair_ms = limits_.question_ms;
  sweep.total_ms = deadline_.RestMs() / 2;
  sweep.clock = solver::Clock::kProcessor;
  const std::vector<solver::Verdict> verdicts = solver::Compare(terms, *attempt.solver, pairs, sweep);
  // Those that can make others fail first.
  verify::Blame least = verify::Blame::kMemory;
  std::vector<std::string> refuted;
  for (size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i] == solver::Verdict::kEqual) continue;
    const verify::LoopClaim& claim = attempt.relation->claims()[i];
    if (claim.blame < least) refuted.clear();
    least = std::min(least, claim.blame);
    if (claim.blame == least && std::ranges::find(refuted, claim.guess) == refuted.end())
      refuted.push_back(claim.guess);
  }
  for (const std::string& guess : refuted) ++dropped_[guess];
  return refuted.empty();
}

Shown FactRun::Show(Attempt& attempt, const Question& question, terms::TermId wrong) {
  Shown shown{.call = question.call, .result = FactResult::kNotDecided, .reason = {}, .violation = std::nullopt};
  if (question.in_loop) {
    shown.reason = "what its loops keep does not show it";
    return shown;
  }
  if (attempt.solver->Check({&wrong, 1}, deadline_.LimitFor(limits_.question_ms)) != solver::Answer::kPossible) {
    shown.reason = "not within the time";
    return shown;
  }
  std::vector<terms::TermId> roots = {wrong, question.value, attempt.now};
  roots.insert(roots.end(), attempt.arguments.begin(), attempt.arguments.end());
  for (const auto& [cell, term] : attempt.initial) roots.push_back(term);
  const std::vector<uint64_t> values =
      solver::ModelValues(attempt.terms, *attempt.solver, terms::ConeOf(attempt.terms, roots));
  if (values[wrong.index] == 0) {
    shown.reason = "no numbers show that it does not hold, and no proof that it does";
    return shown;
  }
  shown.value = values[question.value.index];
  // What was put in the place of loops, callers and callees permits more than they do.
  if (attempt.has_heads || is_inner() || (calls_ == Calls::kAnything && !unit_.callees.empty())) {
    shown.reason = attempt.has_heads ? "what its loops leave does not show it"
                   : is_inner()      ? "not for all that it is called with"
                                     : "not for all that its functions may do";
    return shown;
  }
  Violation violation{.routine = unit_.part.routine,
                      .arguments = {},
                      .now_ms = static_cast<uint32_t>(values[attempt.now.index]),
                      .state = {}};
  for (const terms::TermId argument : attempt.arguments) violation.arguments.push_back(values[argument.index]);
  for (const auto& [cell, term] : attempt.initial) violation.state.push_back({cell, values[term.index]});
  shown.result = FactResult::kViolated;
  shown.violation = std::move(violation);
  return shown;
}

/// Of a fact that is reached in several iterations or from several callers the worst verdict counts.
std::vector<Shown> FactRun::Decide(Attempt& attempt) {
  terms::Terms& terms = attempt.terms;
  std::vector<solver::TermPair> pairs;
  for (const Question& question : attempt.questions) {
    const terms::TermId given = attempt.relation->Later(question.given);
    const terms::TermId wrong = terms.And(question.when, given);
    pairs.push_back({terms.Bit(false), terms::NeverHolds(terms, wrong) ? terms.Bit(false) : wrong});
  }
  solver::SweepLimits sweep;
  sweep.pair_ms = limits_.question_ms;
  sweep.total_ms = deadline_.RestMs();
  sweep.clock = solver::Clock::kProcessor;
  sweep.answered = program_.answered.get();
  const std::vector<solver::Verdict> verdicts = solver::Compare(terms, *attempt.solver, pairs, sweep);
  std::vector<Shown> shown;
  for (size_t i = 0; i < verdicts.size(); ++i) {
    const Question& question = attempt.questions[i];
    Shown one{.call = question.call, .reason = {}, .violation = std::nullopt};
    if (verdicts[i] == solver::Verdict::kUndecided) {
      one.result = FactResult::kNotDecided;
      one.reason = "not within the time";
    } else if (verdicts[i] == solver::Verdict::kDifferent) {
      one = Show(attempt, question, pairs[i].b);
    }
    const auto same = std::ranges::find(shown, one.call, &Shown::call);
    if (same == shown.end()) {
      shown.push_back(std::move(one));
    } else if (same->result == FactResult::kProved || one.result == FactResult::kViolated) {
      *same = std::move(one);
    }
  }
  return shown;
}

bool FactRun::Try(std::vector<Shown>& shown) {
  shown.clear();
  Attempt attempt(program_.image);
  terms::Terms& terms = attempt.terms;
  solver::LoadedSolver loaded = solver::LoadSolver(terms);
  if (loaded.solver == nullptr) {
    refusal_ = loaded.reason;
    return true;
  }
  attempt.solver = std::move(loaded.solver);
  attempt.image.MakeVariables(terms);
  attempt.now = terms.Variable("now", 32);
  const auto variable = [&](ir::PlaceId id) {
    return terms.Variable(program_.emittable.place_names[id.index], meaning::WidthOf(program_.ir.places[id].type));
  };

  AnythingParts anything(program_);
  execute::LoopPolicy policy;
  policy.left_out = terms.Bit(false);
  execute::Environment environment;
  environment.now = attempt.now;
  environment.most_rounds = kMostRounds;
  environment.most_terms = kMostTerms;
  environment.replaced = calls_ == Calls::kAnything ? &anything : nullptr;
  environment.loops = &policy;
  environment.initial = [&attempt](execute::CellId cell) {
    attempt.initial.emplace_back(cell, attempt.image.CellBefore(attempt.terms, cell));
    return attempt.initial.back().second;
  };
  attempt.relation = std::make_unique<verify::LoopRelation>(
      terms, program_.emittable, program_.cells, program_.image,
      [&attempt](execute::CellId cell) { return attempt.image.CellBefore(attempt.terms, cell); }, dropped_);
  Attempt::Heads heads(*attempt.relation, attempt.questions);
  policy.heads = &heads;
  environment.tell = [&](ir::InstId call, std::span<const terms::TermId> arguments, terms::TermId when) {
    if (!ir::IsFalseFact(program_.ir, program_.ir[call])) return false;
    const terms::TermId value = arguments[static_cast<size_t>(ir::FalseFactArgument::kValue)];
    if (!terms.IsFalse(when))
      attempt.questions.push_back({call, when, value, attempt.relation->NoteGiven(), attempt.relation->is_in_loop()});
    return true;
  };
  execute::Memory memory(terms, program_.ir, program_.cells, environment);
  for (const ir::PlaceId id : unit_.values) attempt.arguments.push_back(variable(id));
  if (is_inner()) {
    for (size_t i = 0; i < unit_.values.size(); ++i)
      memory.WritePlace(program_.ir.places[unit_.values[i]], attempt.arguments[i]);
    for (const ir::PlaceId id : unit_.references) memory.WritePlace(program_.ir.places[id], variable(id));
    refusal_ = execute::ExecutePart(memory, unit_.part);
  } else {
    refusal_ = execute::Execute(memory, unit_.part.routine, attempt.arguments);
  }
  if (refusal_.empty() && !terms.IsFalse(policy.left_out)) refusal_ = "a loop has too many iterations";
  if (!refusal_.empty()) return true;
  attempt.has_heads = policy.has_heads;
  if (attempt.has_heads && !AreClaimsShown(attempt)) return false;
  shown = Decide(attempt);
  return true;
}

std::vector<Shown> FactRun::Run() {
  std::vector<Shown> shown;
  for (int i = 0; !Try(shown); ++i) {
    if (i == kMostTries || deadline_.IsOver()) {
      refusal_ = "what its loops keep is not found";
      break;
    }
  }
  return shown;
}

}  // namespace plcxx::prove::verify::facts
