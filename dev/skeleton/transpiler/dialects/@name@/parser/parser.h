// The parser of dialect @name@: source files to one syntax tree, with every fault reported.
//
// In: loaded files in program order. Out: a tree that is always whole.
#pragma once

#include <span>
#include <string>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/@name@/syntax/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::@name@ {

Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files, diag::Engine& diagnostics);

/// One token per line, "line:column kind text", for `plcxx print tokens`.
std::string PrintTokens(const source::SourceManager& sources, source::FileId file);
/// One statement per line, for `plcxx print syntax`.
std::string PrintSyntax(const source::SourceManager& sources, const Program& program);

}  // namespace plcxx::@name@
