// Who calls a routine, and what it calls.
#include <map>

#include "transpiler/lsp/features.h"

namespace plcxx::lsp {
namespace {

using dialects::Definition;
using dialects::DefinitionKind;
using dialects::EditorToken;

Json ItemOf(const FeatureContext& context, uint32_t index) {
  const Definition& definition = context.names.definitions()[index];
  const FileRange range = context.analysis.Locate(definition.range);
  Json item = {{"name", definition.name},
               {"kind", 12},
               {"uri", context.UriOf(range.file)},
               {"range", ToJson(range)},
               {"selectionRange", ToJson(context.analysis.Locate(definition.name_range))}};
  if (!definition.detail.empty()) item["detail"] = definition.detail;
  return item;
}

bool IsRoutine(const FeatureContext& context, uint32_t index) {
  return index != kNoDefinition && context.names.definitions()[index].kind == DefinitionKind::kRoutine;
}

/// The routine that a word names; that around it where it names none.
uint32_t RoutineOf(const FeatureContext& context, source::Offset at) {
  if (const EditorToken* token = context.names.TokenAt(context.file, at)) {
    const uint32_t named = context.names.TargetOf(*token).definition;
    if (IsRoutine(context, named)) return named;
  }
  return context.names.RoutineAt(at);
}

uint32_t RoutineOfItem(const FeatureContext& context, const Json& params) {
  const Json& range = rpc::ObjectOf(rpc::ObjectOf(params, "item"), "selectionRange");
  return RoutineOf(context, context.analysis.OffsetOf(context.file, ReadPosition(rpc::ObjectOf(range, "start"))));
}

using Calls = std::map<uint32_t, std::vector<source::Range>>;  // by routine

Json ToJson(const FeatureContext& context, const Calls& calls, const char* key) {
  Json result = Json::array();
  for (const auto& [routine, ranges] : calls) {
    Json from = Json::array();
    for (const source::Range range : ranges) from.push_back(lsp::ToJson(context.analysis.Locate(range)));
    result.push_back({{key, ItemOf(context, routine)}, {"fromRanges", from}});
  }
  return result;
}

}  // namespace

Json PrepareCallHierarchy(const FeatureContext& context, const Json& params) {
  const uint32_t routine = RoutineOf(context, context.OffsetOf(params));
  if (routine == kNoDefinition) return nullptr;
  return Json::array({ItemOf(context, routine)});
}

Json IncomingCalls(const FeatureContext& context, const Json& params) {
  const uint32_t routine = RoutineOfItem(context, params);
  Calls calls;
  if (routine != kNoDefinition) {
    const source::Range own = context.names.definitions()[routine].name_range;
    for (const source::Range range : context.names.MentionsOf({.definition = routine, .bits = std::nullopt})) {
      const uint32_t caller = context.names.RoutineAt(range.begin);
      // A routine's closing line names it, too.
      if (caller != kNoDefinition && caller != routine && range != own) calls[caller].push_back(range);
    }
  }
  return ToJson(context, calls, "from");
}

Json OutgoingCalls(const FeatureContext& context, const Json& params) {
  const uint32_t routine = RoutineOfItem(context, params);
  Calls calls;
  if (routine != kNoDefinition) {
    const source::Range body = context.names.definitions()[routine].range;
    const source::FileId file = context.analysis.sources().FileAt(body.begin);
    for (const EditorToken& token : context.names.TokensOf(file)) {
      if (token.range.begin < body.begin || token.range.begin >= body.end) continue;
      const uint32_t called = context.names.TargetOf(token).definition;
      if (called != routine && IsRoutine(context, called)) calls[called].push_back(token.range);
    }
  }
  return ToJson(context, calls, "to");
}

}  // namespace plcxx::lsp
