// Where diagnostics go: text to standard error; JSON and SARIF of emit and check to standard output.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "transpiler/compilation/compilation.h"

namespace plcxx::driver {

enum class DiagnosticsFormat : uint8_t { kText, kJson, kSarif };

struct MessageStyle {
  DiagnosticsFormat format = DiagnosticsFormat::kText;
  std::optional<size_t> most;  // --max-messages, of errors and of the others; 0: all
  /// How paths begin that are nobody's, those of a copy that is gone afterwards, and what is shown of it: "HEAD:".
  std::string hidden = {}, shown = {};
};

/// The names that --diagnostics accepts.
std::optional<DiagnosticsFormat> DiagnosticsFormatByName(std::string_view name);

/// For commands whose result is not the diagnostics: always to standard error.
void PrintDiagnosticsBeside(const compilation::Compilation& compilation, const MessageStyle& messages);
/// For commands whose standard output is free: JSON and SARIF go there.
void PrintDiagnostics(const compilation::Compilation& compilation, const MessageStyle& messages);

/// "2 errors, 1 warning"
std::string CountText(const diag::Engine& diagnostics);

}  // namespace plcxx::driver
