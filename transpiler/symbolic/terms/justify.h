// Why a term has the value that it has: the bits of a few variables that fix it, whatever all others are.
//
// a & b is 0 because one of them is, a choice is what the chosen branch is, two words differ by one bit. Of several
// reasons the one with fewer variables is taken, as far as a sum over operands tells. In: a value for every term of a
// cone. Out: variables and their bits. Not its job: the smallest such set.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// A variable, or an application of an unknown function, and the bits of it that count.
struct Reason {
  TermId term;
  uint64_t bits = 0;
};

/// What an application of an unknown function is as a reason.
enum class UnknownFunction : uint8_t {
  kWithArguments,  // it counts, and so does what it is applied to
  kCounts,         // alone: like a variable
  kAvoided         // alone, and only where nothing else is a reason
};

class Justification {
 public:
  /// `cone`: ascending, with all operands; `values` by TermId. All outlive the object.
  Justification(const Terms& terms, std::span<const TermId> cone, const std::vector<uint64_t>& values);
  /// Of terms in which variables stand for others: `definitions`, by number of the variable, are of the cone and older
  /// than it; none for a variable that is any value. A defined variable is a reason, and costs what its definition
  /// does.
  Justification(const Terms& terms, std::span<const TermId> cone, const std::vector<uint64_t>& values,
                std::span<const TermId> definitions, std::function<UnknownFunction(const TermFunction&)> unknown);

  /// Why the term, which is of the cone, has its value; from the newest term to the oldest.
  std::vector<Reason> ReasonsFor(TermId term) const;
  /// Why these bits of several terms have their values.
  std::vector<Reason> ReasonsFor(std::span<const Reason> wanted) const;

 private:
  bool IsUnknown(const Term& term) const {
    return term.kind == TermKind::kApply && terms_.Info(FunctionId(term.a)).evaluate == nullptr;
  }
  UnknownFunction UnknownOf(const Term& term) const {
    return unknown_ ? unknown_(terms_.Info(FunctionId(term.a))) : UnknownFunction::kWithArguments;
  }
  uint32_t CostOf(const Term& term, uint64_t value) const;
  template <class Need>
  void Operands(const Term& term, uint64_t bits, Need&& need) const;

  uint64_t Value(uint32_t term) const { return values_[term]; }

  const Terms& terms_;
  const std::vector<uint64_t>& values_;
  std::span<const TermId> definitions_;                          // by number of the variable
  std::function<UnknownFunction(const TermFunction&)> unknown_;  // empty: all with their arguments
  std::vector<uint32_t> costs_;                                  // by TermId: about how many variables fix it
};

}  // namespace plcxx::terms
