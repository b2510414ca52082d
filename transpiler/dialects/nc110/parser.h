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
#include "transpiler/dialects/nc110/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::nc110 {

enum class XorPrecedence : uint8_t { kSameAsOr, kAboveOr };

struct ParseOptions {
  bool strict_case = false;        // lower-case keywords and operands are error 1 instead of W305
  bool accept_homoglyphs = false;  // Cyrillic look-alikes are mapped, one warning per file
  bool enable_dow = false;         // DOW ... ENDW is a loop instead of NC104
  XorPrecedence xor_precedence = XorPrecedence::kSameAsOr;
  uint32_t max_symbols = 1000;  // SPL
};

/// The files of one program, in order. More than 10 files: error 51 and an empty tree.
Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files, const ParseOptions& options,
              diag::Engine& diagnostics);

/// One token per line, "line:column kind text", for `plcxx print tokens`.
std::string PrintTokens(const source::SourceManager& sources, source::FileId file, const ParseOptions& options);
/// One item per line with its expressions in prefix form, for `plcxx print syntax`.
std::string PrintSyntax(const source::SourceManager& sources, const Program& program);

/// An operand from outside a program (options, scenarios): its spelling, complete and in range, else kind kNone.
Operand OperandFromText(std::string_view text);

}  // namespace plcxx::nc110
