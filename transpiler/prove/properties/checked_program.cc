#include "transpiler/prove/properties/checked_program.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "transpiler/prove/machine/answers.h"
#include "transpiler/prove/machine/requests.h"
#include "transpiler/symbolic/execute/execute.h"
#include "transpiler/symbolic/terms/cone.h"

namespace plcxx::prove::properties {
namespace {

/// Whether what the program begins with depends on what the host answers and writes at power-on.
bool DependsOnPowerOn(const CheckedProgram& checked) {
  const std::vector<terms::TermId>& state = checked.answered->after_power_on();
  for (uint32_t i = 0; i < checked.version.cells.calls && i < state.size(); ++i) {
    const execute::CellId cell(i);
    if (!checked.inputs[i] && machine::IsState(checked.version, cell) && !checked.terms.IsConst(state[i])) return true;
  }
  return false;
}

}  // namespace

CheckedProgram::CheckedProgram(const machine::Version& checked_version, const CheckOptions& check_options)
    : version(checked_version),
      options(check_options),
      inputs(machine::InputsOf(version)),
      requests(machine::RequestCells(version)) {
  solver::LoadedSolver loaded = solver::LoadSolver(terms);
  solver = std::move(loaded.solver);
  refusal = std::move(loaded.reason);
  if (!refusal.empty()) return;
  new_each_time = inputs;
  for (uint32_t i = 0; i < version.cells.count; ++i)
    new_each_time[i] = inputs[i] || machine::IsInbox(version, execute::CellId(i));
  silent = std::make_unique<machine::Relation>(terms, version, machine::HostAnswers::kNothing);
  if (machine::AnswersMatter(version))
    any = std::make_unique<machine::Relation>(terms, version, machine::HostAnswers::kAny, silent.get());
  const bool any_retentive = options.retentive == RetentiveMemory::kAny;
  plain = std::make_unique<machine::Unrolled>(
      terms, *silent, inputs, any_retentive ? machine::Start::kAnyRetentive : machine::Start::kPowerOn, "run");
  answered = std::make_unique<machine::Unrolled>(
      terms, Widest(), inputs, any_retentive ? machine::Start::kAnyRetentive : machine::Start::kAnsweredPowerOn,
      "answered run");
  if (!any && (any_retentive || !DependsOnPowerOn(*this))) answered.reset();
  anywhere = std::make_unique<machine::Unrolled>(terms, Widest(), inputs, machine::Start::kAnywhere, "any");
  for (machine::Unrolled* const unrolled : {plain.get(), answered.get(), anywhere.get()}) {
    if (unrolled == nullptr) continue;
    unrolled->late = [this] { return Late(); };
    // Without answers nothing is ever done that the program asks for: as scenarios do it, the bit is taken back. So it
    // may be between two parts, whatever the control does in them.
    if (any) unrolled->taken_back = requests;
  }
  refusal = plain->refusal();
  if (refusal.empty()) refusal = anywhere->refusal();
}

uint32_t CheckedProgram::RestMs() const {
  const auto rest =
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now()).count();
  return static_cast<uint32_t>(std::clamp<int64_t>(rest, 0, std::numeric_limits<int32_t>::max()));
}

ValueAfter ValuesOf(machine::Unrolled& unrolled) {
  return [&unrolled](execute::CellId cell, uint32_t period) { return unrolled.Value(cell, period); };
}

bool Extend(const CheckedProgram& checked, machine::Unrolled& unrolled, uint32_t periods, PropertyResult& result) {
  while (unrolled.periods() < periods) unrolled.Advance();
  if (checked.Late()) result.reason = kNoTime;
  return checked.Late();
}

std::string WhyUnknown(const CheckedProgram& checked) {
  return checked.too_large ? "what it depends on is too much for the solver" : kNoTime;
}

solver::Answer Ask(CheckedProgram& checked, std::span<const terms::TermId> conditions, uint32_t milliseconds) {
  // What was made when the time was over means nothing.
  checked.too_large = false;
  if (checked.Late()) return solver::Answer::kUnknown;
  // The solver's time begins when it has read the question.
  checked.too_large = terms::ConeOf(checked.terms, conditions).size() > kMostQuestionTerms;
  if (checked.too_large) return solver::Answer::kUnknown;
  return checked.solver->Check(conditions, solver::Limit::Clock(std::max(1U, milliseconds)));
}

std::vector<execute::CellId> OperandCellsOf(const Property& property) {
  std::vector<execute::CellId> cells;
  for (const PropertyOperand& operand : property.operands)
    cells.insert(cells.end(), operand.cells.begin(), operand.cells.end());
  return cells;
}

std::string Periods(uint32_t count) { return std::to_string(count) + (count == 1 ? " period" : " periods"); }

}  // namespace plcxx::prove::properties
