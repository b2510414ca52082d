// The state of two versions as variables: what is assumed equal is one variable, the rest is one for each version.
#pragma once

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transpiler/prove/diff/match.h"
#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::diff {

enum class Which : uint8_t { kOld, kNew };

class Pairing {
 public:
  /// All refer to what outlives the pairing.
  Pairing(terms::Terms& terms, const machine::Version& old_version, const machine::Version& new_version,
          const Match& match);

  /// The value of a cell before the period; the same variable for both where the cells are `equal`.
  terms::TermId Initial(Which which, execute::CellId cell);
  bool IsEqual(execute::CellId old_cell) const { return equal_[old_cell.index]; }
  /// From now on the versions' cells are two variables.
  void Separate(execute::CellId old_cell) { equal_[old_cell.index] = false; }
  void Join(execute::CellId old_cell) { equal_[old_cell.index] = true; }

  /// By cell of each version: the value that it has in every state that can be reached; none where there is no such
  /// one, or nothing at all. Initial gives it from now on, of an equal pair where both have the same.
  void SetConstants(std::vector<terms::TermId> old_constants, std::vector<terms::TermId> new_constants) {
    old_constants_ = std::move(old_constants);
    new_constants_ = std::move(new_constants);
  }
  /// Both versions never change it, and have the same in it.
  bool IsConstantPair(execute::CellId old_cell) const {
    const terms::TermId constant = ConstantOf(Which::kOld, old_cell);
    return constant.valid() && constant == ConstantOf(Which::kNew, match_.new_of_old[old_cell.index]);
  }

  const machine::Version& version(Which which) const { return which == Which::kOld ? old_ : new_; }
  const Match& match() const { return match_; }

 private:
  terms::TermId ConstantOf(Which which, execute::CellId cell) const {
    const std::vector<terms::TermId>& constants = which == Which::kOld ? old_constants_ : new_constants_;
    return cell.valid() && cell.index < constants.size() ? constants[cell.index] : terms::TermId();
  }
  /// Whose variable it is. What is equal has one for both versions, by the old one's cells.
  enum class Owner : uint8_t { kOld, kNew, kBoth };
  const machine::Version& VersionOf(Owner owner) const { return owner == Owner::kNew ? new_ : old_; }
  /// What a variable stands for: a cell, or the byte that begins with it.
  enum class Extent : uint8_t { kCell, kByte };
  /// Of the name of its variables.
  static std::string PrefixOf(Owner owner);
  terms::TermId Bit(Owner owner, execute::CellId cell);
  bool SharesByte(execute::CellId old_cell) const;
  terms::TermId& VariableOf(Owner owner, uint32_t cell, Extent extent);

  terms::Terms& terms_;
  const machine::Version& old_;
  const machine::Version& new_;
  const Match& match_;
  std::vector<bool> equal_;  // by old cell
  std::vector<terms::TermId> old_constants_, new_constants_;
  std::vector<bool> old_words_, new_words_;  // by cell of the first bit of a byte: it is part of a word somewhere
  std::unordered_map<uint64_t, terms::TermId> variables_;  // looked up only
};

}  // namespace plcxx::prove::diff
