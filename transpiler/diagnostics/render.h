// Diagnostics for people (text), for programs (JSON) and for code review services (SARIF 2.1.0).
//
// In: diagnostics in the order in which they are to appear, and the sources that their ranges point into. Out: a
// string; the same input gives the same bytes. Not its job: sorting, choosing, writing to a stream.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/source/source.h"

namespace plcxx::diag {

enum class Colour : uint8_t { kOff, kOn };

struct TextStyle {
  Colour colour = Colour::kOff;
  unsigned width = 100;  // of the terminal, in columns; source lines are cropped to it, messages are not
};

///   turret.plc:3:6: error: operand 'IOA7': unknown identifier [nc110-1]
///       3 | U4A0=IOA7
///         |      ^~~~
///         help: write an operand such as I0A7
/// and at the end "2 errors, 1 warning"; nothing at all without diagnostics.
std::string RenderText(const source::SourceManager& sources, std::span<const Diagnostic> diagnostics,
                       const TextStyle& style);
/// "2 errors, 1 warning, 3 notes"; empty when there are none.
std::string CountsText(std::span<const Diagnostic> diagnostics);
/// The same of all that were reported, those included that the engine did not keep.
std::string CountsText(const Engine& diagnostics);

/// The first `most` errors, and the first `most` of the others, in their order; 0: all.
std::vector<Diagnostic> FirstOf(std::span<const Diagnostic> diagnostics, size_t most);
/// As RenderText for the first `most` (0: all); the last lines tell how many are not shown, and the counts of all.
std::string RenderFirst(const source::SourceManager& sources, const Engine& diagnostics, size_t most,
                        const TextStyle& style);

/// An array of objects: code, severity, message, help, file, line, column, endLine, endColumn, byteOffset, byteLength,
/// notes, fixits. Columns count characters from 1, ends are exclusive, bytes are those of the original file; what has
/// no place has null there.
std::string RenderJson(const source::SourceManager& sources, std::span<const Diagnostic> diagnostics);

/// One run; its rules are the codes that occur, in the order of the catalogue.
std::string RenderSarif(const source::SourceManager& sources, std::span<const Diagnostic> diagnostics,
                        std::string_view tool_version);

}  // namespace plcxx::diag
