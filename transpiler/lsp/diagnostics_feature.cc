// What `check` finds, as the protocol's diagnostics; their repairs as code actions.
#include <set>

#include "transpiler/diagnostics/places.h"
#include "transpiler/lsp/features.h"
#include "transpiler/lsp/workspace.h"

namespace plcxx::lsp {
namespace {

int SeverityOf(diag::Severity severity) {
  switch (severity) {
    case diag::Severity::kError:
      return 1;
    case diag::Severity::kWarning:
      return 2;
    case diag::Severity::kNote:
      return 3;
  }
  return 1;
}

std::string Written(Position position) {
  return R"({"character":)" + std::to_string(position.character) + R"(,"line":)" + std::to_string(position.line) + "}";
}

std::string Written(const FileRange& range) {
  return R"({"end":)" + Written(range.end) + R"(,"start":)" + Written(range.begin) + "}";
}

/// Text at once: a program may have thousands, and trees of all of them would cost a fourth of what a key may.
std::string Written(const Analysis& analysis, const diag::Diagnostic& diagnostic, const FileRange& at) {
  std::string text = diagnostic.text;
  if (!diagnostic.remedy.empty()) text += "\nhelp: " + diagnostic.remedy;
  std::string notes;
  for (const diag::Note& note : diagnostic.notes) {
    if (!diag::HasPlace(note.range)) continue;
    const FileRange place = analysis.Locate(note.range);
    notes += notes.empty() ? R"("relatedInformation":[)" : ",";
    notes += R"({"location":{"range":)" + Written(place) + R"(,"uri":)" +
             rpc::Quoted(UriOfPath(analysis.IdentityOf(place.file))) + R"(},"message":)" + rpc::Quoted(note.text) + "}";
  }
  if (!notes.empty()) notes += "],";
  return R"({"code":)" + rpc::Quoted(diagnostic.row->code) + R"(,"message":)" + rpc::Quoted(text) + R"(,"range":)" +
         Written(at) + "," + notes + R"("severity":)" + std::to_string(SeverityOf(diagnostic.severity)) +
         R"(,"source":"plcxx"})";
}

bool Touches(source::Range a, source::Range b) { return a.begin <= b.end && b.begin <= a.end; }

}  // namespace

FileDiagnostics DiagnosticsByFile(const Analysis& analysis) {
  FileDiagnostics by_file;
  for (const diag::Diagnostic& diagnostic : analysis.compilation().diagnostics.all()) {
    if (analysis.sources().size() == 0) break;
    const FileRange at = analysis.Locate(diagnostic.range);
    by_file[analysis.IdentityOf(at.file)].push_back(Written(analysis, diagnostic, at));
  }
  return by_file;
}

std::vector<std::string> ProjectFaults(const std::vector<yaml::Error>& errors) {
  std::vector<std::string> faults;
  for (const yaml::Error& error : errors) {
    const Position begin{error.mark.line == 0 ? 0 : int64_t{error.mark.line} - 1,
                         error.mark.column == 0 ? 0 : int64_t{error.mark.column} - 1};
    const std::string text = error.message + (error.remedy.empty() ? "" : "\nhelp: " + error.remedy);
    faults.push_back(rpc::Written({{"range", {{"start", ToJson(begin)}, {"end", ToJson(begin)}}},
                                   {"severity", 1},
                                   {"source", "plcxx"},
                                   {"message", text}}));
  }
  return faults;
}

Json CodeActions(const FeatureContext& context, const Json& params) {
  const Json& range = rpc::ObjectOf(params, "range");
  const source::Range asked = {context.analysis.OffsetOf(context.file, ReadPosition(rpc::ObjectOf(range, "start"))),
                               context.analysis.OffsetOf(context.file, ReadPosition(rpc::ObjectOf(range, "end")))};
  Json actions = Json::array();
  for (const diag::Diagnostic& diagnostic : context.analysis.compilation().diagnostics.all()) {
    if (diagnostic.fixits.empty() || !Touches(diagnostic.range, asked)) continue;
    if (context.analysis.sources().FileAt(diagnostic.range.begin) != context.file) continue;
    const FileRange diagnosed = context.analysis.Locate(diagnostic.range);
    std::string title;
    Json changes = Json::object();
    for (const diag::FixIt& fixit : diagnostic.fixits) {
      if (!title.empty()) title += ", ";
      title += diag::DescriptionOf(context.analysis.sources(), fixit);
      const FileRange at = context.analysis.Locate(fixit.range);
      changes[context.UriOf(at.file)].push_back({{"range", ToJson(at)}, {"newText", fixit.replacement}});
    }
    actions.push_back({{"title", title},
                       {"kind", "quickfix"},
                       {"isPreferred", true},
                       {"diagnostics", {Json::parse(Written(context.analysis, diagnostic, diagnosed))}},
                       {"edit", {{"changes", changes}}}});
  }
  AddWhyActions(context, params, actions);
  return actions;
}

}  // namespace plcxx::lsp
