#include "transpiler/prove/compare/invariants.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "transpiler/ir/op.h"
#include "transpiler/prove/compare/transition.h"
#include "transpiler/prove/meaning/meaning.h"
#include "transpiler/prove/terms/cone.h"
#include "transpiler/prove/terms/evaluate.h"
#include "transpiler/prove/terms/random.h"

namespace plcxx::prove::compare {
namespace {

constexpr size_t kMostBits = 96;        // that are looked at two by two
constexpr size_t kMostValues = 12;      // of a byte or field that is said to take few
constexpr size_t kMostLimits = 6;       // that a number is guessed to stay below
constexpr size_t kMostConstants = 100;  // of a program that limits are guessed from
constexpr int kRuns = 12, kPeriods = 150;
constexpr uint32_t kMostFast = 4;  // fast parts in a simulated period

/// The constants of the program: a term may have them bit by bit only.
std::set<uint64_t> ConstantsOf(const ir::Program& program) {
  std::set<uint64_t> constants;
  for (const ir::Region& region : program.regions) {
    for (const ir::InstId id : region.insts) {
      const ir::Inst& inst = program[id];
      if (inst.op == ir::OpKind::kConst && inst.type != ir::Type::kBit) constants.insert(ConstantValue(inst));
    }
  }
  return constants;
}

class Finder {
 public:
  Finder(terms::Terms& terms, solver::Solver& solver, const Version& version,
         std::function<bool(execute::CellId)> is_input)
      : terms_(terms), solver_(solver), version_(version), is_input_(std::move(is_input)) {}

  std::vector<Invariant> Find(std::span<const execute::CellId> cells, uint64_t milliseconds);

 private:
  terms::TermId Current(execute::CellId cell);
  terms::TermId Next(const Transition& part, execute::CellId cell);
  /// The state cells on which the next values of `cells` depend; all of them at last, closed under this.
  void CloseOver(std::span<const execute::CellId> cells);
  /// The values of all terms behind the next state of one part, or of power-on.
  struct Step {
    const Transition* transition;
    std::vector<terms::TermId> cone;
  };
  Step StepOf(const Transition& transition);
  static void AddLimit(std::set<uint64_t>& limits, uint64_t constant) {
    limits.insert({constant - 1, constant, constant + 1});
  }
  void Simulate();
  void RecordSample(const std::map<execute::CellId, uint64_t>& state);
  void Guess();
  /// The number may have a limit that the program has as a constant, though no run came near it.
  void GuessLimits(const std::vector<execute::CellId>& cells, uint64_t greatest);
  void DropWrongAtPowerOn();
  bool Prove();

