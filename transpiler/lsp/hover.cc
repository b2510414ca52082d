// What a word means: type, address, comments, who reads and writes it; of a message its page.
#include <algorithm>

#include "transpiler/diagnostics/explain.h"
#include "transpiler/lsp/features.h"
#include "transpiler/lsp/uses.h"

namespace plcxx::lsp {
namespace {

using dialects::Definition;
using dialects::EditorToken;

constexpr size_t kMaxPlaces = 12;

std::string FileNameOf(std::string_view path) { return std::string(path.substr(path.rfind('/') + 1)); }

/// "fast.plc:12, spindle.plc:3", each a link.
std::string PlacesText(const FeatureContext& context, const std::vector<source::Range>& ranges) {
  const Analysis& meaning = context.program.Meaning();
  std::string text;
  for (size_t i = 0; i < ranges.size(); ++i) {
    if (i == kMaxPlaces) return text + " and " + std::to_string(ranges.size() - i) + " more";
    const FileRange at = meaning.Locate(ranges[i]);
    const std::string& path = meaning.IdentityOf(at.file);
    const std::string line = std::to_string(at.begin.line + 1);
    text += (i == 0 ? "" : ", ") + ("[" + FileNameOf(path) + ":" + line + "](" + UriOfPath(path) + "#L" + line + ")");
  }
  return text.empty() ? "nowhere" : text;
}

/// A paragraph; what is there already, as a comment that the author wrote and the table of signals repeats, is not said
/// twice.
void AddLine(std::string& text, std::string_view line) {
  if (line.empty()) return;
  const std::string before = "\n\n" + text + "\n\n";
  if (before.find("\n\n" + std::string(line) + "\n\n") != std::string::npos) return;
  if (!text.empty()) text += "\n\n";
  text += line;
}

std::string TypeText(const ir::Program& program, const dialects::Location& location) {
  const ir::Place& place = location.place;
  std::string text;
  if (place.is_field()) {
    const ir::StateInstance& state = program.states[place.state];
    return std::string(ir::Info(state.kind).text) + " " + state.name + ", " +
           std::string(ir::Info(state.kind).fields[place.field].name) + ": " + std::string(ir::Name(place.type));
  }
  text = std::string(ir::Name(place.type));
  if (place.space.valid()) {
    const ir::Space& space = program.spaces[place.space];
    text += " in " + (space.title.empty() ? space.name : space.title);
    text += ", byte " + std::to_string(place.offset);
    if (place.bit != ir::kNoBit) text += ", bit " + std::to_string(place.bit);
  }
  return text;
}

std::string SignatureText(const dialects::Word& word) {
  std::string text = word.name;
  for (size_t i = 0; i < word.parameters.size(); ++i) text += (i == 0 ? " " : ", ") + word.parameters[i];
  return text;
}

std::string WordText(const Names& names, std::string_view spelling) {
  const std::string key = names.editing().key(spelling);
  std::string text;
  for (const dialects::Word& word : names.editing().words()) {
    if (names.editing().key(word.name) != key) continue;
    AddLine(text, "`" + SignatureText(word) + "`");
    if (word.meaning != word.name) AddLine(text, word.meaning);
  }
  return text;
}

void AddSignal(const FeatureContext& context, const Target& target, std::string_view spelling, std::string& text) {
  const Names& names = context.names;
  if (const ir::Documentation* known = DocumentationOf(names, target, spelling)) {
    if (known->address != spelling) AddLine(text, "address `" + known->address + "`");
    if (!known->symbols.empty() && known->symbols != spelling) AddLine(text, "symbols " + known->symbols);
    if (!known->predefined.empty() && known->predefined != spelling)
      AddLine(text, "signal of the control: " + known->predefined);
    AddLine(text, known->meaning);
    AddLine(text, known->help);
  } else {
    const std::string key = names.editing().key(spelling);
    diag::Engine unused;
    for (const dialects::ControlSignal& signal : names.editing().signals(context.RequestOf(unused))) {
      if (names.editing().key(signal.address) != key && signal.name != spelling) continue;
      AddLine(text, (signal.name == spelling ? "" : signal.name + ": ") + signal.meaning);
    }
  }
  if (!target.bits) return;
  const Uses uses = UsesOf(names.program(), *target.bits);
  AddLine(text, "written: " + PlacesText(context, uses.writes));
  AddLine(text, "read: " + PlacesText(context, uses.reads));
}

std::string MeaningOf(const FeatureContext& context, const EditorToken& token) {
  const Names& names = context.names;
  const Target target = names.TargetOf(token);
  const std::string spelling(names.TextOf(token));
  if (!target.known()) return WordText(names, spelling);
  std::string text = "**" + spelling + "**";
  std::string address = spelling;
  if (target.definition != kNoDefinition) {
    const Definition& definition = names.definitions()[target.definition];
    if (!definition.detail.empty()) text += " `" + definition.detail + "`";
    AddLine(text, definition.comment);
    if (!definition.address.empty()) address = definition.address;
  }
  if (target.bits) {
    if (const auto location = names.Locate(address)) AddLine(text, TypeText(names.program(), *location));
    AddSignal(context, target, spelling, text);
  }
  return text;
}

}  // namespace

Json Hover(const FeatureContext& context, const Json& params) {
  const source::Offset at = context.OffsetOf(params);
  std::string text;
  source::Range range{at, at};
  if (const EditorToken* token = context.names.TokenAt(context.file, at)) {
    text = MeaningOf(context, *token);
    range = token->range;
  }
  std::vector<std::string_view> shown;
  for (const diag::Diagnostic& diagnostic : context.analysis.compilation().diagnostics.all()) {
    if (at < diagnostic.range.begin || at > diagnostic.range.end) continue;
    const auto page = diag::Explain(diagnostic.row->code);
    if (!page || std::ranges::find(shown, diagnostic.row->code) != shown.end()) continue;
    shown.push_back(diagnostic.row->code);
    AddLine(text, (text.empty() ? "" : "---\n\n") + std::string(*page));
  }
  if (text.empty()) return nullptr;
  return {{"contents", {{"kind", "markdown"}, {"value", text}}}, {"range", ToJson(context.analysis.Locate(range))}};
}

}  // namespace plcxx::lsp
