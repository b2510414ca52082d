#include "transpiler/prove/diff/joint_run.h"

#include <algorithm>
#include <array>
#include <utility>

#include "transpiler/support/low_bits.h"
#include "transpiler/symbolic/terms/cone.h"
#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::prove::diff {
namespace {

constexpr size_t kMostTerms = 100'000;

void Put(std::vector<uint64_t>& variables, const VariablePart& to, uint64_t value) {
  const uint64_t mask = support::LowBits(to.width) << to.low;
  uint64_t& variable = variables[to.variable];
  variable = (variable & ~mask) | (value << to.low & mask);
}

}  // namespace

std::optional<VariablePart> JointRun::PartOf(Which which, execute::CellId cell) {
  const terms::TermId initial = comparison_.pairing.Initial(which, cell);
  const terms::Term& term = terms_[initial];
  const bool is_part = term.kind == terms::TermKind::kExtract;
  const terms::Term& variable = is_part ? terms_[terms::TermId(term.a)] : term;
  if (variable.kind != terms::TermKind::kVariable) return std::nullopt;
  return VariablePart{.variable = variable.a, .low = static_cast<uint8_t>(is_part ? term.b : 0), .width = term.width};
}

JointRun::Step JointRun::StepOf(std::span<const machine::Transition* const> sides) {
  Step step;
  for (const Which which : {Which::kOld, Which::kNew}) {
    const machine::Version& version = comparison_.pairing.version(which);
    const std::vector<terms::TermId>& next = sides[which == Which::kOld ? 0 : 1]->next;
    for (uint32_t i = 0; i < version.cells.calls; ++i) {
      const execute::CellId cell(i);
      if (!next[i].valid() || !machine::IsState(version, cell)) continue;
      // Of an equal pair the old version's value is the value of both.
      if (which == Which::kNew) {
        const execute::CellId old_cell = comparison_.match.old_of_new[i];
        if (old_cell.valid() && comparison_.pairing.IsEqual(old_cell) && sides[0]->next[old_cell.index].valid())
          continue;
      }
      const std::optional<VariablePart> to = PartOf(which, cell);
      if (!to || comparison_.pairing.Initial(which, cell) == next[i]) continue;
      step.assignments.push_back({*to, next[i]});
    }
  }
  return step;
}

bool JointRun::Prepare() {
  const std::optional<std::array<machine::Transition, 2>> init = ExecutePowerOn(comparison_);
  if (!init) return false;
  init_ = StepOf(std::array{&(*init)[0], &(*init)[1]});
  for (const machine::Part part : PartsOf(comparison_)) {
    if (!ExecutePart(comparison_, part, machine::HostAnswers::kNothing)) return false;
    parts_.push_back(StepOf(std::array{&comparison_.old_next, &comparison_.new_next}));
  }
  for (const PairResult& result : comparison_.results) {
    // Where the versions have two variables they would get two values.
    if (!comparison_.IsInput(result.old_cell) || !comparison_.pairing.IsEqual(result.old_cell)) continue;
    if (const std::optional<VariablePart> part = PartOf(Which::kOld, result.old_cell)) inputs_.push_back(*part);
  }
  for (const Which which : {Which::kNew, Which::kOld}) {
    const machine::Version& version = comparison_.pairing.version(which);
    for (uint32_t i = 0; i < version.cells.count; ++i) {
      const execute::CellId cell(i);
      if (!machine::IsState(version, cell)) continue;
      if (const std::optional<VariablePart> part = PartOf(which, cell)) memory_.push_back({which, cell, *part});
    }
  }
  values_.resize(terms_.size());
  variables_.resize(terms_.variable_count());
  is_answer_.assign(terms_.variable_count(), true);
  is_answer_[terms_[comparison_.now].a] = false;
  for (const Memory& memory : memory_) is_answer_[memory.part.variable] = false;
  return true;
}

namespace {

/// The digits of each variable that terms are computed from: a byte may hold eight flags.
class NeededDigits {
 public:
  explicit NeededDigits(const terms::Terms& terms) : terms_(terms), digits_(terms.variable_count()) {}

