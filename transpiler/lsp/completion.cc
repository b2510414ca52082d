// What can be written at a place, and what an instruction takes.
#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "transpiler/lsp/features.h"

namespace plcxx::lsp {
namespace {

using dialects::Definition;
using dialects::DefinitionKind;
using dialects::EditorToken;
using dialects::TokenRole;

constexpr size_t kMaxItems = 300;

/// CompletionItemKind of the protocol.
int ItemKindOf(DefinitionKind kind) {
  switch (kind) {
    case DefinitionKind::kSignal:
    case DefinitionKind::kVariable:
    case DefinitionKind::kParameter:
    case DefinitionKind::kBlock:
      return 6;  // Variable
    case DefinitionKind::kConstant:
      return 21;  // Constant
    case DefinitionKind::kLabel:
      return 18;  // Reference
    case DefinitionKind::kRoutine:
    case DefinitionKind::kMacro:
      return 3;  // Function
    case DefinitionKind::kType:
      return 22;  // Struct
    case DefinitionKind::kField:
      return 5;  // Field
  }
  return 6;
}

int ItemKindOf(TokenRole role) { return role == TokenRole::kFunction ? 3 : 14; }  // Function, Keyword

bool StartsWith(std::string_view text, std::string_view prefix) {
  return text.size() >= prefix.size() &&
         std::equal(prefix.begin(), prefix.end(), text.begin(),
                    [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

class Items {
 public:
  /// `range`: what an item replaces, of which `prefix` is there.
  Items(Json range, std::string_view prefix) : range_(std::move(range)), prefix_(prefix) {}
  Items(const FeatureContext& context, source::Range replaced, std::string_view prefix)
      : range_(ToJson(context.analysis.Locate(replaced))), prefix_(prefix), mark_(context.names.editing().name_mark) {
    const source::Offset begin = replaced.begin;
    if (!mark_.empty() && context.analysis.sources().Text({begin - 1, begin}) == mark_) mark_ = {};
  }

  /// A name of the source, which may need a mark in front of it.
  void AddName(const std::string& name, int kind, const std::string& detail, const std::string& meaning) {
    const size_t before = items_.size();
    Add(name, kind, detail, meaning);
    if (items_.size() > before) items_.back()["textEdit"]["newText"] = std::string(mark_) + name;
  }
  void Add(const std::string& name, int kind, const std::string& detail, const std::string& meaning) {
    if (!StartsWith(name, prefix_) || !seen_.insert(name).second) return;
    if (items_.size() >= kMaxItems) {
      complete_ = false;
      return;
    }
    Json item = {{"label", name}, {"kind", kind}, {"textEdit", {{"range", range_}, {"newText", name}}}};
    if (!detail.empty()) item["detail"] = detail;
    if (!meaning.empty()) item["documentation"] = meaning;
    items_.push_back(std::move(item));
  }
  Json Result() { return {{"isIncomplete", !complete_}, {"items", std::move(items_)}}; }

 private:
  Json range_;
  std::string_view prefix_;
  std::string_view mark_;  // empty: it is there already
  std::set<std::string> seen_;
  Json items_ = Json::array();
  bool complete_ = true;
};

std::string JoinedParameters(const std::vector<std::string>& parameters) {
  std::string text;
  for (const std::string& parameter : parameters) text += (text.empty() ? "" : ", ") + parameter;
  return text;
}

/// The word that is being written, up to the place.
source::Range WordBefore(const FeatureContext& context, source::Offset at) {
  const source::File& file = context.analysis.sources().Get(context.file);
  const EditorToken* token = at > file.base ? context.names.TokenAt(context.file, at - 1) : nullptr;
  if (token == nullptr || token->range.end < at) return {at, at};
  switch (token->role) {
    case TokenRole::kKeyword:
    case TokenRole::kMnemonic:
    case TokenRole::kFunction:
    case TokenRole::kAddress:
    case TokenRole::kName:
    case TokenRole::kMember:
      return {std::min(context.names.NamePartOf(*token).begin, at), at};
    case TokenRole::kComment:
    case TokenRole::kNumber:
    case TokenRole::kText:
    case TokenRole::kOperator:
      return {at, at};
  }
  return {at, at};
}

bool IsInText(const FeatureContext& context, source::Offset at) {
  const EditorToken* token = context.names.TokenAt(context.file, at);
  return token != nullptr && token->range.begin < at &&
         (token->role == TokenRole::kComment || (token->role == TokenRole::kText && at < token->range.end));
}

/// A call or an instruction around a place: its word, and which of its operands is being written.
struct Invocation {
  const EditorToken* word = nullptr;
  uint32_t operand = 0;
};

Invocation InvocationAt(const FeatureContext& context, source::Offset at) {
  const Names& names = context.names;
  const bool in_brackets = names.editing().opening != " ";
  const std::vector<EditorToken>& tokens = names.TokensOf(context.file);
  const auto end = std::ranges::lower_bound(tokens, at, {}, [](const EditorToken& token) { return token.range.begin; });
  constexpr ptrdiff_t kMaxTokens = 200;
  const int64_t line = context.analysis.Locate({at, at}).begin.line;
  uint32_t separators = 0;
  int depth = 0;
  for (auto it = end; it != tokens.begin() && end - it < kMaxTokens;) {
    --it;
    if (!in_brackets && context.analysis.Locate(it->range).begin.line != line) break;
    const std::string_view text = names.TextOf(*it);
    if (it->role == TokenRole::kOperator && text.size() == 1) {
      if (names.editing().separators.find(text[0]) != std::string_view::npos && depth == 0) ++separators;
      if (text[0] == ')' || text[0] == ']') ++depth;
      if ((text[0] == '(' || text[0] == '[') && depth-- == 0 && in_brackets) {
        return it == tokens.begin() ? Invocation{} : Invocation{&*std::prev(it), separators};
      }
      if (text[0] == ';' || text[0] == '{') break;
    }
    const bool is_instruction = it->role == TokenRole::kMnemonic || it->role == TokenRole::kFunction;
    if (!in_brackets && is_instruction && it->range.end < at) return {&*it, separators};
  }
  return {};
}

Json Signature(const std::string& name, const std::string& meaning, const std::vector<std::string>& parameters,
               std::string_view between, std::string_view behind) {
  Json json = {{"label", name + std::string(between) + JoinedParameters(parameters) + std::string(behind)}};
  if (!meaning.empty()) json["documentation"] = meaning;
  json["parameters"] = Json::array();
  for (const std::string& parameter : parameters) json["parameters"].push_back({{"label", parameter}});
  return json;
}

/// "int a, long b" of "void f(int a, long b)".
std::vector<std::string> ParametersOf(std::string_view declaration) {
  std::vector<std::string> parameters;
  const size_t open = declaration.find('('), close = declaration.rfind(')');
  if (open == std::string_view::npos || close == std::string_view::npos) return parameters;
  std::string_view rest = declaration.substr(open + 1, close - open - 1);
  while (!rest.empty()) {
    const size_t end = std::min(rest.find(", "), rest.size());
    parameters.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 2, rest.size()));
  }
  return parameters;
}

/// What the program and its control call by address.
void AddAddresses(const FeatureContext& context, Items& items) {
  const Names& names = context.names;
  for (const ir::Documentation& known : names.program().documentation) {
    const bool is_spelling = !known.address.starts_with('=') && known.address.find('+') == std::string::npos;
    if (is_spelling) items.Add(known.address, ItemKindOf(DefinitionKind::kSignal), known.symbols, known.meaning);
  }
  diag::Engine unused;
  for (const dialects::ControlSignal& signal : names.editing().signals(context.RequestOf(unused))) {
    items.Add(signal.address, ItemKindOf(DefinitionKind::kSignal), signal.name, signal.meaning);
    if (signal.has_name_in_programs) {
      items.Add(signal.name, ItemKindOf(DefinitionKind::kSignal), signal.address, signal.meaning);
    }
  }
}

/// Of a location's name in any language, as YAML has it.
bool IsOfLocation(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || std::isalnum(byte) != 0 || c == '_' || c == '.' || c == '%';
}

}  // namespace

Json Completion(const FeatureContext& context, const Json& params) {
  const source::Offset at = context.OffsetOf(params);
  const source::Range replaced = WordBefore(context, at);
  const std::string_view prefix = context.analysis.sources().Text(replaced);
  Items items(context, replaced, prefix);
  if (IsInText(context, at)) return items.Result();
  const Names& names = context.names;
  for (const Definition& definition : names.definitions()) {
    if (definition.kind == DefinitionKind::kBlock || !names.IsVisible(definition, at)) continue;
    items.AddName(definition.name, ItemKindOf(definition.kind), definition.detail, definition.comment);
  }
  for (const dialects::Word& word : names.editing().words()) {
    items.Add(word.name, ItemKindOf(word.role), JoinedParameters(word.parameters), word.meaning);
  }
  if (!prefix.empty()) AddAddresses(context, items);  // the control has thousands of signals
  return items.Result();
}

Json CompleteMachineFile(const Workspace& workspace, WorkspaceProgram& program, const Document& document,
                         const Json& params) {
  const Lines lines(document.text, workspace.units());
  const size_t at = lines.Offset(ReadPosition(rpc::ObjectOf(params, "position")));
  size_t begin = at;
  while (begin > 0 && IsOfLocation(document.text[begin - 1])) --begin;
  const std::string_view prefix = std::string_view(document.text).substr(begin, at - begin);
  Items items({{"start", ToJson(lines.At(begin))}, {"end", ToJson(lines.At(at))}}, prefix);
  const Names& names = program.analysis->NamesWith(program.Meaning());
  for (const Definition& definition : names.definitions()) {
    if (definition.kind != DefinitionKind::kSignal && definition.kind != DefinitionKind::kVariable) continue;
    items.Add(definition.name, ItemKindOf(definition.kind), definition.detail, definition.comment);
  }
  if (!prefix.empty()) AddAddresses({workspace, program, *program.analysis, names, source::FileId(0)}, items);
  return items.Result();
}

Json SignatureHelp(const FeatureContext& context, const Json& params) {
  const Invocation invocation = InvocationAt(context, context.OffsetOf(params));
  if (invocation.word == nullptr) return nullptr;
  const Names& names = context.names;
  const std::string key = names.editing().key(names.TextOf(*invocation.word));
  const bool in_brackets = names.editing().opening != " ";
  Json signatures = Json::array();
  for (const dialects::Word& word : names.editing().words()) {
    if (names.editing().key(word.name) != key || word.parameters.empty()) continue;
    signatures.push_back(
        Signature(word.name, word.meaning, word.parameters, in_brackets ? "(" : " ", in_brackets ? ")" : ""));
  }
  const Target target = names.TargetOf(*invocation.word);
  if (target.definition != kNoDefinition) {
    const Definition& definition = names.definitions()[target.definition];
    const std::vector<std::string> parameters = ParametersOf(definition.detail);
    if (!parameters.empty()) {
      signatures.push_back(Signature(definition.name, definition.comment, parameters, "(", ")"));
    }
  }
  if (signatures.empty()) return nullptr;
  const size_t count = signatures[0]["parameters"].size();
  return {{"signatures", std::move(signatures)},
          {"activeSignature", 0},
          {"activeParameter", std::min<size_t>(invocation.operand, count - 1)}};
}

}  // namespace plcxx::lsp
