// The text of one file as the C parser reads it, with a map back to the file (specification 1, 2.1, 2.2, 3.7).
//
// Lines stay lines. Literals hold the bytes of the file's own encoding, two-character constants stand in the order in
// which the parser must see them, line ends are LF, and characters that the language does not have are blanks or, for
// full-width forms, what they stand for. Also: the comments of the file, and what is wrong with its characters.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/dialects/hnc/source/findings.h"
#include "transpiler/dialects/hnc/syntax/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::hnc {

struct SourceText {
  struct Stretch {
    uint32_t at = 0;        // in `text`
    uint32_t original = 0;  // the byte of the file's text that stands there; bytes after it follow one by one
  };

  /// #line: what follows shows as another file, or as other lines.
  struct LineDirective {
    uint32_t at = 0;    // the beginning of the next line, in the file's text
    uint32_t line = 1;  // its number
    std::string name;   // empty: the same file
  };
  struct Moved {
    source::Offset from = 0;  // in the file
    source::Offset to = 0;    // where it shows
  };

  source::FileId file;      // none: a header of the product
  source::Offset base = 0;  // of the file's text
  source::Offset size = 0;  // of the file's text
  std::string name;         // as __FILE__ shows it
  std::string text;
  std::vector<Stretch> map;  // by place; the first is {0, 0}
  std::vector<Comment> comments;
  Findings findings;  // they count only outside groups that are left out
  std::vector<LineDirective> line_directives;
  std::vector<Moved> moved;                   // by place; empty without #line
  std::vector<source::Offset> unsigned_char;  // #pragma option -K: it counts outside groups that are left out

  /// The place in the file for a byte of `text`; 0 in a header of the product.
  source::Offset Original(uint32_t at) const;
  /// Where a place of the file shows.
  source::Offset Shown(source::Offset place) const;
};

/// Makes places after a #line show as it says: as places of a text with that name and those lines (2.7).
void ApplyLineDirectives(source::SourceManager& sources, SourceText& text);

/// A part of a file that is left out, and the comments in it.
struct LeftOutText {
  uint32_t begin = 0, end = 0;  // in the file's text
  std::vector<Comment> comments;
};

SourceText Rewrite(const source::SourceManager& sources, source::FileId file);
/// Without these parts, by place: their line ends stay. Gives no text where one does not begin with a token.
std::optional<SourceText> RewriteWithout(const source::SourceManager& sources, source::FileId file,
                                         std::vector<LeftOutText> parts);
/// A header of the product: nothing to rewrite, no places.
SourceText ProductText(std::string name, std::string text);

}  // namespace plcxx::hnc
