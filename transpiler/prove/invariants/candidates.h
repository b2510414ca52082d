// What may hold in every state of a version, guessed from the states in which it was seen.
//
// In: states. Out: clauses over bits and numbers that no state breaks, and that say something. Not its job: proofs
// (invariants.h), where the states come from.
#pragma once

#include <bitset>
#include <cstdint>
#include <set>
#include <vector>

#include "transpiler/prove/invariants/invariants.h"

namespace plcxx::prove::invariants {

class Candidates {
 public:
  /// `cells`: of interest, without inputs. A byte, and a word that the program reads or writes as one, counts as a
  /// number when `is_state` has all its bits.
  Candidates(const machine::Version& version, std::span<const execute::CellId> cells,
             const std::function<bool(execute::CellId)>& is_state);

  void AddState(const CellValues& state);
  /// The numbers may have a constant of the program as their limit, though no state came near it: constants of what
  /// was executed, and of the whole program.
  void AddConstant(uint64_t constant) { AddNeighbours(limits_, constant); }
  void AddConstantsOf(const ir::Program& program);

  std::vector<Invariant> Make() const;

 private:
  static constexpr size_t kMostBits = 96;  // that are looked at two by two

  /// The bits of interest that were 1, and those that were 0, in states in which a number had this value.
  struct SeenValue {
    uint64_t value = 0;
    std::bitset<kMostBits> ones, zeros;
  };
  /// A field, a byte or a word of memory.
  struct SeenNumber {
    std::vector<execute::CellId> cells;  // from the most significant down
    uint8_t width = 8;
    std::vector<SeenValue> values;  // as they came; more than the most that are said: many
    uint64_t greatest = 0;
    std::vector<uint64_t> greatest_ones, greatest_zeros;  // by bit of interest: while it is 1, and 0
    /// By number, of the first ones: the greatest value that it had while this one had its values, as they came.
    std::vector<std::vector<uint64_t>> greatest_of;
  };

  static void AddNeighbours(std::set<uint64_t>& limits, uint64_t constant) {
    limits.insert({constant - 1, constant, constant + 1});
  }
  void AddWords(const machine::Version& version, const std::set<execute::CellId>& interesting,
                const std::function<bool(execute::CellId)>& is_state);
  void AddSteps(const CellValues& state);
  void AddBits(std::vector<Invariant>& guesses) const;
  void AddLimits(const SeenNumber& number, std::vector<Invariant>& guesses) const;
  /// What a number does not exceed while a bit is set, or is not: a time that ends a step.
  void AddLimitsWhile(const SeenNumber& number, std::vector<Invariant>& guesses) const;
  /// What a number does not exceed while another one, which takes few values, has one of them: what is counted in a
  /// step.
  void AddLimitsInSteps(std::vector<Invariant>& guesses) const;
  /// What a number may be while a bit is set, or is not.
  void AddWhile(const SeenNumber& number, std::vector<Invariant>& guesses) const;

  std::vector<execute::CellId> bits_;
  std::vector<SeenNumber> numbers_;
  std::vector<uint8_t> seen_pairs_;  // by two bits: which of the four combinations occurred
  std::set<uint64_t> limits_, program_limits_;
};

}  // namespace plcxx::prove::invariants
