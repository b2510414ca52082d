// The parser of dialect technol: sources to the syntax tree, everything that is decided from text and names included.
//
// In: the files of the command line (sources and a .TCH). Out: the tree; faults are reported, the tree is always whole.
// Not its job: what depends on paths through the program (see syntax.h).
#pragma once

#include <string>
#include <utility>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/technol/machine/options.h"
#include "transpiler/dialects/technol/syntax/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::technol {

/// Includes are read with the request's loader.
Program Parse(dialects::Request& request, const Settings& settings);

/// One token per line, "line:column kind text", for `plcxx print tokens`. A table has none.
std::string PrintTokens(const source::SourceManager& sources, source::FileId file);
/// Symbols, then units with one instruction per line, for `plcxx print syntax`.
std::string PrintSyntax(const source::SourceManager& sources, const Program& program);

/// The instruction as people write it: "LOD WORD.(LABEL_MEM+4)", "EX1", "MOV AX,5".
std::string ToText(const Program& program, const Instruction& instruction);
std::string ToText(const Program& program, const Operand& operand);

/// Adds the notes that lead from the call of a macro to the line of its body; nothing when `expansion` is none.
void AddNotes(diag::Diagnostic& diagnostic, const Program& program, ExpansionId expansion);

/// Reports about an instruction: in the expansion of a macro at the call, with the line of the macro as a note (10.4).
template <class... Args, class... Values>
diag::Diagnostic& Report(diag::Engine& diagnostics, const Program& program, const Instruction& instruction,
                         const diag::Message<Args...>& message, Values&&... values) {
  diag::Diagnostic& diagnostic = diagnostics.Report(instruction.range, message, std::forward<Values>(values)...);
  AddNotes(diagnostic, program, instruction.expansion);
  return diagnostic;
}

}  // namespace plcxx::technol
