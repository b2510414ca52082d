#include "transpiler/dialects/common/statement_texts.h"

namespace plcxx::dialects {

source::Range LinesOf(const source::SourceManager& sources, source::Offset begin, source::Offset end) {
  const source::Position first = sources.Locate(begin), last = sources.Locate(end);
  const source::File& file = sources.Get(first.file);
  const auto start = [&file](uint32_t line) { return file.base + file.line_starts[line - 1]; };
  std::string_view text = sources.Line(last.file, last.line);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return {start(first.line), start(last.line) + static_cast<source::Offset>(text.size())};
}

void RemoveCommentsIn(source::Range lines, std::vector<source::Range>& comments) {
  std::erase_if(comments,
                [&](const source::Range& comment) { return comment.begin >= lines.begin && comment.end <= lines.end; });
}

}  // namespace plcxx::dialects
