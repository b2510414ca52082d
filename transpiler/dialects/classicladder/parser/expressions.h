// Expressions of compare and operate boxes: their text to nodes, read as the engine's evaluator reads it.
//
// The engine evaluates the text in every scan. What it would report there is an error here; what it passes over is
// passed over, with a warning.
#pragma once

#include <string_view>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/classicladder/syntax/syntax.h"

namespace plcxx::classicladder {

/// "left < right" of a compare box.
Expression ParseComparison(const ExpressionText& text, LinuxCnc version, diag::Engine& diagnostics);
/// "variable := right" of an operate box.
Expression ParseOperation(const ExpressionText& text, LinuxCnc version, diag::Engine& diagnostics);

}  // namespace plcxx::classicladder
