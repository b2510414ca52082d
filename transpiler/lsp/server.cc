#include "transpiler/lsp/server.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "transpiler/compilation/source_loading.h"
#include "transpiler/lsp/features.h"
#include "transpiler/rpc/standard_streams.h"
#include "transpiler/source/find_file.h"
#include "transpiler/support/fault_guard.h"

namespace plcxx::lsp {
namespace {

enum class State : uint8_t { kNew, kInitialized, kShutDown, kEnded };

class LanguageServer {
 public:
  explicit LanguageServer(ScenarioAnswers answers)
      : server_(rpc::Framing::kHeaders, [this](std::string_view text) { streams_.Send(rpc::Framing::kHeaders, text); }),
        workspace_(std::move(answers)) {
    AddMethods();
  }

  int Run() {
    streams_.Run(server_, [this] { return Idle(); }, [this] { return state_ == State::kEnded; });
    return was_shut_down_ ? 0 : 1;
  }

 private:
  using Feature = Json (*)(const FeatureContext& context, const Json& params);

  void AddMethods();
  void AddFeatures();
  void AddFeature(const char* method, Feature feature);
  Json WorkspaceSymbols(const Json& params);
  Json ProgramOf(const Json& params);
  Json ExecuteCommand(const Json& params);
  void CheckState(std::string_view method) const;
  Json Initialize(const Json& params);
  void Publish(std::string_view identity);
  Workspace::Publish Publisher() {
    return [this](std::string_view identity) { Publish(identity); };
  }
  bool Idle();

