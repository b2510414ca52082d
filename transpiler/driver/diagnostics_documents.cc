#include "transpiler/driver/diagnostics_documents.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "transpiler/diagnostics/terminal_text.h"

namespace plcxx::driver {
namespace {

using Json = nlohmann::ordered_json;

/// A rule is in the list once; a result names it by its number there.
void AddRun(Json more, Json& run) {
  Json& rules = run["tool"]["driver"]["rules"];
  std::vector<size_t> numbers;
  for (Json& rule : more["tool"]["driver"]["rules"]) {
    size_t number = 0;
    while (number < rules.size() && rules[number]["id"] != rule["id"]) ++number;
    if (number == rules.size()) rules.push_back(std::move(rule));
    numbers.push_back(number);
  }
  for (Json& result : more["results"]) {
    result["ruleIndex"] = numbers.at(result["ruleIndex"].get<size_t>());
    run["results"].push_back(std::move(result));
  }
}

}  // namespace

std::string MergedDiagnostics(const std::vector<std::string>& documents) {
  if (documents.empty()) return {};
  if (documents.size() == 1) return documents.front();
  Json merged = Json::parse(documents.front());
  for (size_t i = 1; i < documents.size(); ++i) {
    Json more = Json::parse(documents[i]);
    if (merged.is_array()) {
      for (Json& message : more) merged.push_back(std::move(message));
    } else {
      AddRun(std::move(more["runs"][0]), merged["runs"][0]);
    }
  }
  return diag::JsonForTerminals(merged.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace plcxx::driver
