// How a statement that matters to a difference is shown: its place, and the line of it that was changed.
//
// In: a version's statements. Out: their lines for a reader. Not its job: which statements matter (compare.cc).
#pragma once

#include <set>
#include <string>
#include <vector>

#include "transpiler/review/diff/diff.h"

namespace plcxx::review::diff {

/// What a version says, without spaces that do not count.
struct StatementTexts {
  std::set<std::string> statements, lines;
};
StatementTexts TextsOf(const DiffSide& side);

/// The statements of one version that the other one does not have.
std::vector<ItemStatement> ChangedStatements(const DiffSide& side, const DiffSide& other);

ItemStatement StatementOf(const DiffSide& side, ir::StatementId id, const StatementTexts& other_texts);

/// Where a version's statements begin: the file of what has no statement of its own.
std::string FileOfProgram(const DiffSide& side);

/// Of changed statements of several lines that both versions have: the first line that the other one has not at this
/// place, though it may stand elsewhere.
void ShowChangedLines(const DiffSide& old_side, const DiffSide& new_side, DiffItem& item);

}  // namespace plcxx::review::diff
