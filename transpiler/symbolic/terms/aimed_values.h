// Values for variables by which a condition is likely to hold that hardly ever does for random ones.
//
// a & b is 1 where both are, so both are aimed at; a choice is what is wanted where a branch can be, and the condition
// chooses it; x + 3 is 7 where x is 4. What is fixed first stays: nothing is taken back, so an aim may be missed, and
// who asks evaluates. In: a term and a value for it. Out: bits of variables. Not its job: whether it can be met at all.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "transpiler/symbolic/terms/random.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

class AimedValues {
 public:
  AimedValues(const Terms& terms, uint64_t seed) : terms_(terms), random_(seed) {}

  /// Forgets what was aimed at before. What is left open is chosen by chance, another time another way.
  void AimAt(TermId term, uint64_t value);
  /// `otherwise` where no bit of the variable is fixed, and its bits where some are not.
  uint64_t Of(TermId variable, uint64_t otherwise) const;

 private:
  /// These bits of a term are to be those of `bits`.
  struct Aim {
    TermId term;
    uint64_t mask = 0, bits = 0;
  };
  void Add(uint32_t term, uint64_t mask, uint64_t bits);
  void Meet(const Aim& aim);
  void MeetAndOr(const Term& term, const Aim& aim);
  void MeetComparison(const Term& term, bool holds);
  void MeetUnequal(TermId a, TermId b);
  void Fix(TermId variable, const Aim& aim);
  bool MayBe(TermId term, const Aim& aim) const;

  const Terms& terms_;
  Random random_;
  std::vector<Aim> open_;                        // the last one next
  std::unordered_map<uint32_t, Aim> variables_;  // by TermId; looked up only
};

}  // namespace plcxx::terms
