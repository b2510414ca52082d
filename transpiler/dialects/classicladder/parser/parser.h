// The parser of dialect classicladder: a .clp project to one syntax tree, with every fault reported.
//
// In: loaded files in program order, settings. Out: a tree that is always whole; when nothing was reported as an error,
// everything that it names is there. Where the engine would write beyond its memory or read what is not there, there is
// an error; where it does something that nobody expects, it is followed and there is a warning.
#pragma once

#include <span>
#include <string>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/classicladder/machine/options.h"
#include "transpiler/dialects/classicladder/syntax/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::classicladder {

Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files, const Settings& settings,
              diag::Engine& diagnostics);

/// One line of the project per line, "line:column kind text", for `plcxx print tokens`.
std::string PrintTokens(const source::SourceManager& sources, source::FileId file);
/// Sections, rungs, elements, tables: one per line, for `plcxx print syntax`.
std::string PrintSyntax(const source::SourceManager& sources, const Program& program);

}  // namespace plcxx::classicladder
