#include "transpiler/dialects/hnc/syntax/syntax.h"

#include <algorithm>

#include "transpiler/dialects/hnc/syntax/characters.h"

namespace plcxx::hnc {
namespace {

/// The first comment that begins at or after `place`.
std::vector<Comment>::const_iterator FirstFrom(const Unit& unit, source::Offset place) {
  return std::ranges::lower_bound(unit.comments, place, {}, [](const Comment& comment) { return comment.range.begin; });
}

bool OnlyBlanks(std::string_view text) { return std::ranges::all_of(text, IsBlank); }

/// The text from the beginning of the line to `place`.
std::string_view LineBefore(const source::SourceManager& sources, source::Offset place) {
  const source::Position position = sources.Locate(place);
  const source::File& file = sources.Get(position.file);
  const source::Offset start = file.base + file.line_starts[position.line - 1];
  return sources.Text({start, place});
}

bool IsAboutFile(std::string_view text_after) {
  const size_t next = static_cast<size_t>(std::ranges::find_if_not(text_after, IsBlank) - text_after.begin());
  return next == text_after.size() || text_after[next] == '#' ||
         std::ranges::count(text_after.substr(0, next), '\n') > 1;
}

}  // namespace

std::vector<const Comment*> CommentsIn(const Unit& unit, source::Range range) {
  std::vector<const Comment*> found;
  for (auto it = FirstFrom(unit, range.begin); it != unit.comments.end() && it->range.begin < range.end; ++it) {
    found.push_back(&*it);
  }
  return found;
}

std::vector<const Comment*> CommentsBefore(const Unit& unit, const source::SourceManager& sources,
                                           source::Offset place) {
  std::vector<const Comment*> found;
  if (place == 0) return found;
  const source::FileId file = sources.FileAt(place);
  source::Offset next = place;
  for (auto it = FirstFrom(unit, place); it != unit.comments.begin();) {
    --it;
    if (sources.FileAt(it->range.begin) != file || !OnlyBlanks(sources.Text({it->range.end, next}))) break;
    found.push_back(&*it);
    next = it->range.begin;
  }
  std::ranges::reverse(found);
  // The first ones may stand after code of their own line.
  while (!found.empty()) {
    std::string_view before = LineBefore(sources, found.front()->range.begin);
    if (OnlyBlanks(before)) break;
    found.erase(found.begin());
  }
  return found;
}

std::vector<const Comment*> CommentsAtHead(const Unit& unit, const source::SourceManager& sources,
                                           source::FileId file) {
  const source::File& head = sources.Get(file);
  const std::string_view text = head.text;
  std::vector<const Comment*> found;
  source::Offset end = head.base;
  for (auto it = FirstFrom(unit, head.base); it != unit.comments.end(); ++it) {
    if (sources.FileAt(it->range.begin) != file || !OnlyBlanks(sources.Text({end, it->range.begin}))) break;
    found.push_back(&*it);
    end = it->range.end;
  }
  while (!found.empty() && !IsAboutFile(text.substr(found.back()->range.end - head.base))) found.pop_back();
  return found;
}

const Comment* CommentBehind(const Unit& unit, const source::SourceManager& sources, source::Offset place) {
  if (place == 0) return nullptr;
  const auto it = FirstFrom(unit, place);
  if (it == unit.comments.end()) return nullptr;
  const source::Position here = sources.Locate(place);
  const source::Position there = sources.Locate(it->range.begin);
  return here.file == there.file && here.line == there.line ? &*it : nullptr;
}

}  // namespace plcxx::hnc
