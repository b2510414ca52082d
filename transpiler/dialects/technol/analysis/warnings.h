// What is suspicious in a program without being wrong (specification 10.3): reads and writes that miss each other,
// double coils, requests, mechanisms that nothing starts. Those of paths are in flow_checks.h, those of text in the
// parser.
#pragma once

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/technol/analysis/flow.h"

namespace plcxx::technol {

/// TW006 to TW009, TW012 to TW014, TW024, TW025; of a program without errors.
void Warn(const Flow& flow, diag::Engine& diagnostics);

}  // namespace plcxx::technol
