// Two texts of one random program must be one program.
//
// A reference reads the tool's own syntax tree, so that a fault of lexer, parser or operands is the same fault in both.
// This judge knows no tree: the generator writes a program twice (Spelling), and the IR of both must be the same but
// for what comes from the text itself (names, statement ids, the base of constants).
#pragma once

#include <cstdint>
#include <string>

#include "tests/reference/reference_dialects.h"

namespace plcxx::reference {

/// The IR's text without names, statement ids and bases.
std::string WithoutSpelling(const std::string& printed);

/// What differs between the two texts of a seed's program; empty: nothing. Files are written below `directory`.
std::string DifferentSpellings(const ReferenceDialect& dialect, uint64_t seed, ProgramSize size,
                               const std::string& directory);

}  // namespace plcxx::reference