  bool Has(const VariablePart& part) const { return (digits_[part.variable] & DigitsOf(part.low, part.width)) != 0; }
  void Add(const VariablePart& part) { Add(part.variable, DigitsOf(part.low, part.width)); }
  /// What `id` reads itself.
  void AddReadBy(terms::TermId id) {
    const terms::Term& term = terms_[id];
    terms_.ForEachOperand(term, [&](terms::TermId operand) {
      const terms::Term& read = terms_[operand];
      if (read.kind != terms::TermKind::kVariable) return;
      const bool is_part = term.kind == terms::TermKind::kExtract;
      Add(read.a, is_part ? DigitsOf(static_cast<uint8_t>(term.b), term.width) : DigitsOf(0, read.width));
    });
  }
  void AddWhole(terms::TermId id) {
    const terms::Term& term = terms_[id];
    if (term.kind == terms::TermKind::kVariable) Add(term.a, DigitsOf(0, term.width));
  }
  bool TakeGrown() { return std::exchange(has_grown_, false); }

 private:
  static uint64_t DigitsOf(uint8_t low, uint8_t width) { return support::LowBits(width) << low; }
  void Add(uint32_t variable, uint64_t digits) {
    has_grown_ |= (digits & ~digits_[variable]) != 0;
    digits_[variable] |= digits;
  }

  const terms::Terms& terms_;
  std::vector<uint64_t> digits_;  // by variable
  bool has_grown_ = false;
};

}  // namespace

bool JointRun::Restrict(std::span<const VariablePart> looked_at) {
  NeededDigits needed(terms_);
  for (const VariablePart& part : looked_at) needed.Add(part);
  const auto find_cone = [&](Step& step) {
    std::vector<terms::TermId> roots;
    for (const Assignment& assignment : step.assignments) {
      if (needed.Has(assignment.to)) roots.push_back(assignment.value);
    }
    for (const terms::TermId root : roots) needed.AddWhole(root);
    step.cone = terms::ConeOf(terms_, roots);
    for (const terms::TermId id : step.cone) needed.AddReadBy(id);
  };
  while (needed.TakeGrown() && !comparison_.Late()) {
    find_cone(init_);
    std::ranges::for_each(parts_, find_cone);
  }
  size_ = 0;
  for (const Step& part : parts_) size_ += part.cone.size();
  if (comparison_.Late() || size_ > kMostTerms) return false;
  const auto is_left_out = [&](const Assignment& assignment) { return !needed.Has(assignment.to); };
  std::erase_if(init_.assignments, is_left_out);
  for (Step& part : parts_) std::erase_if(part.assignments, is_left_out);
  return true;
}

void JointRun::PowerOn() {
  std::ranges::fill(variables_, 0);
  now_ms = 0;
  Execute(init_);
}

void JointRun::Take(const invariants::CellValues& of_old, const invariants::CellValues& of_new, uint64_t seen_ms) {
  std::ranges::fill(variables_, 0);
  now_ms = seen_ms;
  for (const Memory& memory : memory_)
    Put(variables_, memory.part, (memory.which == Which::kOld ? of_old : of_new)(memory.cell));
}

void JointRun::Execute(size_t part) { Execute(parts_[part]); }

void JointRun::Execute(const Step& step) {
  ++step_;
  const uint32_t now = terms_[comparison_.now].a;
  const auto answer = [this](uint32_t variable) {
    return (step_ * 0x9E3779B97F4A7C15 ^ variable) * 0xBF58476D1CE4E5B9;
  };
  for (const terms::TermId id : step.cone) {
    values_[id.index] = terms::EvaluateTerm(
        terms_, terms_[id], [this](terms::TermId operand) { return values_[operand.index]; },
        [&](uint32_t variable) {
          if (variable == now) return now_ms;
          return is_answer_[variable] ? answer(variable) >> 32 : variables_[variable];
        });
  }
  for (const Assignment& assignment : step.assignments) Put(variables_, assignment.to, values_[assignment.value.index]);
}

void JointRun::SetInput(size_t input, uint64_t value) { Put(variables_, inputs_[input], value); }

uint64_t JointRun::ValueOf(const VariablePart& part) const {
  return variables_[part.variable] >> part.low & support::LowBits(part.width);
}

}  // namespace plcxx::prove::diff
