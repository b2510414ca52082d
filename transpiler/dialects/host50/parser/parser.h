// The parser of dialect host50: source files to one syntax tree, with every error of section 10.2 reported.
//
// In: loaded files in program order, options that overrule the source's directives. Out: a tree that is always whole,
// with the rung machine and the drawings evaluated (syntax.h). Not its job: warnings and notes (warnings.h).
#pragma once

#include <map>
#include <span>
#include <string>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/host50/syntax/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::host50 {

/// `options`: keys and values of the command line or a scenario, which CheckOptions has accepted.
Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files,
              const std::map<std::string, std::string>& options, diag::Engine& diagnostics);

/// What has been reported in a continued line moves to the first line of its statement (2.2).
void PlaceInFirstLines(const Program& program, diag::Engine& diagnostics);

/// One token per line, "line:column kind text", for `plcxx print tokens`.
std::string PrintTokens(const source::SourceManager& sources, source::FileId file);
/// Sections, networks and instructions, one per line, for `plcxx print syntax`.
std::string PrintSyntax(const source::SourceManager& sources, const Program& program);

}  // namespace plcxx::host50
