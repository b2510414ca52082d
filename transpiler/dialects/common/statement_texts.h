// The source text that stands above a statement in generated code: its lines, and the comments in front of it.
#pragma once

#include <vector>

#include "transpiler/source/source.h"

namespace plcxx::dialects {

/// Whole lines, from the first column on, so that the columns of the source stay as they are; without blanks at the
/// end.
source::Range LinesOf(const source::SourceManager& sources, source::Offset begin, source::Offset end);

/// Adds comments [first, first + count) whose `place` is this one.
template <class Comments, class Place>
void AddComments(const Comments& comments, uint32_t first, uint32_t count, Place place,
                 std::vector<source::Range>& to) {
  for (uint32_t i = 0; i < count; ++i) {
    const auto& comment = comments[first + i];
    if (comment.place == place) to.push_back(comment.range);
  }
}

/// Leaves out what the lines show themselves.
void RemoveCommentsIn(source::Range lines, std::vector<source::Range>& comments);

}  // namespace plcxx::dialects
