// The parser of dialect nc110: source files to one syntax tree, with every fault of syntax, type, range,
// symbol and block structure reported (specification sections 2, 3, 6, 9.1, 9.7).
//
// In: loaded files in program order. Out: a tree that is always whole. Not its job: what needs the whole
// program's reads and writes (zones, double coils, drivers of timers), messages files, budgets.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/nc110/machine/options.h"
#include "transpiler/dialects/nc110/syntax/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::nc110 {

/// The files of one program, in order. More than 10 files: error 51 and an empty tree.
Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files, const ParseOptions& options,
              diag::Engine& diagnostics);

/// One token per line, "line:column kind text", for `plcxx print tokens`.
std::string PrintTokens(const source::SourceManager& sources, source::FileId file, const ParseOptions& options);
/// One item per line with its expressions in prefix form, for `plcxx print syntax`.
std::string PrintSyntax(const source::SourceManager& sources, const Program& program);

}  // namespace plcxx::nc110
