#include "transpiler/scenarios/property_places.h"

#include <algorithm>
#include <utility>

#include "transpiler/support/read_file.h"

namespace plcxx::scenarios {
namespace {

using prove::properties::PropertyError;
using prove::properties::PropertyFault;

/// The row of a fault and its parameters in their order.
std::pair<const diag::Row*, std::vector<std::string>> MessageOf(const PropertyError& error, const std::string& path,
                                                                std::string_view dialect) {
  std::vector<std::string> words = error.words;
  switch (error.fault) {
    case PropertyFault::kSyntax:
      return {&diag::PropertySyntax.row, std::move(words)};
    case PropertyFault::kLocation:
      words.emplace_back(dialect);
      return {&diag::PropertyLocation.row, std::move(words)};
    case PropertyFault::kNotMemory:
      return {&diag::PropertyNotMemory.row, std::move(words)};
    case PropertyFault::kBitNeeded:
      return {&diag::PropertyBitNeeded.row, std::move(words)};
    case PropertyFault::kNoFit:
      return {&diag::PropertyNoFit.row, std::move(words)};
    case PropertyFault::kRange:
      return {&diag::PropertyRange.row, std::move(words)};
    case PropertyFault::kTooLong:
      return {&diag::PropertyTooLong.row, std::move(words)};
    case PropertyFault::kNothing:
      return {&diag::PropertyNothing.row, {path}};
  }
  PLCXX_UNREACHABLE();
}

/// Where line and column, both from 1, stand in a text.
size_t OffsetOf(std::string_view text, uint32_t line, uint32_t column) {
  size_t at = 0;
  for (uint32_t i = 1; i < line; ++i) {
    const size_t end = text.find('\n', at);
    if (end == std::string_view::npos) return text.size();
    at = end + 1;
  }
  return std::min(text.size(), at + column - 1);
}

void Report(const PropertyError& error, source::FileId file, std::string_view dialect,
            const source::SourceManager& sources, diag::Engine& diagnostics) {
  const source::File& where = sources.Get(file);
  const size_t begin = OffsetOf(where.text, error.line, error.column);
  const size_t end = std::min(where.text.size(), begin + error.length);
  const auto [row, words] = MessageOf(error, where.path, dialect);
  diagnostics.ReportRow(
      {where.base + static_cast<source::Offset>(begin), where.base + static_cast<source::Offset>(end)}, *row, words);
}

/// Columns of a property count from where its text begins: after a quote, if there is one.
PropertyError Moved(PropertyError error, const MarkedText& written, std::string_view text) {
  const size_t begin = OffsetOf(text, written.mark.line, written.mark.column);
  const bool quoted = begin < text.size() && (text[begin] == '"' || text[begin] == '\'');
  error.line = written.mark.line;
  error.column += written.mark.column - 1 + (quoted ? 1 : 0);
  return error;
}

struct ScenarioProperties {
  std::vector<prove::properties::Property> properties;
  std::vector<PropertyError> errors;
};

ScenarioProperties ParseScenarioProperties(const Scenario& scenario, std::string_view text,
                                           const prove::properties::PropertyContext& context) {
  ScenarioProperties result;
  for (const MarkedText& written : scenario.properties) {
    prove::properties::Properties parsed = prove::properties::ParseProperties(written.text, context);
    for (PropertyError& error : parsed.errors) result.errors.push_back(Moved(std::move(error), written, text));
    for (prove::properties::Property& property : parsed.properties) {
      property.line = written.mark.line;
      property.column = written.mark.column;
      result.properties.push_back(std::move(property));
    }
  }
  return result;
}

}  // namespace

std::string TextOf(const PropertyError& error, std::string_view dialect) {
  const auto [row, words] = MessageOf(error, "", dialect);
  return diag::Format(row->text, words) + ": " + diag::Format(row->remedy, words);
}

std::vector<PlacedProperty> PropertiesOfFile(const std::string& path, const std::string& text, std::string_view dialect,
                                             const prove::properties::PropertyContext& context,
                                             source::SourceManager& sources, diag::Engine& diagnostics) {
  const source::FileId file = sources.AddText(path, text);
  prove::properties::Properties parsed = prove::properties::ParseProperties(text, context);
  for (const PropertyError& error : parsed.errors) Report(error, file, dialect, sources, diagnostics);
  std::vector<PlacedProperty> placed;
  for (prove::properties::Property& property : parsed.properties) placed.push_back({path, std::move(property)});
  return placed;
}

std::vector<PlacedProperty> PropertiesOfScenario(const Scenario& scenario, std::string_view dialect,
                                                 const prove::properties::PropertyContext& context,
                                                 source::SourceManager& sources, diag::Engine& diagnostics) {
  const std::string text = support::ReadFile(scenario.path).value_or("");
  const source::FileId file = sources.AddText(scenario.path, text);
  ScenarioProperties parsed = ParseScenarioProperties(scenario, text, context);
  for (const PropertyError& error : parsed.errors) Report(error, file, dialect, sources, diagnostics);
  std::vector<PlacedProperty> placed;
  for (prove::properties::Property& property : parsed.properties)
    placed.push_back({scenario.path, std::move(property)});
  return placed;
}

std::vector<prove::properties::Property> WatchedProperties(const Scenario& scenario, std::string_view dialect,
                                                           const prove::properties::PropertyContext& context,
                                                           std::vector<ScenarioError>& errors) {
  ScenarioProperties parsed = ParseScenarioProperties(scenario, support::ReadFile(scenario.path).value_or(""), context);
  for (const PropertyError& error : parsed.errors) {
    errors.push_back({scenario.path, {error.line, error.column}, TextOf(error, dialect)});
  }
  return std::move(parsed.properties);
}

}  // namespace plcxx::scenarios
