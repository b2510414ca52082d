// Internal memory, cleared by power-off, that one version uses and the other one does not: how that version does
// something. It is in no pair of a comparison, so that nothing is claimed of it.
#pragma once

#include <vector>

#include "transpiler/prove/diff/match.h"

namespace plcxx::prove::diff {

/// Internal memory that power-off clears: nobody but the version itself knows of it.
bool IsPrivate(const machine::Version& version, execute::CellId cell);

/// What is left out of a comparison: cells that their version writes, and those that the other version does not have
/// and that nobody writes, but that begin as something else than 0.
struct OneSided {
  std::vector<execute::CellId> old_only, new_only;
  std::vector<execute::CellId> old_values, new_values;
};

class OneSidedMemory {
 public:
  /// All that it refers to outlives it.
  OneSidedMemory(const machine::Version& old_version, const machine::Version& new_version,
                 const machine::Uses& old_uses, const machine::Uses& new_uses, const Match& match)
      : old_(old_version), new_(new_version), old_uses_(old_uses), new_uses_(new_uses), match_(match) {}

  /// Of a matched cell of the old version.
  bool Has(execute::CellId old_cell) const;
  OneSided Find() const;

 private:
  const machine::Version& old_;
  const machine::Version& new_;
  const machine::Uses& old_uses_;
  const machine::Uses& new_uses_;
  const Match& match_;
};

}  // namespace plcxx::prove::diff
