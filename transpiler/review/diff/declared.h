// What two versions declare beside what they execute, and the host sees: when their parts run, messages, menus, tables.
// It is compared as it stands; see docs/review.md.
#pragma once

#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/review/diff/diff.h"

namespace plcxx::review::diff {

/// An item for each declaration that is another one, with its text in both versions: the schedule first, then texts and
/// tables, each as the program orders them. `old_program` and `new_program` as they run.
std::vector<DiffItem> CompareDeclarations(const ir::Program& old_program, const ir::Program& new_program);

}  // namespace plcxx::review::diff
