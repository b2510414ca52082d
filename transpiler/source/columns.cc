#include "transpiler/source/columns.h"

#include <utility>

#include "transpiler/source/characters.h"

namespace plcxx::source {
namespace {

size_t MissingColumns(std::string_view text, size_t width) {
  const size_t columns = ColumnsOf(text);
  return width > columns ? width - columns : 0;
}

}  // namespace

size_t ColumnsOf(std::string_view text) {
  size_t columns = 0;
  while (!text.empty()) {
    const CodePoint point = FirstCodePoint(text);
    columns += DisplayWidth(point.value);
    text.remove_prefix(point.length);
  }
  return columns;
}

std::string RightAligned(std::string text, size_t width) {
  text.insert(0, MissingColumns(text, width), ' ');
  return text;
}

std::string LeftAligned(std::string text, size_t width) {
  text.append(MissingColumns(text, width), ' ');
  return text;
}

}  // namespace plcxx::source
