// A range as line and column of its beginning and its end: what all renderers ask first.
#pragma once

#include <string>
#include <string_view>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/source/source.h"

namespace plcxx::diag {

struct Place {
  std::string_view path;
  source::Position begin, end;  // end: one past the last character, in the same file
  size_t byte_offset = 0;       // of the original file
  size_t byte_length = 0;
};

inline bool HasPlace(source::Range range) { return range.begin != 0; }

/// Only for a range that has a place. An end in front of the beginning or in another file counts as the beginning.
Place PlaceOf(const source::SourceManager& sources, source::Range range);

/// "replace 'А' by 'A'", "insert ')'", "delete ';'"
std::string DescriptionOf(const source::SourceManager& sources, const FixIt& fixit);

std::string_view SeverityName(Severity severity);

}  // namespace plcxx::diag
