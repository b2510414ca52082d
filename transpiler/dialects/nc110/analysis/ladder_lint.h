// W370: statements that the control's ladder editor cannot show (specification 9.8).
//
// In: a tree without errors. Out: one warning per statement, off unless asked for. Not its job: drawing ladders.
// "Word rungs that mix signals" of the specification cannot occur in a typed tree: MUX is an element of its own.
#pragma once

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/nc110/syntax/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::nc110 {

void LintLadder(const source::SourceManager& sources, const Program& program, diag::Engine& diagnostics);

}  // namespace plcxx::nc110
