#include "transpiler/dialects/classicladder/source/lines.h"

#include "transpiler/support/check.h"

namespace plcxx::classicladder {
namespace {

constexpr std::string_view kPartMark = "_FILE-", kPartEndMark = "_/FILE-";

LineKind KindOf(std::string_view text) {
  if (text.starts_with("_FILES_CLASSICLADDER")) return LineKind::kProject;
  if (text.starts_with("_/FILES_CLASSICLADDER")) return LineKind::kProjectEnd;
  if (text.starts_with(kPartMark)) return LineKind::kPart;
  if (text.starts_with(kPartEndMark)) return LineKind::kPartEnd;
  if (text.empty()) return LineKind::kBlank;
  if (text.front() == ';') return LineKind::kComment;
  return text.front() == '#' ? LineKind::kDirective : LineKind::kData;
}

}  // namespace

std::string_view Name(LineKind kind) {
  switch (kind) {
    case LineKind::kProject:
      return "project";
    case LineKind::kProjectEnd:
      return "project-end";
    case LineKind::kPart:
      return "part";
    case LineKind::kPartEnd:
      return "part-end";
    case LineKind::kComment:
      return "comment";
    case LineKind::kDirective:
      return "directive";
    case LineKind::kBlank:
      return "blank";
    case LineKind::kData:
      return "data";
  }
  PLCXX_UNREACHABLE();
}

std::vector<Line> LinesOfProject(const source::SourceManager& sources, source::FileId file) {
  std::vector<Line> lines;
  const source::File& text = sources.Get(file);
  for (uint32_t number = 1; number <= sources.LineCount(file); ++number) {
    const std::string_view line = sources.Line(file, number);
    const source::Offset begin = text.base + text.line_starts[number - 1];
    lines.push_back({KindOf(line), line, {begin, begin + static_cast<source::Offset>(line.size())}});
  }
  return lines;
}

std::string_view PartName(const Line& mark) {
  return mark.text.substr(mark.kind == LineKind::kPart ? kPartMark.size() : kPartEndMark.size());
}

}  // namespace plcxx::classicladder