  rpc::StandardStreams streams_;
  rpc::Server server_;
  Workspace workspace_;
  State state_ = State::kNew;
  bool was_shut_down_ = false;
};

void LanguageServer::CheckState(std::string_view method) const {
  if (method == "exit") return;
  if (state_ == State::kNew && method != "initialize") {
    throw rpc::Error(rpc::kServerNotInitialized, "the first request is 'initialize'");
  }
  if (state_ == State::kInitialized && method == "initialize") {
    throw rpc::Error(rpc::kInvalidRequest, "the server is initialized already");
  }
  if (state_ == State::kShutDown) throw rpc::Error(rpc::kInvalidRequest, "the server was shut down");
}

Units ChooseUnits(const Json& params) {
  const auto offered = Json::json_pointer("/capabilities/general/positionEncodings");
  if (!params.is_object() || !params.contains(offered) || !params[offered].is_array()) return Units::kUtf16;
  for (const Json& name : params[offered]) {
    for (const Units units : {Units::kUtf8, Units::kUtf16, Units::kUtf32}) {
      if (name == Name(units)) return units;
    }
  }
  return Units::kUtf16;
}

Json LanguageServer::Initialize(const Json& params) {
  workspace_.SetUnits(ChooseUnits(params));
  if (params.is_object() && params.contains("initializationOptions")) {
    workspace_.Configure(params["initializationOptions"]);
  }
  state_ = State::kInitialized;
  return {{"capabilities",
           {{"positionEncoding", Name(workspace_.units())},
            {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", true}}},
            {"codeActionProvider", {{"codeActionKinds", {"quickfix", kWhyCommand}}}},
            {"hoverProvider", true},
            {"definitionProvider", true},
            {"referencesProvider", true},
            {"documentHighlightProvider", true},
            {"documentSymbolProvider", true},
            {"workspaceSymbolProvider", true},
            {"completionProvider", {{"triggerCharacters", {"%", "!", "."}}}},
            {"signatureHelpProvider", {{"triggerCharacters", {" ", "(", "[", ","}}}},
            {"renameProvider", {{"prepareProvider", true}}},
            {"semanticTokensProvider", {{"legend", SemanticTokensLegend()}, {"full", true}}},
            {"foldingRangeProvider", true},
            {"callHierarchyProvider", true},
            {"executeCommandProvider", {{"commands", {kWhyCommand}}}}}},
          {"serverInfo", {{"name", "plcxx"}, {"version", PLCXX_VERSION}}}};
}

void LanguageServer::Publish(std::string_view identity) {
  const Document* open = workspace_.documents().Find(identity);
  std::string params = R"({"diagnostics":)" + workspace_.DiagnosticsOf(identity) + R"(,"uri":)" +
                       rpc::Written(UriOf(workspace_.documents(), identity));
  if (open != nullptr) params += R"(,"version":)" + std::to_string(open->version);
  server_.NotifyWritten("textDocument/publishDiagnostics", params + "}");
}

bool LanguageServer::Idle() {
  if (state_ != State::kInitialized) return false;
  try {
    return workspace_.AnalyseNext(Publisher());
  } catch (const std::exception& fault) {
    server_.Notify("window/showMessage",
                   {{"type", 1}, {"message", std::string("internal fault of plcxx: ") + fault.what()}});
    return true;
  }
}

void LanguageServer::AddFeature(const char* method, Feature feature) {
  server_.Add(method, [this, feature](const Json& params) -> Json {
    const support::FaultGuard guard;
    const std::string identity = source::FileIdentity(
        params.is_object() && params.contains("item") ? PathOfItem(params["item"]) : PathOfDocument(params));
    WorkspaceProgram* program = workspace_.ProgramOf(identity, Publisher());
    if (program == nullptr || program->analysis->compilation().dialect == nullptr) return nullptr;
    Analysis& analysis = *program->analysis;
    const source::FileId file = analysis.FileOf(identity);
    if (!file.valid()) {
      const Document* const open = workspace_.documents().Find(identity);
      if (feature != Completion || open == nullptr || !IsMachineFile(*program, identity)) return nullptr;
      return CompleteMachineFile(workspace_, *program, *open, params);
    }
    return feature({workspace_, *program, analysis, analysis.NamesWith(program->Meaning()), file}, params);
  });
}

void LanguageServer::AddMethods() {
  server_.SetGate([this](std::string_view method) { CheckState(method); });
  server_.SetCancel("$/cancelRequest", "id");
  const auto add = [this](const char* name, rpc::Server::Method method) { server_.Add(name, std::move(method)); };
  const auto nothing = [](const Json&) -> Json { return nullptr; };
  add("initialize", [this](const Json& params) { return Initialize(params); });
  add("initialized", nothing);
  add("$/cancelRequest", nothing);
  add("$/setTrace", nothing);
  add("workspace/didChangeConfiguration", nothing);
  add("textDocument/willSave", nothing);
  add("shutdown", [this](const Json&) -> Json {
    state_ = State::kShutDown;
    was_shut_down_ = true;
    return nullptr;
  });
  add("exit", [this](const Json&) -> Json {
    state_ = State::kEnded;
    return nullptr;
  });
  add("textDocument/didOpen", [this](const Json& params) -> Json {
    workspace_.Changed(source::FileIdentity(workspace_.documents().Open(params).path));
    return nullptr;
  });
  add("textDocument/didChange", [this](const Json& params) -> Json {
    workspace_.Changed(source::FileIdentity(workspace_.documents().Change(params, workspace_.units()).path));
    return nullptr;
  });
  add("textDocument/didClose", [this](const Json& params) -> Json {
    const std::string path = workspace_.documents().Close(params);
    if (!path.empty()) workspace_.Closed(source::FileIdentity(path), Publisher());
    return nullptr;
  });
  add("textDocument/didSave", [this](const Json&) -> Json {
    workspace_.ChangedOnDisk();
    return nullptr;
  });
  add("workspace/didChangeWatchedFiles", [this](const Json&) -> Json {
    workspace_.ChangedOnDisk();
    return nullptr;
  });
  add("workspace/symbol", [this](const Json& params) { return WorkspaceSymbols(params); });
  add("workspace/executeCommand", [this](const Json& params) { return ExecuteCommand(params); });
  add("plcxx/program", [this](const Json& params) { return ProgramOf(params); });
  AddFeatures();
}

void LanguageServer::AddFeatures() {
  constexpr std::pair<const char*, Feature> kFeatures[] = {{"textDocument/codeAction", CodeActions},
                                                           {"textDocument/hover", Hover},
                                                           {"textDocument/definition", GoToDefinition},
                                                           {"textDocument/references", References},
                                                           {"textDocument/documentHighlight", DocumentHighlights},
                                                           {"textDocument/documentSymbol", DocumentSymbols},
                                                           {"textDocument/completion", Completion},
                                                           {"textDocument/signatureHelp", SignatureHelp},
                                                           {"textDocument/prepareRename", PrepareRename},
                                                           {"textDocument/rename", Rename},
                                                           {"textDocument/semanticTokens/full", SemanticTokens},
                                                           {"textDocument/foldingRange", FoldingRanges},
                                                           {"textDocument/prepareCallHierarchy", PrepareCallHierarchy},
                                                           {"callHierarchy/incomingCalls", IncomingCalls},
                                                           {"callHierarchy/outgoingCalls", OutgoingCalls}};
  for (const auto& [method, feature] : kFeatures) AddFeature(method, feature);
}

Json LanguageServer::WorkspaceSymbols(const Json& params) {
  const support::FaultGuard guard;
  const std::string query = rpc::OptionalText(params, "query").value_or("");
  while (workspace_.AnalyseNext(Publisher())) {
  }
  Json symbols = Json::array();
  for (const auto& program : workspace_.programs()) {
    if (program->analysis == nullptr || program->analysis->compilation().dialect == nullptr) continue;
    Analysis& analysis = *program->analysis;
    const Names& names = analysis.NamesWith(program->Meaning());
    AddWorkspaceSymbols({workspace_, *program, analysis, names, source::FileId(0)}, query, symbols);
  }
  return symbols;
}

/// The answer goes to who asked, and as a message to the user: most editors show no results of commands.
Json LanguageServer::ExecuteCommand(const Json& params) {
  const support::FaultGuard guard;
  const std::string command = rpc::TextOf(params, "command");
  if (command != kWhyCommand) throw rpc::Error(rpc::kInvalidParams, "unknown command '" + command + "'");
  const Json arguments = params.value("arguments", Json::array());
  if (!arguments.is_array() || arguments.size() != 1) {
    throw rpc::Error(rpc::kInvalidParams, "'arguments' has one object: uri, signal, scenario");
  }
  const Json& asked = arguments.front();
  const WorkspaceProgram* program = workspace_.ProgramOf(source::FileIdentity(PathOfItem(asked)), Publisher());
  if (program == nullptr) throw rpc::Error(rpc::kInvalidParams, "the file is part of no program");
  const std::string scenario = rpc::TextOf(asked, "scenario");
  if (std::ranges::find(workspace_.ScenariosOf(*program), scenario) == workspace_.ScenariosOf(*program).end()) {
    throw rpc::Error(rpc::kInvalidParams, "'" + scenario + "' is no scenario of the program");
  }
  const std::string text = workspace_.Why(*program, scenario, rpc::TextOf(asked, "signal"));
  server_.Notify("window/showMessage", {{"type", 3}, {"message", text}});
  return text;
}

/// Our own: what a file belongs to, which need not be open; null where it is no part of a program. An editor has one
/// language for each extension, and we have three in ".plc"; its commands run plcxx for the program.
Json LanguageServer::ProgramOf(const Json& params) {
  const support::FaultGuard guard;
  const std::string path = PathOfDocument(params);
  workspace_.OpenProjectOf(path);
  const WorkspaceProgram* program = workspace_.ProgramOf(source::FileIdentity(path), Publisher());
  if (program == nullptr || program->analysis->compilation().dialect == nullptr) return nullptr;
  Json sources = Json::array();
  for (const std::string& source : program->request.sources) {
    sources.push_back(source::FileIdentity(compilation::FromBase(program->request.base_directory, source)));
  }
  return {{"dialect", program->analysis->compilation().dialect->name},
          {"project", program->project.empty() ? Json() : Json(source::FileIdentity(program->project))},
          {"program", program->name},
          {"sources", std::move(sources)}};
}

}  // namespace

std::string UriOf(const Documents& documents, std::string_view identity) {
  const Document* open = documents.Find(identity);
  return open != nullptr ? open->uri : UriOfPath(identity);
}

std::string FeatureContext::UriOf(source::FileId id) const {
  return lsp::UriOf(workspace.documents(), analysis.IdentityOf(id));
}

source::Offset FeatureContext::OffsetOf(const Json& params) const {
  return analysis.OffsetOf(file, ReadPosition(rpc::ObjectOf(params, "position")));
}

const dialects::EditorToken* FeatureContext::TokenAt(const Json& params) const {
  return names.TokenAt(file, OffsetOf(params));
}

dialects::Request FeatureContext::RequestOf(diag::Engine& unused) const {
  dialects::Request request = analysis.MakeRequest();
  request.diagnostics = &unused;
  return request;
}

int Serve(ScenarioAnswers answers) { return LanguageServer(std::move(answers)).Run(); }

}  // namespace plcxx::lsp
