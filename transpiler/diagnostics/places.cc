#include "transpiler/diagnostics/places.h"

#include "transpiler/support/check.h"

namespace plcxx::diag {

Place PlaceOf(const source::SourceManager& sources, source::Range range) {
  Place place;
  place.begin = place.end = sources.Locate(range.begin);
  PLCXX_CHECK(place.begin.file.valid());
  place.path = sources.Get(place.begin.file).path;
  place.byte_offset = sources.OriginalByte(range.begin);
  if (range.end <= range.begin || sources.FileAt(range.end) != place.begin.file) return place;
  place.end = sources.Locate(range.end);
  place.byte_length = sources.OriginalByte(range.end) - place.byte_offset;
  return place;
}

std::string DescriptionOf(const source::SourceManager& sources, const FixIt& fixit) {
  const std::string found(sources.Text(fixit.range));
  if (found.empty()) return "insert '" + fixit.replacement + "'";
  if (fixit.replacement.empty()) return "delete '" + found + "'";
  return "replace '" + found + "' by '" + fixit.replacement + "'";
}

std::string_view SeverityName(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "error";
    case Severity::kWarning:
      return "warning";
    case Severity::kNote:
      return "note";
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::diag
