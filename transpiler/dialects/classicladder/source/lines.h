// The lines of a project: marks of its parts, comments, directives and data.
//
// In: the text of a file. Out: each line with what it is by its first characters, as the engine looks at it. Not its
// job: which part takes what (parser.cc).
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "transpiler/source/source.h"

namespace plcxx::classicladder {

constexpr bool IsDigit(char c) { return c >= '0' && c <= '9'; }

enum class LineKind : uint8_t {
  kProject,     // _FILES_CLASSICLADDER
  kProjectEnd,  // _/FILES_CLASSICLADDER
  kPart,        // _FILE-name
  kPartEnd,     // _/FILE-name
  kComment,     // ; ...
  kDirective,   // #NAME=value
  kBlank,
  kData,
};
std::string_view Name(LineKind kind);

struct Line {
  LineKind kind{};
  std::string_view text;
  source::Range range;
};

std::vector<Line> LinesOfProject(const source::SourceManager& sources, source::FileId file);
/// The name that a mark of a part has.
std::string_view PartName(const Line& mark);

}  // namespace plcxx::classicladder
