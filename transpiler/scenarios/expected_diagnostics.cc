#include "transpiler/scenarios/expected_diagnostics.h"
#include "transpiler/support/counted.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace plcxx::scenarios {
namespace {

/// Where a diagnostic stands; line 0: it has no place.
struct Spot {
  std::string path;
  uint32_t line = 0;
};

std::string Lower(std::string_view text) {
  std::string lower;
  for (const char c : text) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

Spot SpotOf(const diag::Diagnostic& diagnostic, const source::SourceManager& sources) {
  if (diagnostic.range == source::Range{} || sources.size() == 0) return {};
  const source::Position position = sources.Locate(diagnostic.range.begin);
  return {sources.Get(position.file).path, position.line};
}

/// "plc/turret.plc" is named by "turret.plc", too.
bool FileMatches(const std::string& path, const std::string& wanted) {
  return wanted.empty() || path == wanted || path.ends_with("/" + wanted);
}

bool SpotMatches(const Spot& spot, uint32_t line, const std::string& file) {
  return (line == 0 || spot.line == line) && FileMatches(spot.path, file);
}

std::string SpotText(uint32_t line, const std::string& file) {
  if (line == 0) return file.empty() ? "" : " in " + file;
  return " at line " + std::to_string(line) + (file.empty() ? "" : " of " + file);
}

std::string At(const Scenario& scenario, ScenarioMark mark, std::string message) {
  return ToText(ScenarioError{scenario.path, mark, std::move(message)});
}

const diag::Diagnostic* FirstError(const diag::Engine& diagnostics) {
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == diag::Severity::kError) return &diagnostic;
  }
  return nullptr;
}

bool ContainsAll(const diag::Diagnostic& error, const std::vector<std::string>& words) {
  const std::string text = Lower(std::string(error.row->code) + " " + error.text + " " + error.remedy);  // hints, too
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return text.find(Lower(word)) != std::string::npos; });
}

std::string ExpectationText(const ExpectedError& expected) {
  std::string text = "an error" + SpotText(expected.line, expected.file);
  for (size_t i = 0; i < expected.contains.size(); ++i) {
    text += (i == 0 ? " that contains '" : "' and '") + expected.contains[i];
  }
  return text + (expected.contains.empty() ? "" : "'");
}

/// Notes may be named among the warnings, too.
bool IsWarning(const diag::Diagnostic& diagnostic, std::string_view code) {
  return diagnostic.severity != diag::Severity::kError && CodeMatches(diagnostic.row->code, code);
}

}  // namespace

bool CodeMatches(std::string_view code, std::string_view wanted) {
  const std::string whole = Lower(code);
  const std::string part = Lower(wanted);
  return whole == part || whole.ends_with("-" + part);
}

std::optional<std::string> CheckExpectedError(const Scenario& scenario, const diag::Engine& diagnostics,
                                              const source::SourceManager& sources) {
  const ExpectedError& expected = *scenario.expect_error;
  const diag::Diagnostic* error = FirstError(diagnostics);
  if (error == nullptr)
    return At(scenario, expected.mark, "expected " + ExpectationText(expected) + ", found no error");
  const Spot spot = SpotOf(*error, sources);
  if (SpotMatches(spot, expected.line, expected.file) && ContainsAll(*error, expected.contains)) return std::nullopt;
  return At(scenario, expected.mark,
            "expected " + ExpectationText(expected) + ", found first" + SpotText(spot.line, spot.path) + ": " +
                std::string(error->row->code) + " " + error->text);
}

std::optional<std::string> CheckExpectedWarnings(const Scenario& scenario, const diag::Engine& diagnostics,
                                                 const source::SourceManager& sources) {
  const std::vector<ExpectedWarning>& expected = *scenario.warnings;
  if (expected.empty() && diagnostics.warning_count() > 0) {
    return scenario.path + ": expected no warnings, found " + support::Counted(diagnostics.warning_count(), "warning");
  }
  std::string text;
  const auto complain = [&](ScenarioMark mark, std::string message) {
    text += (text.empty() ? "" : "\n") + At(scenario, mark, std::move(message));
  };
  for (const ExpectedWarning& warning : expected) {
    bool there = false;
    for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
      there |=
          IsWarning(diagnostic, warning.code) && SpotMatches(SpotOf(diagnostic, sources), warning.line, warning.file);
    }
    if (!there)
      complain(warning.mark,
               "expected warning " + warning.code + SpotText(warning.line, warning.file) + ", found none");
  }
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
    const ExpectedWarning* listed = nullptr;
    bool allowed = false;
    const Spot spot = SpotOf(diagnostic, sources);
    for (const ExpectedWarning& warning : expected) {
      if (!IsWarning(diagnostic, warning.code)) continue;
      listed = &warning;
      allowed |= SpotMatches(spot, warning.line, warning.file);
    }
    if (listed != nullptr && !allowed) {
      complain(listed->mark,
               "warning " + listed->code + " is also" + SpotText(spot.line, spot.path) + ", where it is not expected");
    }
  }
  if (text.empty()) return std::nullopt;
  return text;
}

}  // namespace plcxx::scenarios
