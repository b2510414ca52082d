#include "transpiler/prove/invariants/invariants.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "transpiler/ir/schedule.h"
#include "transpiler/prove/invariants/candidates.h"
#include "transpiler/prove/invariants/concrete_run.h"
#include "transpiler/prove/machine/requests.h"
#include "transpiler/prove/machine/transition.h"
#include "transpiler/symbolic/solver/bit_solver.h"
#include "transpiler/symbolic/solver/deadline.h"
#include "transpiler/symbolic/terms/evaluate.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::prove::invariants {
namespace {

constexpr int kRuns = 12, kPeriods = 150, kMostPeriods = 3000;
constexpr size_t kMostEvaluated = 20'000'000;  // terms, in all runs
constexpr int kRates = 5, kMoreRates = 9;      // at which inputs change, of short runs and of long ones
constexpr uint64_t kOneWordIn = 4;             // periods, one word of inputs is what a program compares something with
constexpr int kPeriodsFromSeen = 12, kPeriodsFromModel = 40;
constexpr uint32_t kMostFast = 4;  // fast parts in a simulated period
constexpr int kDisturbedStates = 250;
constexpr uint32_t kPowerOnMs = 1000, kAloneMs = 150;  // for one question

}  // namespace

class InvariantFinder::Finder {
 public:
  Finder(terms::Terms& terms, solver::Solver& solver, InvariantSearch search)
      : terms_(terms),
        solver_(solver),
        search_(std::move(search)),
        version_(search_.version),
        requests_(machine::RequestCells(version_)) {}

  void Find(uint64_t milliseconds);
  void GuessAgain();
  const std::vector<Invariant>& proved() const { return proved_; }
  bool is_done() const { return is_done_; }

 private:
  /// Not yet dropped.
  struct Guess {
    Invariant invariant;
    terms::TermId holds, fails;  // before a part, and after any
  };

  bool Late() const { return deadline_.IsOver(); }
  terms::TermId Current(execute::CellId cell);
  terms::TermId Next(const machine::Transition& part, execute::CellId cell);
  terms::TermId WhenTakenBack(execute::CellId cell);
  /// false: it cannot be executed, or not in time.
  bool ExecuteParts();
  /// The state cells on which the next values of those of interest depend; all of them at last, closed under this.
  void CloseOver();
  void Prepare();
  ConcreteRun::Step StepOf(const machine::Transition& transition);
  void Take(const CellValues& state, uint64_t now_ms);
  /// The words that inputs make, and with what they may be compared.
  void FindInputWords();
  /// A word of inputs gets a value that the program knows: bit by bit nobody hits it.
  void SetInputWord();
  /// What the host answers there: the same for a while, then what is made up, or what the program knows.
  uint64_t AnswerOf(terms::TermId answer, uint64_t made_up);
  uint64_t AnyConstant() { return constants_[(random_.Next() >> 20) % constants_.size()]; }
  /// Periods with random inputs from the present state of the run on; `after` each part.
  void RunOn(int periods, uint64_t one_in, const std::function<void()>& after);
  bool HoldsAtPowerOn(const Invariant& guess);
  void MakeGuesses();
  void DropWrongIn(const CellValues& state, std::vector<Guess>& guesses);
  /// What fails in the solver's model, or a little later: a state from which all guesses hold leads there.
  void DropByModel();
  void Keep(Guess guess);
  /// Most guesses that need other ones are found out by states that are like seen ones, and cannot be reached.
  void SetAsideByDisturbedStates();
  /// Candidates that need no other ones; most of what a statement sees to is one.
  void ProveAlone();
  /// All that are left of `guesses_`, together; false: it is late.
  bool Prove();

