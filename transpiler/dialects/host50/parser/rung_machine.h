// The rung machine of an instruction list (specification 6.1), evaluated at compile time.
//
// In: the instructions of a network as they are written. Out: what each of them takes (Instruction::input and other,
// Pin::result), errors E201 to E209, notes N03. ACC is undefined until the first LD; the block stack holds what LD
// pushes while ACC is live, the branch stack what MPS keeps. After an unknown instruction or an error nothing more is
// said until RUNG or the end of the network.
#pragma once

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/host50/syntax/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::host50 {

void EvaluateRungs(Program& program, NetworkId network, const source::SourceManager& sources,
                   diag::Engine& diagnostics);

}  // namespace plcxx::host50
