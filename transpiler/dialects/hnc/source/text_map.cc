// The way back from a rewritten text: what the parser's module needs of source_text.h, and nothing more.
#include <algorithm>
#include <iterator>

#include "transpiler/dialects/hnc/source/source_text.h"

namespace plcxx::hnc {

source::Offset SourceText::Original(uint32_t at) const {
  if (!file.valid()) return 0;
  const auto next = std::ranges::upper_bound(map, at, {}, &Stretch::at);
  const Stretch& stretch = *std::prev(next);
  uint32_t original = stretch.original + (at - stretch.at);
  // Within something that was rewritten: no further than what stands after it.
  if (next != map.end()) original = std::min(original, next->original);
  return Shown(base + std::min(original, size));
}

source::Offset SourceText::Shown(source::Offset place) const {
  const auto next = std::ranges::upper_bound(moved, place, {}, &Moved::from);
  return next == moved.begin() ? place : std::prev(next)->to + (place - std::prev(next)->from);
}

}  // namespace plcxx::hnc