  terms::Terms& terms_;
  solver::Solver& solver_;
  const InvariantSearch search_;
  const machine::Version& version_;
  std::vector<bool> requests_;  // by CellId
  std::map<execute::CellId, terms::TermId> current_;
  std::vector<machine::Transition> parts_;  // the fast part alone, then the period
  machine::Transition init_;
  terms::TermId now_;
  std::vector<execute::CellId> state_;   // closed: what the cells of interest depend on in any number of periods
  std::vector<execute::CellId> inputs_;  // that these depend on
  std::vector<std::vector<execute::CellId>> input_words_;  // from the lowest bit
  std::vector<uint64_t> constants_;
  std::map<terms::TermId, uint64_t> answers_;
  uint64_t one_in_ = 2;  // periods, an answer changes
  std::optional<ConcreteRun> run_;
  std::vector<ConcreteRun::Step> steps_;  // by part
  std::unique_ptr<solver::BitSolver> bits_;
  std::vector<Guess> untried_, guesses_, pairs_;  // not yet tried alone; tried; these come last
  std::vector<Invariant> proved_;
  bool is_prepared_ = false, is_done_ = false;
  bool guesses_again_ = false;
  terms::Random random_{0x2545F4914F6CDD1D};
  solver::Deadline deadline_{solver::Clock::kWall, 0};  // of Find
};

terms::TermId InvariantFinder::Finder::Current(execute::CellId cell) {
  terms::TermId& term = current_[cell];
  if (!term.valid()) {
    const execute::Cell what = execute::CellAt(*version_.program, version_.cells, cell);
    term = terms_.Variable("alone " + execute::CellName(*version_.program, what),
                           execute::CellWidth(*version_.program, what));
  }
  return term;
}

/// Requests may be taken back by the control between two parts.
terms::TermId InvariantFinder::Finder::WhenTakenBack(execute::CellId cell) {
  const terms::TermId before = Current(cell);
  if (!requests_[cell.index]) return before;
  const execute::Cell what = execute::CellAt(*version_.program, version_.cells, cell);
  return terms_.And(before, terms_.Variable("alone stays " + execute::CellName(*version_.program, what), 1));
}

terms::TermId InvariantFinder::Finder::Next(const machine::Transition& part, execute::CellId cell) {
  const terms::TermId next = part.next[cell.index];
  return next.valid() ? next : Current(cell);
}

bool InvariantFinder::Finder::ExecuteParts() {
  parts_.clear();
  if (!now_.valid()) now_ = terms_.Variable("alone now", 32);
  const machine::PartEnvironment environment{.initial = [this](execute::CellId cell) { return Current(cell); },
                                             .now = now_,
                                             .observed = {},
                                             .is_late = [this] { return Late(); }};
  const auto is_executed = [this](const machine::Transition& transition) {
    is_done_ = is_done_ || (!transition.refusal.empty() && !Late());
    return transition.refusal.empty();
  };
  for (const machine::Part part : {machine::Part::kFast, machine::Part::kPeriod}) {
    if (part == machine::Part::kFast && !machine::HasFastPart(version_)) continue;
    parts_.push_back(machine::RunPart(terms_, version_, part, environment));
    if (!is_executed(parts_.back())) return false;
  }
  init_ = machine::RunInit(terms_, version_, environment);
  return is_executed(init_);
}

void InvariantFinder::Finder::CloseOver() {
  std::vector<bool> seen_terms(terms_.size());
  std::set<execute::CellId> closed(search_.cells.begin(), search_.cells.end());
  std::map<uint32_t, execute::CellId> cell_of;  // by variable term
  for (const auto& [cell, term] : current_) cell_of[term.index] = cell;
  std::vector<execute::CellId> open(closed.begin(), closed.end());
  while (!open.empty()) {
    const execute::CellId cell = open.back();
    open.pop_back();
    std::vector<terms::TermId> terms;
    for (const machine::Transition& part : parts_) terms.push_back(Next(part, cell));
    while (!terms.empty()) {
      const terms::TermId id = terms.back();
      terms.pop_back();
      if (id.index >= seen_terms.size()) seen_terms.resize(terms_.size());
      if (seen_terms[id.index]) continue;
      seen_terms[id.index] = true;
      const auto found = cell_of.find(id.index);
      if (found != cell_of.end() && closed.insert(found->second).second) open.push_back(found->second);
      terms_.ForEachOperand(terms_[id], [&terms](terms::TermId operand) { terms.push_back(operand); });
    }
  }
  for (const execute::CellId cell : closed) (search_.is_input(cell) ? inputs_ : state_).push_back(cell);
}

