// "Why is this signal what it is?" as an action at the word, one for each scenario of the program.
#include <algorithm>
#include <filesystem>

#include "transpiler/lsp/features.h"

namespace plcxx::lsp {
namespace {

/// More of them nobody reads in a menu.
constexpr size_t kMostScenarios = 8;

}  // namespace

void AddWhyActions(const FeatureContext& context, const Json& params, Json& actions) {
  const std::vector<std::string>& scenarios = context.workspace.ScenariosOf(context.program);
  if (scenarios.empty()) return;
  const Position start = ReadPosition(rpc::ObjectOf(rpc::ObjectOf(params, "range"), "start"));
  const dialects::EditorToken* token =
      context.names.TokenAt(context.file, context.analysis.OffsetOf(context.file, start));
  if (token == nullptr) return;
  const std::string signal(context.names.TextOf(*token));
  if (!context.names.Locate(signal)) return;
  for (size_t i = 0; i < std::min(scenarios.size(), kMostScenarios); ++i) {
    const std::string title =
        "Why is " + signal + " so at the end of " + std::filesystem::path(scenarios[i]).filename().string() + "?";
    actions.push_back(
        {{"title", title},
         {"kind", kWhyCommand},
         {"command",
          {{"title", title},
           {"command", kWhyCommand},
           {"arguments", {{{"uri", context.UriOf(context.file)}, {"signal", signal}, {"scenario", scenarios[i]}}}}}}});
  }
}

}  // namespace plcxx::lsp
