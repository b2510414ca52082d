#include <nlohmann/json.hpp>

#include "transpiler/diagnostics/places.h"
#include "transpiler/diagnostics/render.h"
#include "transpiler/diagnostics/terminal_text.h"

namespace plcxx::diag {
namespace {

using Json = nlohmann::ordered_json;

void AddPlace(Json& object, const source::SourceManager& sources, source::Range range) {
  if (!HasPlace(range)) {
    for (const char* field : {"file", "line", "column", "endLine", "endColumn", "byteOffset", "byteLength"}) {
      object[field] = nullptr;
    }
    return;
  }
  const Place place = PlaceOf(sources, range);
  object["file"] = place.path;
  object["line"] = place.begin.line;
  object["column"] = place.begin.column;
  object["endLine"] = place.end.line;
  object["endColumn"] = place.end.column;
  object["byteOffset"] = place.byte_offset;
  object["byteLength"] = place.byte_length;
}

Json ToJson(const source::SourceManager& sources, const Note& note) {
  Json object = {{"message", note.text}};
  AddPlace(object, sources, note.range);
  return object;
}

Json ToJson(const source::SourceManager& sources, const FixIt& fixit) {
  Json object = {{"replacement", fixit.replacement}};
  AddPlace(object, sources, fixit.range);
  return object;
}

Json ToJson(const source::SourceManager& sources, const Diagnostic& diagnostic) {
  Json object;
  object["code"] = diagnostic.row->code;
  object["severity"] = SeverityName(diagnostic.severity);
  object["message"] = diagnostic.text;
  object["help"] = diagnostic.remedy;
  AddPlace(object, sources, diagnostic.range);
  object["notes"] = Json::array();
  for (const Note& note : diagnostic.notes) object["notes"].push_back(ToJson(sources, note));
  object["fixits"] = Json::array();
  for (const FixIt& fixit : diagnostic.fixits) object["fixits"].push_back(ToJson(sources, fixit));
  return object;
}

}  // namespace

std::string RenderJson(const source::SourceManager& sources, std::span<const Diagnostic> diagnostics) {
  Json all = Json::array();
  for (const Diagnostic& diagnostic : diagnostics) all.push_back(ToJson(sources, diagnostic));
  // A path may be no UTF-8, which JSON cannot hold.
  return JsonForTerminals(all.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace plcxx::diag