ConcreteRun::Step InvariantFinder::Finder::StepOf(const machine::Transition& transition) {
  std::vector<terms::TermId> next;
  for (const execute::CellId cell : state_) next.push_back(Next(transition, cell));
  return run_->StepOf(std::move(next));
}

void InvariantFinder::Finder::Take(const CellValues& state, uint64_t now_ms) {
  for (const std::vector<execute::CellId>* const cells : {&state_, &inputs_}) {
    for (const execute::CellId cell : *cells) run_->Set(cell, state(cell));
  }
  run_->now_ms = now_ms;
}

void InvariantFinder::Finder::FindInputWords() {
  std::set<std::vector<execute::CellId>> words;
  for (const ir::Place& place : version_.program->places) {
    const bool is_word = !place.is_field() && !place.indexed && place.type != ir::Type::kBit &&
                         place.type <= ir::Type::kI64 && execute::IsInside(*version_.program, place);
    if (!is_word) continue;
    std::vector<execute::CellId> cells = execute::CellsOf(*version_.program, version_.cells, place);
    const auto is_input = [this](execute::CellId cell) { return std::ranges::binary_search(inputs_, cell); };
    if (std::ranges::all_of(cells, is_input)) words.insert(std::move(cells));
  }
  input_words_.assign(words.begin(), words.end());
  // Not those of the terms: a comparison of bits that are known one by one has none.
  std::set<uint64_t> constants;
  for (const ir::Region& region : version_.program->regions) {
    for (const ir::InstId id : region.insts) {
      const ir::Inst& inst = (*version_.program)[id];
      if (inst.op == ir::OpKind::kConst && inst.type != ir::Type::kBit) constants.insert(ir::ConstantValue(inst));
    }
  }
  constants_.assign(constants.begin(), constants.end());
}

void InvariantFinder::Finder::SetInputWord() {
  const std::vector<execute::CellId>& word = input_words_[(random_.Next() >> 20) % input_words_.size()];
  const uint64_t value = AnyConstant();
  for (size_t bit = 0; bit < word.size(); ++bit) run_->Set(word[bit], bit < 64 ? value >> bit & 1 : 0);
}

uint64_t InvariantFinder::Finder::AnswerOf(terms::TermId answer, uint64_t made_up) {
  const auto [at, is_new] = answers_.try_emplace(answer, made_up);
  if (!is_new && random_.OneIn(one_in_)) {
    const bool is_known = !constants_.empty() && random_.OneIn(2);
    at->second = terms::Masked(is_known ? AnyConstant() : made_up ^ random_.Next() >> 8, terms_.Width(answer));
  }
  return at->second;
}

void InvariantFinder::Finder::RunOn(int periods, uint64_t one_in, const std::function<void()>& after) {
  const ir::Schedule& schedule = version_.program->schedule;
  // Of the fast parts between two periods a few are enough to guess from.
  const uint32_t fast_parts = std::min(ir::FastPartsOfPeriod(schedule), kMostFast);
  one_in_ = one_in;
  const bool may_be_alone = steps_.size() > 1 && fast_parts == 0;  // the fast part, in some periods
  for (int period = 0; period < periods && !Late(); ++period) {
    for (const execute::CellId cell : inputs_) {
      if (random_.Next() % one_in == 0) run_->Set(cell, random_.Next() & 1);
    }
    if (!input_words_.empty() && !constants_.empty() && random_.OneIn(kOneWordIn)) SetInputWord();
    for (uint32_t part = 0; part < fast_parts; ++part) {
      run_->Execute(steps_.front());
      run_->now_ms += schedule.period_ms / fast_parts;
      after();
    }
    run_->Execute(may_be_alone && random_.OneIn(4) ? steps_.front() : steps_.back());
    if (fast_parts == 0) run_->now_ms += schedule.period_ms;
    after();
  }
}

