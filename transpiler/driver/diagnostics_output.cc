#include "transpiler/driver/diagnostics_output.h"

#include <iostream>

#include "transpiler/diagnostics/render.h"
#include "transpiler/driver/terminal.h"

namespace plcxx::driver {
namespace {

std::string Rendered(const Compilation& compilation, DiagnosticsFormat format) {
  const source::SourceManager& sources = *compilation.sources;
  const std::vector<diag::Diagnostic>& diagnostics = compilation.diagnostics.all();
  switch (format) {
    case DiagnosticsFormat::kText: {
      diag::TextStyle style;
      style.colour = ShowsColours(Stream::kErrors) ? diag::Colour::kOn : diag::Colour::kOff;
      style.width = TerminalWidth(Stream::kErrors).value_or(style.width);
      return diag::RenderText(sources, diagnostics, style);
    }
    case DiagnosticsFormat::kJson:
      return diag::RenderJson(sources, diagnostics);
    case DiagnosticsFormat::kSarif:
      return diag::RenderSarif(sources, diagnostics, PLCXX_VERSION);
  }
  return {};
}

}  // namespace

std::optional<DiagnosticsFormat> DiagnosticsFormatByName(std::string_view name) {
  if (name == "text") return DiagnosticsFormat::kText;
  if (name == "json") return DiagnosticsFormat::kJson;
  if (name == "sarif") return DiagnosticsFormat::kSarif;
  return std::nullopt;
}

void PrintDiagnosticsBeside(const Compilation& compilation, DiagnosticsFormat format) {
  std::cerr << Rendered(compilation, format) << std::flush;
}

void PrintDiagnostics(const Compilation& compilation, DiagnosticsFormat format) {
  std::ostream& out = format == DiagnosticsFormat::kText ? std::cerr : std::cout;
  out << Rendered(compilation, format) << std::flush;
}

std::string CountText(const diag::Engine& diagnostics) {
  const std::string counts = diag::CountsText(diagnostics.all());
  return counts.empty() ? "no errors, no warnings" : counts;
}

}  // namespace plcxx::driver
