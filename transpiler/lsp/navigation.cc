// Where a name is defined, where it is mentioned, and which names there are.
#include <algorithm>
#include <cctype>

#include "transpiler/lsp/features.h"
#include "transpiler/lsp/uses.h"

namespace plcxx::lsp {
namespace {

using dialects::Definition;
using dialects::DefinitionKind;
using dialects::EditorToken;

/// SymbolKind of the protocol.
int SymbolKindOf(DefinitionKind kind) {
  switch (kind) {
    case DefinitionKind::kSignal:
    case DefinitionKind::kVariable:
    case DefinitionKind::kParameter:
      return 13;  // Variable
    case DefinitionKind::kConstant:
      return 14;  // Constant
    case DefinitionKind::kLabel:
      return 20;  // Key
    case DefinitionKind::kRoutine:
    case DefinitionKind::kMacro:
      return 12;  // Function
    case DefinitionKind::kBlock:
      return 3;  // Namespace
    case DefinitionKind::kType:
      return 23;  // Struct
    case DefinitionKind::kField:
      return 8;  // Field
  }
  return 13;
}

Json LocationOf(const FeatureContext& context, source::Range range) {
  const FileRange at = context.analysis.Locate(range);
  return {{"uri", context.UriOf(at.file)}, {"range", ToJson(at)}};
}

bool HasName(const Definition& definition) { return definition.name_range.begin != definition.name_range.end; }

bool IsOnOneLine(const FeatureContext& context, source::Range a, source::Range b) {
  const FileRange first = context.analysis.Locate(a), second = context.analysis.Locate(b);
  return first.file == second.file && first.begin.line == second.begin.line;
}

std::vector<source::Range> DefinitionsOf(const FeatureContext& context, const Target& target) {
  std::vector<source::Range> ranges;
  const Names& names = context.names;
  if (target.definition != kNoDefinition) {
    const Definition& definition = names.definitions()[target.definition];
    if (HasName(definition)) ranges.push_back(definition.name_range);
  }
  if (!ranges.empty() || !target.bits) return ranges;
  for (const Definition& definition : names.definitions()) {
    if (definition.address.empty() || !HasName(definition)) continue;
    const EditorToken* token =
        names.TokenAt(context.analysis.sources().FileAt(definition.name_range.begin), definition.name_range.begin);
    if (token != nullptr && names.TargetOf(*token).bits == target.bits) ranges.push_back(definition.name_range);
  }
  // An address without a name is defined by the statements that write it.
  if (ranges.empty() && &context.program.Meaning() == &context.analysis) {
    ranges = UsesOf(names.program(), *target.bits).writes;
  }
  return ranges;
}

bool Matches(std::string_view name, std::string_view query) {
  const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  return query.empty() || std::search(name.begin(), name.end(), query.begin(), query.end(), same) != name.end();
}

Json SymbolOf(const FeatureContext& context, const Definition& definition) {
  Json symbol = {{"name", definition.name},
                 {"kind", SymbolKindOf(definition.kind)},
                 {"range", ToJson(context.analysis.Locate(definition.range))},
                 {"selectionRange", ToJson(context.analysis.Locate(definition.name_range))}};
  if (!definition.detail.empty()) symbol["detail"] = definition.detail;
  return symbol;
}

bool Encloses(source::Range outer, source::Range inner) {
  return outer.begin <= inner.begin && inner.end <= outer.end && outer != inner;
}

/// `index` is the first of `sorted` that is not in a symbol yet; takes all that lie within `outer`.
Json Nest(const FeatureContext& context, const std::vector<const Definition*>& sorted, size_t& index,
          const source::Range* outer) {
  Json symbols = Json::array();
  while (index < sorted.size() && (outer == nullptr || Encloses(*outer, sorted[index]->range))) {
    const Definition& definition = *sorted[index++];
    Json symbol = SymbolOf(context, definition);
    Json children = Nest(context, sorted, index, &definition.range);
    if (!children.empty()) symbol["children"] = std::move(children);
    symbols.push_back(std::move(symbol));
  }
  return symbols;
}

}  // namespace

Json GoToDefinition(const FeatureContext& context, const Json& params) {
  const EditorToken* token = context.TokenAt(params);
  if (token == nullptr) return nullptr;
  Json locations = Json::array();
  for (const source::Range range : DefinitionsOf(context, context.names.TargetOf(*token))) {
    locations.push_back(LocationOf(context, range));
  }
  return locations;
}

Json References(const FeatureContext& context, const Json& params) {
  const EditorToken* token = context.TokenAt(params);
  Json locations = Json::array();
  if (token == nullptr) return locations;
  const Target target = context.names.TargetOf(*token);
  if (!target.known()) return locations;
  bool with_declaration = true;
  if (params.contains("context")) {
    with_declaration = rpc::OptionalFlag(params["context"], "includeDeclaration").value_or(true);
  }
  std::vector<source::Range> declared;
  if (!with_declaration) declared = DefinitionsOf(context, target);
  for (const source::Range range : context.names.MentionsOf(target)) {
    // The address beside its name is a part of the declaration.
    const auto is_beside = [&](source::Range name) { return IsOnOneLine(context, name, range); };
    if (std::ranges::none_of(declared, is_beside)) locations.push_back(LocationOf(context, range));
  }
  return locations;
}

Json DocumentHighlights(const FeatureContext& context, const Json& params) {
  const EditorToken* token = context.TokenAt(params);
  Json highlights = Json::array();
  if (token == nullptr) return highlights;
  const Target target = context.names.TargetOf(*token);
  if (!target.known()) return highlights;
  for (const source::Range range : context.names.MentionsOf(target)) {
    const FileRange at = context.analysis.Locate(range);
    if (at.file == context.file) highlights.push_back({{"range", ToJson(at)}});
  }
  return highlights;
}

Json DocumentSymbols(const FeatureContext& context, const Json&) {
  std::vector<const Definition*> sorted;
  for (const Definition& definition : context.names.definitions()) {
    if (HasName(definition) && context.analysis.sources().FileAt(definition.name_range.begin) == context.file) {
      sorted.push_back(&definition);
    }
  }
  std::ranges::stable_sort(sorted, [](const Definition* a, const Definition* b) {
    return a->range.begin != b->range.begin ? a->range.begin < b->range.begin : a->range.end > b->range.end;
  });
  size_t index = 0;
  return Nest(context, sorted, index, nullptr);
}

void AddWorkspaceSymbols(const FeatureContext& context, std::string_view query, Json& symbols) {
  constexpr size_t kMaxSymbols = 1000;
  for (const Definition& definition : context.names.definitions()) {
    if (symbols.size() >= kMaxSymbols) return;
    if (!HasName(definition) || definition.kind == DefinitionKind::kBlock || !Matches(definition.name, query)) continue;
    symbols.push_back({{"name", definition.name},
                       {"kind", SymbolKindOf(definition.kind)},
                       {"containerName", definition.detail},
                       {"location", LocationOf(context, definition.name_range)}});
  }
}

}  // namespace plcxx::lsp