bool InvariantFinder::Finder::HoldsAtPowerOn(const Invariant& guess) {
  const terms::TermId wrong =
      terms_.Not(ConditionOf(terms_, guess, [this](execute::CellId cell) { return init_.next[cell.index]; }));
  return terms_.IsFalse(wrong) ||
         (!Late() && solver_.Check({&wrong, 1}, deadline_.LimitFor(kPowerOnMs)) == solver::Answer::kNever);
}

void InvariantFinder::Finder::MakeGuesses() {
  std::vector<execute::CellId> cells;
  std::ranges::copy_if(search_.cells, std::back_inserter(cells),
                       [this](execute::CellId cell) { return !search_.is_input(cell); });
  Candidates guesses(version_, cells,
                     [this](execute::CellId cell) { return std::ranges::binary_search(state_, cell); });
  const auto add_state = [&] { guesses.AddState([this](execute::CellId cell) { return run_->ValueOf(cell); }); };
  const ConcreteRun::Step init = StepOf(init_);
  for (const ConcreteRun::Step& step : steps_) {
    for (const terms::TermId id : step.cone) {
      if (terms_.IsConst(id)) guesses.AddConstant(terms_.Value(id));
    }
  }
  guesses.AddConstantsOf(*version_.program);
  FindInputWords();
  size_t terms = 1;
  for (const ConcreteRun::Step& step : steps_) terms += step.cone.size();
  const int periods = static_cast<int>(std::clamp<size_t>(kMostEvaluated / kRuns / terms, kPeriods, kMostPeriods));
  for (int run = 0; run < kRuns && !Late(); ++run) {
    Take([](execute::CellId) { return uint64_t{0}; }, 0);
    for (const execute::CellId cell : inputs_) run_->Set(cell, random_.Next() & 1);
    run_->Execute(init);
    add_state();
    // Inputs change seldom in some runs and often in others, as a machine's do.
    RunOn(periods, uint64_t{2} << (run % (periods > kPeriods ? kMoreRates : kRates)), add_state);
  }
  if (search_.seen_states) {
    search_.seen_states([&](const CellValues& state, uint64_t now_ms) {
      Take(state, now_ms);
      add_state();
      RunOn(kPeriodsFromSeen, 8, add_state);
    });
  }
  const auto current = [this](execute::CellId cell) { return Current(cell); };
  const std::set<Invariant> known(proved_.begin(), proved_.end());
  for (Invariant& guess : guesses.Make()) {
    if (known.contains(guess) || !HoldsAtPowerOn(guess)) continue;
    // They have to outlive each part, in whatever order the parts come.
    terms::TermId fails = terms_.Bit(false);
    for (const machine::Transition& part : parts_) {
      const terms::TermId holds = ConditionOf(terms_, guess, [&](execute::CellId cell) { return Next(part, cell); });
      fails = terms_.Or(fails, terms_.Not(holds));
    }
    const terms::TermId stays =
        ConditionOf(terms_, guess, [this](execute::CellId cell) { return WhenTakenBack(cell); });
    const terms::TermId holds = ConditionOf(terms_, guess, current);
    if (stays != holds) fails = terms_.Or(fails, terms_.Not(stays));
    (guess.kind == Invariant::Kind::kNoneOf ? pairs_ : untried_)
        .push_back({.invariant = std::move(guess), .holds = holds, .fails = fails});
  }
}

void InvariantFinder::Finder::Prepare() {
  if (!ExecuteParts()) return;
  CloseOver();
  for (const execute::CellId cell : state_) Current(cell);
  run_.emplace(terms_, version_, state_, current_, now_);
  run_->answer = [this](terms::TermId answer, uint64_t made_up) { return AnswerOf(answer, made_up); };
  for (const machine::Transition& part : parts_) steps_.push_back(StepOf(part));
  MakeGuesses();
  SetAsideByDisturbedStates();
  bits_ = solver::LoadBitSolver(terms_);
  is_done_ = bits_ == nullptr;
  is_prepared_ = true;
}

