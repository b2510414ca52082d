// A name replaced wherever it is mentioned, and only where the program stays the same program.
#include <algorithm>
#include <map>

#include "transpiler/lsp/features.h"

namespace plcxx::lsp {
namespace {

using dialects::Definition;
using dialects::DefinitionKind;
using dialects::EditorToken;

[[noreturn]] void RefuseRename(const std::string& why) { throw rpc::Error(rpc::kRequestFailed, why); }

/// The definition that can be renamed from a place; throws where there is none.
uint32_t RenamedAt(const FeatureContext& context, const EditorToken* token) {
  const Target target = token == nullptr ? Target{} : context.names.TargetOf(*token);
  if (target.definition == kNoDefinition) {
    RefuseRename(target.bits ? "an address has no name that could be changed"
                             : "there is no name that the program defines");
  }
  const Definition& definition = context.names.definitions()[target.definition];
  if (definition.name_range.begin == definition.name_range.end) RefuseRename("the name is not spelled in the sources");
  return target.definition;
}

std::vector<source::Range> Spellings(const FeatureContext& context, uint32_t definition) {
  return context.names.MentionsOf({.definition = definition, .bits = std::nullopt});
}

/// Which statement an id means; ids are made from a statement's text, which the new name changes.
std::map<uint32_t, uint32_t> StatementsById(const ir::Program& program) {
  std::map<uint32_t, uint32_t> statements;
  for (uint32_t i = 0; i < program.statements.size(); ++i) {
    statements.emplace(program.statements[ir::StatementId(i)].id, i);
  }
  return statements;
}

/// Do both programs do the same, instruction by instruction, with the same places of memory?
bool IsSameProgram(const ir::Program& a, const ir::Program& b) {
  const std::map<uint32_t, uint32_t> in_a = StatementsById(a), in_b = StatementsById(b);
  const auto same_statement = [&](const ir::Inst& x, const ir::Inst& y) {
    const auto one = in_a.find(x.a), other = in_b.find(y.a);
    return x.op == ir::OpKind::kConst && one != in_a.end() && other != in_b.end() && one->second == other->second;
  };
  const auto same_inst = [&](const ir::Inst& x, const ir::Inst& y) {
    if (x.op != y.op || x.type != y.type || x.payload != y.payload) return false;
    return (x.a == y.a && x.b == y.b && x.c == y.c) || same_statement(x, y);
  };
  const auto same_place = [](const ir::Place& x, const ir::Place& y) {
    return x.type == y.type && x.space == y.space && x.offset == y.offset && x.bit == y.bit && x.state == y.state &&
           x.field == y.field && x.indexed == y.indexed && x.stride == y.stride && x.low == y.low && x.high == y.high;
  };
  return std::ranges::equal(a.insts, b.insts, same_inst) && std::ranges::equal(a.places, b.places, same_place);
}

/// The texts of all files that change, with the new name.
std::map<std::string, std::string> ChangedTexts(const FeatureContext& context,
                                                const std::vector<source::Range>& spellings, const std::string& name) {
  std::map<std::string, std::string> texts;
  const source::SourceManager& sources = context.analysis.sources();
  for (auto range = spellings.rbegin(); range != spellings.rend(); ++range) {  // from the end: places stay
    const source::FileId id = sources.FileAt(range->begin);
    const source::File& file = sources.Get(id);
    const auto [text, is_new] = texts.try_emplace(context.analysis.IdentityOf(id), file.text);
    text->second.replace(range->begin - file.base, range->end - range->begin, name);
  }
  return texts;
}

}  // namespace

Json PrepareRename(const FeatureContext& context, const Json& params) {
  const EditorToken* token = context.TokenAt(params);
  RenamedAt(context, token);
  const source::Range part = context.names.NamePartOf(*token);
  return {{"range", ToJson(context.analysis.Locate(part))}, {"placeholder", context.analysis.sources().Text(part)}};
}

Json Rename(const FeatureContext& context, const Json& params) {
  const std::string name = rpc::TextOf(params, "newName");
  const uint32_t renamed = RenamedAt(context, context.TokenAt(params));
  if (!context.analysis.compilation().ok()) RefuseRename("the program has errors: they are to be mended first");
  if (name.empty() || name.find_first_of("\r\n") != std::string::npos) RefuseRename("the new name is none");
  std::vector<source::Range> spellings = Spellings(context, renamed);
  std::ranges::sort(spellings, {}, [](source::Range range) { return range.begin; });

  // What other names would then mean, and whether the language takes the new one, only the language can tell.
  Documents documents = context.workspace.documents();
  for (auto& [identity, text] : ChangedTexts(context, spellings, name)) documents.Replace(identity, std::move(text));
  const Analysis after(context.program.request, context.program.baseline, documents, context.workspace.units(),
                       nullptr);
  for (const diag::Diagnostic& diagnostic : after.compilation().diagnostics.all()) {
    if (diagnostic.severity == diag::Severity::kError) RefuseRename("'" + name + "' is refused: " + diagnostic.text);
  }
  if (!IsSameProgram(context.analysis.program(), after.program())) {
    RefuseRename("with the name '" + name + "' the program would be another one");
  }
  Json changes = Json::object();
  for (const source::Range range : spellings) {
    const FileRange at = context.analysis.Locate(range);
    changes[context.UriOf(at.file)].push_back({{"range", ToJson(at)}, {"newText", name}});
  }
  return {{"changes", changes}};
}

}  // namespace plcxx::lsp
