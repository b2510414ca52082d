// Values for variables by which terms of programs are told apart: their own constants, and what they are compared with.
//
// A condition that asks for one value of a word would hardly ever hold else. In: terms. Out: values for their variables
// and for functions without meaning, one after the other. Not its job: evaluating.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "transpiler/symbolic/terms/random.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// Adds the constants of these terms that are wider than a bit; the values stay ascending, each once, and not too many.
void AddConstants(const Terms& terms, std::span<const TermId> cone, std::vector<uint64_t>& constants);

class LikelyValues {
 public:
  explicit LikelyValues(const Terms& terms) : terms_(terms) {}

  /// From now on the constants of these terms are likely.
  void NoteConstants(std::span<const TermId> cone) { AddConstants(terms_, cone, constants_); }
  /// From now on variables and results of functions are likely what these terms compare them with.
  void NoteComparisons(std::span<const TermId> cone);
  void ForgetComparisonsOfVariables() { compared_.clear(); }

  /// `vector`: which assignment it is of; they have bits of different density.
  uint64_t Of(int vector, TermId variable);
  /// What a function gives instead of the value that was made up for it, the same for the same one: any function will
  /// do, if equal arguments give equal results.
  uint64_t ResultOf(int vector, const Term& application, uint64_t made_up) const;

 private:
  uint64_t Any(int vector, uint8_t width);
  void NoteComparison(TermId compared, uint64_t value);

  const Terms& terms_;
  std::vector<uint64_t> constants_;
  std::unordered_map<uint32_t, std::vector<uint64_t>> compared_;  // by TermId of a variable; looked up only
  std::unordered_map<uint32_t, std::vector<uint64_t>> results_;   // by function without meaning; looked up only
  Random random_{0x9E3779B97F4A7C15};
};

}  // namespace plcxx::terms