void InvariantFinder::Finder::DropWrongIn(const CellValues& state, std::vector<Guess>& guesses) {
  std::erase_if(guesses, [&state](const Guess& guess) { return !HoldsIn(guess.invariant, state); });
}

void InvariantFinder::Finder::DropByModel() {
  Take([this](execute::CellId cell) { return bits_->ValueOf(Current(cell)); }, bits_->ValueOf(now_));
  std::erase_if(guesses_, [this](const Guess& guess) { return bits_->ValueOf(guess.fails) != 0; });
  RunOn(kPeriodsFromModel, 4,
        [this] { DropWrongIn([this](execute::CellId cell) { return run_->ValueOf(cell); }, guesses_); });
}

void InvariantFinder::Finder::Keep(Guess guess) {
  bits_->Assume(guess.holds);
  proved_.push_back(std::move(guess.invariant));
}

void InvariantFinder::Finder::SetAsideByDisturbedStates() {
  const CellValues value = [this](execute::CellId cell) { return run_->ValueOf(cell); };
  for (int i = 0; i < kDisturbedStates && !Late(); ++i) {
    for (const execute::CellId cell : state_) {
      if (!random_.OneIn(6)) continue;
      run_->Set(cell, random_.OneIn(2) ? random_.Next() & 1 : random_.Next() % 8);
      const execute::Cell what = execute::CellAt(*version_.program, version_.cells, cell);
      if (execute::CellWidth(*version_.program, what) == 1) run_->Set(cell, run_->ValueOf(cell) & 1);
    }
    for (const execute::CellId cell : inputs_) run_->Set(cell, random_.Next() & 1);
    std::vector<bool> held;
    for (const Guess& guess : untried_) held.push_back(HoldsIn(guess.invariant, value));
    run_->Execute(steps_[random_.Next() % steps_.size()]);
    run_->now_ms += version_.program->schedule.period_ms;
    size_t index = 0;
    std::erase_if(untried_, [&](Guess& guess) {
      if (!held[index++] || HoldsIn(guess.invariant, value)) return false;
      guesses_.push_back(std::move(guess));
      return true;
    });
  }
}

void InvariantFinder::Finder::ProveAlone() {
  // Together they need fewer questions.
  const solver::Deadline half(solver::Clock::kWall, deadline_.RestMs() / 2);
  while (!untried_.empty() && !half.IsOver()) {
    Guess guess = std::move(untried_.back());
    untried_.pop_back();
    const std::array question{guess.holds, guess.fails};
    if (terms_.IsFalse(guess.fails) || bits_->Check(question, deadline_.LimitFor(kAloneMs)) == solver::Answer::kNever) {
      Keep(std::move(guess));
    } else {
      guesses_.push_back(std::move(guess));
    }
  }
  std::ranges::move(untried_, std::back_inserter(guesses_));
  untried_.clear();
}

bool InvariantFinder::Finder::Prove() {
  for (;;) {
    // All questions are about the same terms, under ever fewer conditions.
    std::vector<terms::TermId> question;
    terms::TermId any = terms_.Bit(false);
    for (const Guess& guess : guesses_) {
      question.push_back(guess.holds);
      any = terms_.Or(any, guess.fails);
    }
    if (terms_.IsFalse(any)) return true;
    question.push_back(any);
    if (Late()) return false;
    switch (bits_->Check(question, solver::Limit().Within(deadline_.RestMs()))) {
      case solver::Answer::kNever:
        return true;
      case solver::Answer::kUnknown:
        return false;
      case solver::Answer::kPossible:
        break;
    }
    DropByModel();
  }
}

