// Lowers a syntax tree of dialect nc110 to IR (specification sections 4, 6 and 7).
//
// In: a whole tree, settings. Out: a program with the routines init, fast, slow, period and fast_only, its memory map
// and its schedule. Erroneous parts, already reported, become poison. Not its job: warnings (usage.h), tables of
// texts (messages_file.h), documentation.
//
// Slices: the number may still be found by passes/cut_slices, so nothing here depends on it. A prologue that runs
// before slice 0 sets `slow_open`, an epilogue after the last slice clears it; the fast part sees by it that a slow
// cycle is half done (j != 0 of 4.3), and `period` counts `slice` on while it is set. With one slice neither exists.
#pragma once

#include "transpiler/dialects/nc110/machine/options.h"
#include "transpiler/dialects/nc110/syntax/syntax.h"
#include "transpiler/ir/program.h"
#include "transpiler/source/source.h"

namespace plcxx::nc110 {

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources);

}  // namespace plcxx::nc110