  terms::Terms& terms_;
  solver::Solver& solver_;
  const Version& version_;
  std::function<bool(execute::CellId)> is_input_;
  std::map<execute::CellId, terms::TermId> current_;
  std::vector<Transition> parts_;  // the fast part alone, then the period
  Transition init_;
  terms::TermId now_;
  std::vector<execute::CellId> state_;          // closed: what the cells of interest depend on in any number of periods
  std::vector<execute::CellId> inputs_;         // that these depend on
  std::vector<execute::CellId> bits_, fields_;  // of interest
  std::vector<std::vector<execute::CellId>> bytes_;  // of interest, from bit 7 down
  std::vector<uint8_t> seen_pairs_;                  // by two bits of interest: which of the four combinations occurred
  std::vector<std::set<uint64_t>> seen_fields_, seen_bytes_;
  std::vector<uint64_t> greatest_fields_, greatest_bytes_;  // that occurred
  std::set<uint64_t> limits_;                               // constants of the functions, and their neighbours
  std::set<uint64_t> program_limits_;                       // the same of the whole program
  std::vector<Invariant> guesses_;
  terms::Random random_{0x2545F4914F6CDD1D};
  std::chrono::steady_clock::time_point deadline_;
};

terms::TermId Finder::Current(execute::CellId cell) {
  terms::TermId& term = current_[cell];
  if (!term.valid()) {
    const execute::Cell what = execute::CellAt(*version_.program, version_.cells, cell);
    term = terms_.Variable("alone " + execute::CellName(*version_.program, what),
                           execute::CellWidth(*version_.program, what));
  }
  return term;
}

terms::TermId Finder::Next(const Transition& part, execute::CellId cell) {
  const terms::TermId next = part.next[cell.index];
  return next.valid() ? next : Current(cell);
}

void Finder::CloseOver(std::span<const execute::CellId> cells) {
  std::vector<bool> seen_terms(terms_.size());
  std::set<execute::CellId> closed(cells.begin(), cells.end());
  std::map<uint32_t, execute::CellId> cell_of;  // by variable term
  for (const auto& [cell, term] : current_) cell_of[term.index] = cell;
  std::vector<execute::CellId> open(closed.begin(), closed.end());
  while (!open.empty()) {
    const execute::CellId cell = open.back();
    open.pop_back();
    std::vector<terms::TermId> terms;
    for (const Transition& part : parts_) terms.push_back(Next(part, cell));
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
  for (const execute::CellId cell : closed) (is_input_(cell) ? inputs_ : state_).push_back(cell);
}

void Finder::RecordSample(const std::map<execute::CellId, uint64_t>& state) {
  const auto bit = [&state](execute::CellId cell) { return state.at(cell) & 1; };
  for (size_t i = 0; i < bits_.size(); ++i) {
    for (size_t j = i; j < bits_.size(); ++j) {
      seen_pairs_[i * bits_.size() + j] |= static_cast<uint8_t>(1U << (2 * bit(bits_[i]) + bit(bits_[j])));
    }
  }
  for (size_t i = 0; i < fields_.size(); ++i) {
    greatest_fields_[i] = std::max(greatest_fields_[i], state.at(fields_[i]));
    if (seen_fields_[i].size() <= kMostValues) seen_fields_[i].insert(state.at(fields_[i]));
  }
  for (size_t i = 0; i < bytes_.size(); ++i) {
    uint64_t value = 0;
    for (const execute::CellId cell : bytes_[i]) value = value << 1 | bit(cell);
    greatest_bytes_[i] = std::max(greatest_bytes_[i], value);
    if (seen_bytes_[i].size() <= kMostValues) seen_bytes_[i].insert(value);
  }
}

Finder::Step Finder::StepOf(const Transition& transition) {
  std::vector<terms::TermId> roots;
  for (const execute::CellId cell : state_) roots.push_back(Next(transition, cell));
  Step step{.transition = &transition, .cone = terms::ConeOf(terms_, roots)};
  for (const terms::TermId id : step.cone) {
    if (terms_[id].kind == terms::TermKind::kConst) AddLimit(limits_, terms_.Value(id));
  }
  return step;
}

void Finder::Simulate() {
  const Step init = StepOf(init_);
  std::vector<Step> steps;
  for (const Transition& part : parts_) steps.push_back(StepOf(part));
  // In a large program most of them belong to something else.
  const std::set<uint64_t> constants = ConstantsOf(*version_.program);
  for (const uint64_t constant : constants) {
    if (constants.size() <= kMostConstants) AddLimit(program_limits_, constant);
  }
  std::vector<uint64_t> values(terms_.size());
  std::map<uint32_t, execute::CellId> cell_of;  // by variable
  for (const auto& [cell, term] : current_) cell_of[terms_[term].a] = cell;
  const ir::Schedule& schedule = version_.program->schedule;
  // Of the fast parts between two periods a few are enough to guess from.
  const uint32_t fast_parts =
      HasTimedFastPart(version_) ? std::clamp(schedule.period_ms / schedule.fast_ms, 1U, kMostFast) : 0;
  const bool may_be_alone = steps.size() > 1 && fast_parts == 0;  // the fast part, in some periods
  for (int run = 0; run < kRuns && std::chrono::steady_clock::now() < deadline_; ++run) {
    std::map<execute::CellId, uint64_t> state, inputs;
    uint64_t now = 0;
    const auto execute = [&](const Step& step) {
      for (const terms::TermId id : step.cone) {
        values[id.index] = terms::EvaluateTerm(
            terms_, terms_[id], [&values](terms::TermId operand) { return values[operand.index]; },
            [&](uint32_t variable) -> uint64_t {
              if (variable == terms_[now_].a) return now;
              const auto cell = cell_of.find(variable);
              if (cell == cell_of.end()) return 0;
              const auto of_state = state.find(cell->second);
              if (of_state != state.end()) return of_state->second;
              const auto of_input = inputs.find(cell->second);
              return of_input != inputs.end() ? of_input->second : 0;
            });
      }
      for (const execute::CellId cell : state_) state[cell] = values[Next(*step.transition, cell).index];
      RecordSample(state);
    };
    execute(init);
    // Inputs change seldom in some runs and often in others, as a machine's do.
    const uint64_t one_in = uint64_t{2} << (run % 5);
    for (int period = 0; period < kPeriods && std::chrono::steady_clock::now() < deadline_; ++period) {
      for (const execute::CellId cell : inputs_) {
        if (period == 0 || random_.Next() % one_in == 0) inputs[cell] = random_.Next() & 1;
      }
      for (uint32_t part = 0; part < fast_parts; ++part) {
        execute(steps.front());
        now += schedule.period_ms / fast_parts;
      }
      execute(may_be_alone && random_.OneIn(4) ? steps.front() : steps.back());
      if (fast_parts == 0) now += schedule.period_ms;
    }
  }
}

void Finder::GuessLimits(const std::vector<execute::CellId>& cells, uint64_t greatest) {
  const uint64_t width =
      cells.size() > 1
          ? cells.size()
          : execute::CellWidth(*version_.program, execute::CellAt(*version_.program, version_.cells, cells.front()));
  const uint64_t most = width >= 64 ? ~uint64_t{0} : (uint64_t{1} << width) - 1;
  std::set<uint64_t> nearest;
  for (const std::set<uint64_t>* limits : {&limits_, &program_limits_}) {
    size_t count = 0;
    for (auto limit = limits->lower_bound(greatest); limit != limits->end() && *limit < most && count < kMostLimits;
         ++limit, ++count) {
      nearest.insert(*limit);
    }
  }
  for (const uint64_t limit : nearest) {
    guesses_.push_back({.cells = cells, .values = {limit}, .kind = Invariant::Kind::kAtMost});
  }
}

void Finder::Guess() {
  for (size_t i = 0; i < bits_.size(); ++i) {
    const uint8_t own = seen_pairs_[i * bits_.size() + i];  // combination 0 and 3 only
    if (own == 1 || own == 8) {
      guesses_.push_back({.cells = {bits_[i]}, .values = {own == 1 ? uint64_t{0} : uint64_t{1}}});
      continue;
    }
    for (size_t j = i + 1; j < bits_.size(); ++j) {
      const uint8_t other = seen_pairs_[j * bits_.size() + j];
      if (other == 1 || other == 8) continue;
      for (uint64_t combination = 0; combination < 4; ++combination) {
        if ((seen_pairs_[i * bits_.size() + j] >> combination & 1) != 0) continue;
        guesses_.push_back({.cells = {bits_[i], bits_[j]}, .values = {combination}, .kind = Invariant::Kind::kNoneOf});
      }
    }
  }
  for (size_t i = 0; i < fields_.size(); ++i) {
    GuessLimits({fields_[i]}, greatest_fields_[i]);
    if (seen_fields_[i].size() > kMostValues) continue;
    guesses_.push_back({.cells = {fields_[i]}, .values = {seen_fields_[i].begin(), seen_fields_[i].end()}});
  }
  for (size_t i = 0; i < bytes_.size(); ++i) {
    GuessLimits(bytes_[i], greatest_bytes_[i]);
    if (seen_bytes_[i].size() > kMostValues) continue;
    guesses_.push_back({.cells = bytes_[i], .values = {seen_bytes_[i].begin(), seen_bytes_[i].end()}});
  }
}

void Finder::DropWrongAtPowerOn() {
  std::erase_if(guesses_, [this](const Invariant& guess) {
    if (std::chrono::steady_clock::now() >= deadline_) return true;
    const terms::TermId wrong =
        terms_.Not(ConditionOf(terms_, guess, [this](execute::CellId cell) { return init_.next[cell.index]; }));
    if (terms_.IsFalse(wrong)) return false;
    return solver_.Check({&wrong, 1}, 1000) != solver::Answer::kNever;
  });
}

bool Finder::Prove() {
  for (;;) {
    if (guesses_.empty()) return true;
    const auto rest =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - std::chrono::steady_clock::now());
    if (rest.count() <= 0) return false;
    // They have to outlive each part, in whatever order the parts come.
    std::vector<terms::TermId> conditions, fails;
    terms::TermId any = terms_.Bit(false);
    for (const Invariant& guess : guesses_) {
      conditions.push_back(ConditionOf(terms_, guess, [this](execute::CellId cell) { return Current(cell); }));
      terms::TermId fails_somewhere = terms_.Bit(false);
      for (const Transition& part : parts_) {
        const terms::TermId holds = ConditionOf(terms_, guess, [&](execute::CellId cell) { return Next(part, cell); });
        fails_somewhere = terms_.Or(fails_somewhere, terms_.Not(holds));
      }
      fails.push_back(fails_somewhere);
      any = terms_.Or(any, fails_somewhere);
    }
    if (terms_.IsFalse(any)) return true;
    conditions.push_back(any);
    const solver::Answer answer = solver_.Check(conditions, static_cast<uint32_t>(rest.count()));
    if (answer == solver::Answer::kNever) return true;
    if (answer == solver::Answer::kUnknown) return false;
    std::vector<Invariant> kept;
    for (size_t i = 0; i < guesses_.size(); ++i) {
      if (solver_.ValueOf(fails[i]) == 0) kept.push_back(std::move(guesses_[i]));
    }
    guesses_ = std::move(kept);
  }
}

std::vector<Invariant> Finder::Find(std::span<const execute::CellId> cells, uint64_t milliseconds) {
  deadline_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
  now_ = terms_.Variable("alone now", 32);
  const auto initial = [this](execute::CellId cell) { return Current(cell); };
  for (const Part part : {Part::kFast, Part::kPeriod}) {
    if (part == Part::kFast && !HasFastPart(version_)) continue;
    parts_.push_back(RunPart(terms_, version_, part, {.initial = initial, .now = now_, .outputs = {}}));
    if (!parts_.back().refusal.empty()) return {};
  }
  init_ = RunInit(terms_, version_, {.initial = initial, .now = now_, .outputs = {}});
  if (!init_.refusal.empty()) return {};
  CloseOver(cells);
  const std::set<execute::CellId> interesting(cells.begin(), cells.end());
  std::set<uint32_t> bytes_taken;
  for (const execute::CellId id : interesting) {
    const execute::Cell cell = execute::CellAt(*version_.program, version_.cells, id);
    if (is_input_(id) || cell.kind == execute::CellKind::kCalls) continue;
    if (cell.kind == execute::CellKind::kField && execute::CellWidth(*version_.program, cell) > 1) {
      fields_.push_back(id);
      continue;
    }
    if (bits_.size() < kMostBits) bits_.push_back(id);
    if (cell.kind != execute::CellKind::kBit || !bytes_taken.insert(id.index - cell.bit).second) continue;
    std::vector<execute::CellId> byte;
    for (uint32_t bit = 8; bit-- > 0;) byte.emplace_back(id.index - cell.bit + bit);
    if (std::ranges::all_of(byte, [&](execute::CellId bit) { return std::ranges::binary_search(state_, bit); })) {
      bytes_.push_back(byte);
    }
  }
  seen_pairs_.assign(bits_.size() * bits_.size(), 0);
  seen_fields_.resize(fields_.size());
  seen_bytes_.resize(bytes_.size());
  greatest_fields_.resize(fields_.size());
  greatest_bytes_.resize(bytes_.size());
  Simulate();
  Guess();
  DropWrongAtPowerOn();
  if (!Prove()) guesses_.clear();
  return std::move(guesses_);
}

}  // namespace

terms::TermId ConditionOf(terms::Terms& terms, const Invariant& invariant,
                          const std::function<terms::TermId(execute::CellId)>& value) {
  terms::TermId number;
  for (const execute::CellId cell : invariant.cells) {
    const terms::TermId part = value(cell);
    number = number.valid() ? terms.Concat(number, part) : part;
  }
  if (invariant.kind == Invariant::Kind::kAtMost) {
    return terms.Ule(number, terms.Const(invariant.values.front(), terms.Width(number)));
  }
  terms::TermId any = terms.Bit(false);
  for (const uint64_t one : invariant.values)
    any = terms.Or(any, terms.Eq(number, terms.Const(one, terms.Width(number))));
  return invariant.kind == Invariant::Kind::kNoneOf ? terms.Not(any) : any;
}

std::vector<Invariant> FindInvariants(terms::Terms& terms, solver::Solver& solver, const Version& version,
                                      std::span<const execute::CellId> cells,
                                      const std::function<bool(execute::CellId)>& is_input, uint64_t milliseconds) {
  return Finder(terms, solver, version, is_input).Find(cells, milliseconds);
}

}  // namespace plcxx::prove::compare