void InvariantFinder::Finder::Find(uint64_t milliseconds) {
  deadline_ = solver::Deadline(solver::Clock::kWall, milliseconds);
  const bool goes_on = is_prepared_;
  if (!is_prepared_) Prepare();
  if (!is_prepared_ || is_done_) return;
  if (std::exchange(guesses_again_, false)) {
    for (std::vector<Guess>* const guesses : {&untried_, &guesses_, &pairs_}) guesses->clear();
    MakeGuesses();
    SetAsideByDisturbedStates();
  } else if (goes_on && search_.seen_states) {
    // More has been seen since.
    search_.seen_states([this](const CellValues& state, uint64_t) {
      for (std::vector<Guess>* const guesses : {&untried_, &guesses_, &pairs_}) DropWrongIn(state, *guesses);
    });
  }
  ProveAlone();
  while (!is_done_ && Prove()) {
    for (Guess& guess : guesses_) Keep(std::move(guess));
    guesses_ = std::exchange(pairs_, {});
    is_done_ = guesses_.empty();
  }
}

void InvariantFinder::Finder::GuessAgain() {
  if (!is_prepared_ || bits_ == nullptr || !search_.seen_states) return;
  guesses_again_ = true;
  is_done_ = false;
}

uint64_t NumberOf(std::span<const execute::CellId> cells, const CellValues& state) {
  if (cells.size() == 1) return state(cells.front());
  uint64_t number = 0;
  for (const execute::CellId cell : cells) number = number << 1 | (state(cell) & 1);
  return number;
}

terms::TermId ConditionOf(terms::Terms& terms, const Invariant& invariant,
                          const std::function<terms::TermId(execute::CellId)>& value) {
  const auto number_of = [&](std::span<const execute::CellId> cells) {
    terms::TermId number;
    for (const execute::CellId cell : cells) {
      const terms::TermId part = value(cell);
      number = number.valid() ? terms.Concat(number, part) : part;
    }
    return number;
  };
  const auto is = [&](terms::TermId number, uint64_t one) {
    return terms.Eq(number, terms.Const(one, terms.Width(number)));
  };
  const terms::TermId number = number_of(invariant.cells);
  terms::TermId holds = terms.Bit(false);
  if (invariant.kind == Invariant::Kind::kAtMost) {
    holds = terms.Ule(number, terms.Const(invariant.values.front(), terms.Width(number)));
  } else {
    for (const uint64_t one : invariant.values) holds = terms.Or(holds, is(number, one));
    if (invariant.kind == Invariant::Kind::kNoneOf) holds = terms.Not(holds);
  }
  if (invariant.while_cells.empty()) return holds;
  return terms.Or(terms.Not(is(number_of(invariant.while_cells), invariant.while_value)), holds);
}

bool HoldsIn(const Invariant& invariant, const CellValues& state) {
  if (!invariant.while_cells.empty() && NumberOf(invariant.while_cells, state) != invariant.while_value) return true;
  const uint64_t number = NumberOf(invariant.cells, state);
  const bool is_among = std::ranges::find(invariant.values, number) != invariant.values.end();
  switch (invariant.kind) {
    case Invariant::Kind::kOneOf:
      return is_among;
    case Invariant::Kind::kNoneOf:
      return !is_among;
    case Invariant::Kind::kAtMost:
      return number <= invariant.values.front();
  }
  return false;
}

InvariantFinder::InvariantFinder(terms::Terms& terms, solver::Solver& solver, InvariantSearch search)
    : finder_(std::make_unique<Finder>(terms, solver, std::move(search))) {}
InvariantFinder::~InvariantFinder() = default;

void InvariantFinder::Find(uint64_t milliseconds) {
  if (!is_done()) finder_->Find(milliseconds);
}
void InvariantFinder::GuessAgain() { finder_->GuessAgain(); }
const std::vector<Invariant>& InvariantFinder::invariants() const { return finder_->proved(); }
bool InvariantFinder::is_done() const { return finder_->is_done(); }

}  // namespace plcxx::prove::invariants
