// Names for cells, and the statements that write them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "transpiler/prove/machine/version.h"
#include "transpiler/review/diff/diff.h"

namespace plcxx::review::diff {

/// How people speak of a cell: the bit, word or field that the program uses there.
struct CellWord {
  std::string name;                    // "W3K0"
  std::string address;                 // where the name is another one: "DATA+3.5"
  std::optional<ir::Place> place;      // none: the program has no place there ("U byte 17")
  std::vector<execute::CellId> cells;  // of the word, from the least significant bit
};

class CellWords {
 public:
  /// `version` and the compilation outlive the object.
  CellWords(const prove::machine::Version& version, const compilation::Compilation& compilation);
  CellWord WordOf(execute::CellId cell) const;
  /// From the program's documentation; empty when there is none.
  std::string MeaningOf(const CellWord& word) const;
  /// Those of the compiled program, by which a scenario is read.
  const ir::NameIndex& compiled_names() const { return compiled_names_; }

 private:
  CellWord OfPlace(const ir::Place& place) const;
  bool IsNamed(const ir::Place& place) const;

  const prove::machine::Version& version_;
  const compilation::Compilation& compilation_;
  const ir::NameIndex compiled_names_, version_names_;
  std::map<uint32_t, ir::PlaceId> bits_;          // by cell
  std::map<uint32_t, ir::PlaceId> words_;         // by cell of its first bit: the smallest one that begins there
  mutable std::map<std::string, bool> is_named_;  // what has been asked so far
  std::unordered_map<std::string_view, const ir::Documentation*> known_;  // by address, the first row of each
};

/// Which statement reads and writes which cells.
struct StatementAccess {
  ir::StatementId statement;
  uint32_t begin = 0, end = 0;  // cells
  bool writes = false;
};
std::vector<StatementAccess> AccessesOf(const prove::machine::Version& version);

/// By statement: those that decide whether it is executed, the heads of the blocks around it and the calls of its
/// routine; of those again to be asked.
using StatementHeads = std::map<ir::StatementId, std::set<ir::StatementId>>;
StatementHeads HeadsOf(const prove::machine::Version& version);
/// By statement: its heads, and the statements that computed what it uses, as those of an accumulator before it.
StatementHeads NeededBy(const prove::machine::Version& version);
/// The statements with all that they need, and what that needs.
std::set<ir::StatementId> WithNeeded(const StatementHeads& needed, const std::set<ir::StatementId>& statements);

}  // namespace plcxx::review::diff
