// The parser of dialect prostep: source files to one syntax tree, with every fault reported that needs no control flow
// (specification sections 2, 3, 6.1.3, 6.1.4, 6.9 and 9).
//
// In: loaded files in program order. Out: a tree that is always whole. Not its job: what needs the whole program
// (program_checks.h) and what needs its paths (lowering).
#pragma once

#include <span>
#include <string>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/prostep/syntax/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::prostep {

Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files, diag::Engine& diagnostics);

/// One token per line, "line:column kind text", for `plcxx print tokens`.
std::string PrintTokens(const source::SourceManager& sources, source::FileId file);
/// Declarations, then modules with one instruction per line, for `plcxx print syntax`.
std::string PrintSyntax(const source::SourceManager& sources, const Program& program);

/// The instruction as people write it: "SP T 5", "JU FM 0", "><"; of jumps with their label.
std::string ToText(const Program& program, const Instruction& instruction);

}  // namespace plcxx::prostep
