// What a statement says in other lines of its project: the expressions of a rung's boxes, the presets of its timers and
// counters, the steps and transitions of a sequential page.
//
// In: the ranges of statements. Out: for each the lines that it refers to. Not its job: what they mean (parser).
#pragma once

#include <span>
#include <vector>

#include "transpiler/source/source.h"

namespace plcxx::classicladder {

/// By index of `statements`: lines, of steps and transitions but for where they are drawn, in the order in which the
/// statement refers to them.
std::vector<std::vector<source::Range>> LinesElsewhere(const source::SourceManager& sources,
                                                       std::span<const source::Range> statements);

}  // namespace plcxx::classicladder
