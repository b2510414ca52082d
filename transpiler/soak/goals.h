// What a soak is to cover: statements executed, conditions seen both ways, cases of switches taken.
//
// A condition is a bit that a statement reads or decides: a contact, a comparison, what a timer gives, what is stored
// in a coil or branched on. Intermediate results of bit logic are none. Steps of sequences and mechanisms are cases of
// switches, or conditions of the statements that ask for the step. In: a program, and what its instructions gave. Out:
// goals by number, the same for the same program everywhere.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::soak {

enum class GoalKind : uint8_t { kStatement, kCondition, kCase };

struct Goal {
  GoalKind kind{};
  ir::StatementId statement;
  std::vector<ir::InstId> insts;  // one of them is enough
  uint8_t given = 0;              // bits of Simulator::NoteGiven, one of which is to be seen
};

/// A set of goals, by number.
class GoalSet {
 public:
  GoalSet() = default;
  explicit GoalSet(size_t goals) : words_((goals + kBits - 1) / kBits) {}

  bool Has(size_t goal) const { return (words_[goal / kBits] >> goal % kBits & 1) != 0; }
  void Add(size_t goal) { words_[goal / kBits] |= uint64_t{1} << goal % kBits; }
  void Add(const GoalSet& other);
  void Remove(const GoalSet& other);
  size_t Count() const;
  /// Of those that both have.
  size_t CountShared(const GoalSet& other) const;
  bool operator==(const GoalSet&) const = default;

  /// Hexadecimal digits, the goals of lower numbers first.
  std::string ToHex() const;
  /// False: it is none of so many goals.
  bool FromHex(const std::string& digits, size_t goals);

 private:
  static constexpr size_t kBits = 64;
  std::vector<uint64_t> words_;
};

class Goals {
 public:
  explicit Goals(const ir::Program& program);

  const std::vector<Goal>& all() const { return goals_; }
  GoalSet Reached(std::span<const uint8_t> given) const;

 private:
  void Walk(ir::RegionId region, ir::StatementId statement);
  void MarkDecision(uint32_t value);

  const ir::Program& program_;
  std::vector<Goal> goals_;
  std::vector<ir::StatementId> statement_of_;  // by InstId, while goals are made
  std::vector<bool> is_decision_;
};

}  // namespace plcxx::soak
