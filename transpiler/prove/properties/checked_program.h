// A program as the checks of its properties see it: its parts as terms, its runs, and a solver that is asked.
//
// What the checks of several properties share is executed once. Not its job: what is asked (check.h).
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "transpiler/prove/machine/unroll.h"
#include "transpiler/prove/properties/condition.h"
#include "transpiler/prove/properties/result.h"
#include "transpiler/symbolic/solver/solver.h"

namespace plcxx::prove::properties {

constexpr const char* kNoTime = "the time was not enough";

struct CheckedProgram {
  /// Both outlive it.
  CheckedProgram(const machine::Version& checked_version, const CheckOptions& check_options);
  CheckedProgram(const CheckedProgram&) = delete;

  const machine::Version& version;
  const CheckOptions& options;
  terms::Terms terms;
  std::unique_ptr<solver::Solver> solver;
  std::string refusal;  // not empty: nothing can be checked, and why
  std::vector<bool> inputs;
  std::vector<bool> requests;       // by cell: see machine/requests.h
  std::vector<bool> new_each_time;  // by cell: inputs, and the operator's texts

  std::unique_ptr<machine::Relation> silent;    // the host answers 0
  std::unique_ptr<machine::Relation> any;       // it answers anything; none where that makes no difference
  std::unique_ptr<machine::Unrolled> plain;     // from power-on, the host answers 0
  std::unique_ptr<machine::Unrolled> answered;  // likewise, it answers anything; none where that makes no difference
  std::unique_ptr<machine::Unrolled> anywhere;  // from any state
  machine::Relation& Widest() const { return any ? *any : *silent; }
  /// From power-on, all that may happen.
  machine::Unrolled& Base() const { return answered ? *answered : *plain; }

  std::chrono::steady_clock::time_point deadline;  // of the present check
  uint32_t RestMs() const;
  bool Late() const { return RestMs() == 0; }
  void Report(const std::string& what) const {
    if (options.progress) options.progress(what);
  }

  bool too_large = false;  // the last question was not asked
};

/// What `attempt` gives within a part of the time that is left.
template <class Attempt>
auto Within(uint32_t milliseconds, CheckedProgram& checked, Attempt&& attempt) {
  const auto end = checked.deadline;
  checked.deadline = std::min(end, std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds));
  const auto given = attempt();
  checked.deadline = end;
  return given;
}

inline constexpr size_t kMostQuestionTerms = 250'000;

/// What the solver answers; kUnknown, too, when the question is so large that it would not come to an answer.
solver::Answer Ask(CheckedProgram& checked, std::span<const terms::TermId> conditions, uint32_t milliseconds);
/// Why the last answer was kUnknown.
std::string WhyUnknown(const CheckedProgram& checked);

ValueAfter ValuesOf(machine::Unrolled& unrolled);
/// Whether this is the end of the check: `result` has a verdict or a reason.
bool Extend(const CheckedProgram& checked, machine::Unrolled& unrolled, uint32_t periods, PropertyResult& result);

std::vector<execute::CellId> OperandCellsOf(const Property& property);
std::string Periods(uint32_t count);

}  // namespace plcxx::prove::properties
