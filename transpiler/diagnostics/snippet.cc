#include "transpiler/diagnostics/snippet.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "transpiler/diagnostics/terminal_text.h"

namespace plcxx::diag {
namespace {

constexpr std::string_view kEllipsis = "...";

bool IsContinuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// The part of a line that can be seen at all, so that a very long line costs no more than a short one.
struct Neighbourhood {
  std::string_view text;
  bool begins_later = false;
  bool ends_earlier = false;
};

/// `begin` is the marked byte of `line` and is moved with it.
Neighbourhood Around(std::string_view line, size_t& begin, uint32_t width) {
  // Four bytes are the longest character; marks that take no column may need more, and are cropped then.
  const size_t reach = size_t{width} * 4;
  size_t first = begin > reach ? begin - reach : 0;
  size_t last = std::min(line.size(), begin + reach);
  while (first > 0 && IsContinuation(line[first])) --first;
  while (last < line.size() && IsContinuation(line[last])) ++last;
  begin -= first;
  return {line.substr(first, last - first), first > 0, last < line.size()};
}

uint32_t WidthOf(const std::vector<Cell>& cells, size_t first, size_t last) {
  uint32_t width = 0;
  for (size_t i = first; i < last; ++i) width += cells[i].width;
  return width;
}

/// The index of the cell that holds byte `at`; one past the last for the end of the line.
size_t CellAt(const std::vector<Cell>& cells, size_t at, size_t text_size) {
  if (at >= text_size) return cells.size();
  const auto next = std::ranges::upper_bound(cells, at, {}, &Cell::begin);
  return static_cast<size_t>(next - cells.begin()) - 1;
}

}  // namespace

Snippet SnippetOf(const source::SourceManager& sources, source::Range range, uint32_t width) {
  const source::Position place = sources.Locate(range.begin);
  const source::File& file = sources.Get(place.file);
  const std::string_view whole_line = sources.Line(place.file, place.line);
  // A place inside CR LF, or after the end of the line, is shown just after the line.
  size_t begin = std::min<size_t>(range.begin - file.base - file.line_starts[place.line - 1], whole_line.size());
  const size_t length = range.end > range.begin ? range.end - range.begin : 0;

  const Neighbourhood near = Around(whole_line, begin, width);
  const std::vector<Cell> cells = CellsOf(near.text);
  const size_t first_marked = CellAt(cells, begin, near.text.size());
  size_t last_marked = first_marked;
  while (last_marked < cells.size() && cells[last_marked].begin < begin + length) ++last_marked;

  // What fits: a third of the width in front of the mark, or more where the line ends early.
  size_t first = 0;
  size_t last = cells.size();
  const uint32_t room = width - std::min(width, 2 * static_cast<uint32_t>(kEllipsis.size()));
  if (near.begins_later || near.ends_earlier || WidthOf(cells, first, last) > width) {
    uint32_t before_mark = WidthOf(cells, 0, first_marked);
    uint32_t rest = WidthOf(cells, 0, cells.size());
    while (before_mark > room / 3 && (near.ends_earlier || rest > room)) {
      before_mark -= cells[first].width;
      rest -= cells[first].width;
      ++first;
    }
    uint32_t used = 0;
    for (last = first; last < cells.size() && used + cells[last].width <= room; ++last) used += cells[last].width;
  }

  Snippet snippet;
  if (first > 0 || near.begins_later) snippet.line = kEllipsis;
  snippet.marker.assign(snippet.line.size() + WidthOf(cells, first, first_marked), ' ');
  for (size_t i = first; i < last; ++i) snippet.line += cells[i].text;
  if (last < cells.size() || near.ends_earlier) snippet.line += kEllipsis;
  snippet.marker += '^';
  const uint32_t marked = WidthOf(cells, first_marked, std::max(first_marked, std::min(last, last_marked)));
  if (marked > 1) snippet.marker.append(marked - 1, '~');
  return snippet;
}

}  // namespace plcxx::diag
