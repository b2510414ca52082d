// What the server answers about a document: one function a request of the protocol, each in a file of its own.
//
// In: an analysis of the program that reads the document, and the request's parameters. Out: the result as the protocol
// writes it; null where there is nothing to say. Wrong parameters throw rpc::Error.
#pragma once

#include "transpiler/lsp/names.h"
#include "transpiler/lsp/workspace.h"

namespace plcxx::lsp {

struct FeatureContext {
  const Workspace& workspace;
  WorkspaceProgram& program;
  Analysis& analysis;  // of the document's text as it is now
  const Names& names;
  source::FileId file;

  /// As the client spells it, where it has the file open.
  std::string UriOf(source::FileId file) const;
  /// `position` of the parameters.
  source::Offset OffsetOf(const Json& params) const;
  const dialects::EditorToken* TokenAt(const Json& params) const;
  /// For what the dialect's tables say; `unused` takes what it would report.
  dialects::Request RequestOf(diag::Engine& unused) const;
};

/// `identity` is a FileIdentity.
std::string UriOf(const Documents& documents, std::string_view identity);

/// The kind of these actions, and the command whose argument is {uri, signal, scenario}; its result is what plcxx why
/// says.
inline constexpr const char* kWhyCommand = "plcxx.why";
void AddWhyActions(const FeatureContext& context, const Json& params, Json& actions);
Json CodeActions(const FeatureContext& context, const Json& params);
Json Hover(const FeatureContext& context, const Json& params);
Json GoToDefinition(const FeatureContext& context, const Json& params);
Json References(const FeatureContext& context, const Json& params);
Json DocumentHighlights(const FeatureContext& context, const Json& params);
Json DocumentSymbols(const FeatureContext& context, const Json& params);
void AddWorkspaceSymbols(const FeatureContext& context, std::string_view query, Json& symbols);
Json Completion(const FeatureContext& context, const Json& params);
/// In the plant or the panel of a program: its locations.
Json CompleteMachineFile(const Workspace& workspace, WorkspaceProgram& program, const Document& document,
                         const Json& params);
Json SignatureHelp(const FeatureContext& context, const Json& params);
Json PrepareRename(const FeatureContext& context, const Json& params);
Json Rename(const FeatureContext& context, const Json& params);
Json SemanticTokensLegend();
Json SemanticTokens(const FeatureContext& context, const Json& params);
Json FoldingRanges(const FeatureContext& context, const Json& params);
Json PrepareCallHierarchy(const FeatureContext& context, const Json& params);
Json IncomingCalls(const FeatureContext& context, const Json& params);
Json OutgoingCalls(const FeatureContext& context, const Json& params);

}  // namespace plcxx::lsp
