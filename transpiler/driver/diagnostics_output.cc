#include "transpiler/driver/diagnostics_output.h"

#include <iostream>
#include <utility>
#include <vector>

#include "transpiler/diagnostics/render.h"
#include "transpiler/driver/diagnostics_documents.h"
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

/// Of SARIF, whose paths are addresses, nothing is left of it: they are those of the files in the work tree.
std::string WithShownPaths(std::string text, const MessageStyle& messages) {
  if (messages.hidden.empty()) return text;
  const bool is_sarif = messages.format == DiagnosticsFormat::kSarif;
  for (const std::string& begin : {"file://" + messages.hidden, messages.hidden}) {
    const std::string shown = is_sarif ? "" : messages.shown;
    for (size_t at = 0; (at = text.find(begin, at)) != std::string::npos; at += shown.size())
      text.replace(at, begin.size(), shown);
  }
  return text;
}

/// What is kept for the end of a DiagnosticsDocuments, by stream.
struct Kept {
  bool is_open = false;
  std::vector<std::string> output, errors;
};
Kept& Documents() {
  static Kept kept;
  return kept;
}

void Print(std::string text, DiagnosticsFormat format, std::ostream& out) {
  Kept& kept = Documents();
  if (kept.is_open && format != DiagnosticsFormat::kText) {
    (&out == &std::cout ? kept.output : kept.errors).push_back(std::move(text));
  } else {
    out << text << std::flush;
  }
}

}  // namespace

DiagnosticsDocuments::DiagnosticsDocuments() { Documents().is_open = true; }

DiagnosticsDocuments::~DiagnosticsDocuments() {
  const Kept kept = std::exchange(Documents(), {});
  std::cout << MergedDiagnostics(kept.output) << std::flush;
  std::cerr << MergedDiagnostics(kept.errors) << std::flush;
}

std::optional<DiagnosticsFormat> DiagnosticsFormatByName(std::string_view name) {
  if (name == "text") return DiagnosticsFormat::kText;
  if (name == "json") return DiagnosticsFormat::kJson;
  if (name == "sarif") return DiagnosticsFormat::kSarif;
  return std::nullopt;
}

void PrintDiagnosticsBeside(const compilation::Compilation& compilation, const MessageStyle& messages) {
  Print(WithShownPaths(Rendered(compilation, messages), messages), messages.format, std::cerr);
}

void PrintDiagnostics(const compilation::Compilation& compilation, const MessageStyle& messages) {
  std::ostream& out = messages.format == DiagnosticsFormat::kText ? std::cerr : std::cout;
  Print(WithShownPaths(Rendered(compilation, messages), messages), messages.format, out);
}

std::string CountText(const diag::Engine& diagnostics) {
  const std::string counts = diag::CountsText(diagnostics);
  return counts.empty() ? "no errors, no warnings" : counts;
}

}  // namespace plcxx::driver
