#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "transpiler/diagnostics/explain.h"
#include "transpiler/diagnostics/places.h"
#include "transpiler/diagnostics/render.h"
#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/diagnostics/uri.h"

namespace plcxx::diag {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kSchema = "https://json.schemastore.org/sarif-2.1.0.json";

Json RegionOf(const Place& place) {
  return {{"startLine", place.begin.line},
          {"startColumn", place.begin.column},
          {"endLine", place.end.line},
          {"endColumn", place.end.column}};
}

Json ArtifactOf(const Place& place) { return {{"uri", UriOf(place.path)}}; }

Json LocationOf(const source::SourceManager& sources, source::Range range) {
  const Place place = PlaceOf(sources, range);
  return {{"physicalLocation", {{"artifactLocation", ArtifactOf(place)}, {"region", RegionOf(place)}}}};
}

/// The fix-its of a diagnostic belong together: one fix.
Json FixOf(const source::SourceManager& sources, const Diagnostic& diagnostic) {
  Json changes = Json::array();
  std::vector<source::FileId> files;
  std::string description;
  for (const FixIt& fixit : diagnostic.fixits) {
    if (!HasPlace(fixit.range)) continue;
    const Place place = PlaceOf(sources, fixit.range);
    const auto known = std::ranges::find(files, place.begin.file);
    const auto index = static_cast<size_t>(known - files.begin());
    if (known == files.end()) {
      files.push_back(place.begin.file);
      changes.push_back({{"artifactLocation", ArtifactOf(place)}, {"replacements", Json::array()}});
    }
    changes[index]["replacements"].push_back(
        {{"deletedRegion", RegionOf(place)}, {"insertedContent", {{"text", fixit.replacement}}}});
    description += (description.empty() ? "" : ", ") + DescriptionOf(sources, fixit);
  }
  return {{"description", {{"text", description}}}, {"artifactChanges", std::move(changes)}};
}

/// The first line of a page is "# nc110-1: malformed operand".
std::string_view TitleOf(std::string_view page) {
  page = page.substr(0, page.find('\n'));
  const size_t colon = page.find(": ");
  return colon == std::string_view::npos ? std::string_view() : page.substr(colon + 2);
}

/// Several rows may share the code; the first one stands for all.
Json RuleOf(const Row& row) {
  const std::string_view page = Explain(row.code).value_or(std::string_view());
  const std::string_view title = TitleOf(page);
  Json rule;
  rule["id"] = row.code;
  rule["shortDescription"]["text"] = title.empty() ? row.text : title;
  rule["help"]["text"] = !page.empty() ? page : !row.remedy.empty() ? row.remedy : row.text;
  if (!page.empty()) rule["help"]["markdown"] = page;
  rule["defaultConfiguration"] = {{"enabled", !row.off_by_default}, {"level", SeverityName(row.severity)}};
  return rule;
}

/// The codes that occur, each by its first row, in the order of the catalogue; rows of no catalogue (tests) after
/// them.
std::vector<const Row*> RulesOf(std::span<const Diagnostic> diagnostics) {
  std::vector<const Row*> rules;
  const auto known = [&](std::string_view code) { return std::ranges::find(rules, code, &Row::code) != rules.end(); };
  const auto occurs = [&](const Row& row) {
    return std::ranges::any_of(diagnostics, [&](const Diagnostic& one) { return one.row->code == row.code; });
  };
  for (const Row& row : Catalogue()) {
    if (!known(row.code) && occurs(row)) rules.push_back(&row);
  }
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!known(diagnostic.row->code)) rules.push_back(diagnostic.row);
  }
  return rules;
}

Json ResultOf(const source::SourceManager& sources, const Diagnostic& diagnostic, size_t rule_index) {
  Json result;
  result["ruleId"] = diagnostic.row->code;
  result["ruleIndex"] = rule_index;
  result["level"] = SeverityName(diagnostic.severity);
  result["message"]["text"] = diagnostic.text;
  if (HasPlace(diagnostic.range)) result["locations"] = Json::array({LocationOf(sources, diagnostic.range)});
  for (const Note& note : diagnostic.notes) {
    Json location = HasPlace(note.range) ? LocationOf(sources, note.range) : Json::object();
    location["message"]["text"] = note.text;
    result["relatedLocations"].push_back(std::move(location));
  }
  const bool has_fix = std::ranges::any_of(diagnostic.fixits, [](const FixIt& one) { return HasPlace(one.range); });
  if (has_fix) result["fixes"] = Json::array({FixOf(sources, diagnostic)});
  if (!diagnostic.remedy.empty()) result["properties"]["help"] = diagnostic.remedy;
  return result;
}

}  // namespace

std::string RenderSarif(const source::SourceManager& sources, std::span<const Diagnostic> diagnostics,
                        std::string_view tool_version) {
  const std::vector<const Row*> rules = RulesOf(diagnostics);
  Json driver = {{"name", "plcxx"}, {"version", tool_version}, {"rules", Json::array()}};
  for (const Row* row : rules) driver["rules"].push_back(RuleOf(*row));

  Json results = Json::array();
  for (const Diagnostic& diagnostic : diagnostics) {
    const auto rule = std::ranges::find(rules, diagnostic.row->code, &Row::code);
    results.push_back(ResultOf(sources, diagnostic, static_cast<size_t>(rule - rules.begin())));
  }

  Json run;
  run["tool"]["driver"] = std::move(driver);
  run["columnKind"] = "unicodeCodePoints";
  run["results"] = std::move(results);
  Json log;
  log["$schema"] = kSchema;
  log["version"] = "2.1.0";
  log["runs"] = Json::array({std::move(run)});
  return JsonForTerminals(log.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace plcxx::diag
