// One source line with a caret below it, cropped to the width of the terminal.
#pragma once

#include <string>

#include "transpiler/source/source.h"

namespace plcxx::diag {

struct Snippet {
  std::string line;    // without line number
  std::string marker;  // blanks, then "^~~~" below what the range covers in the line
};

/// `range` has a place; what it covers after its first line is not marked.
Snippet SnippetOf(const source::SourceManager& sources, source::Range range, uint32_t width);

}  // namespace plcxx::diag
