// How sources of dialect technol are read (specification section 1).
#pragma once

#include <string>
#include <string_view>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/source/source.h"

namespace plcxx::technol {

/// Encodings, line ends and the end mark of sources, included files and tables.
const source::LoadOptions& SourceOptions();
/// A technology table by its extension.
bool IsTable(std::string_view path);
/// Reports a source or a table (TT016) that cannot be read.
void ReportLoadError(const std::string& path, const source::LoadError& error, diag::Engine& diagnostics);
/// Does the text look like TECHNOL? A data block, a module or a mechanism at the beginning of a line, or a table.
bool Recognize(std::string_view text);

}  // namespace plcxx::technol
