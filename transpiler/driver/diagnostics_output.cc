#include "transpiler/driver/diagnostics_output.h"

#include <iostream>

#include "transpiler/diagnostics/render.h"
#include "transpiler/driver/terminal.h"

namespace plcxx::driver {
namespace {

/// Programs that read messages get all of them unless a number was asked for.
std::vector<diag::Diagnostic> ForPrograms(const compilation::Compilation& compilation, const MessageStyle& messages) {
  return diag::FirstOf(compilation.diagnostics.all(), messages.most.value_or(0));
}

std::string Rendered(const compilation::Compilation& compilation, const MessageStyle& messages) {
  constexpr size_t kMostShown = 100;
  const source::SourceManager& sources = *compilation.sources;
  switch (messages.format) {
    case DiagnosticsFormat::kText: {
      diag::TextStyle style;
      style.colour = ShowsColours(Stream::kErrors) ? diag::Colour::kOn : diag::Colour::kOff;
      style.width = TerminalWidth(Stream::kErrors).value_or(style.width);
      return diag::RenderFirst(sources, compilation.diagnostics, messages.most.value_or(kMostShown), style);
    }
    case DiagnosticsFormat::kJson:
      return diag::RenderJson(sources, ForPrograms(compilation, messages));
    case DiagnosticsFormat::kSarif:
      return diag::RenderSarif(sources, ForPrograms(compilation, messages), PLCXX_VERSION);
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

void PrintDiagnosticsBeside(const compilation::Compilation& compilation, const MessageStyle& messages) {
  std::cerr << Rendered(compilation, messages) << std::flush;
}

void PrintDiagnostics(const compilation::Compilation& compilation, const MessageStyle& messages) {
  std::ostream& out = messages.format == DiagnosticsFormat::kText ? std::cerr : std::cout;
  out << Rendered(compilation, messages) << std::flush;
}

std::string CountText(const diag::Engine& diagnostics) {
  const std::string counts = diag::CountsText(diagnostics);
  return counts.empty() ? "no errors, no warnings" : counts;
}

}  // namespace plcxx::driver
