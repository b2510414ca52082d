// The lexer of dialect host50 (specification 2): a file to lines, each with its tokens and its comment.
//
// A line is a statement with its continuations. What a word means is decided by its place, so the first word of a line
// chooses how the rest is read: operands, an expression (COMP, OPRT), the text of a REMARK; and from LADDER on lines
// are rows of a drawing. Nothing is reported here: a character without a meaning is a token of its own, so that a
// statement's first fault from the left is the one that is reported. Not its job: rows of drawings (drawing.h).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "transpiler/dialects/host50/source/tokens.h"
#include "transpiler/dialects/host50/syntax/syntax.h"
#include "transpiler/source/source.h"

namespace plcxx::host50 {

enum class LineKind : uint8_t { kBlank, kComment, kStatement, kRow };

struct Line {
  LineKind kind = LineKind::kBlank;
  Span tokens;
  source::Range range;        // first to last token; of a row the whole line; empty for the others
  source::Range comment;      // from ';' on, blanks at the end removed; empty where there is none (rows: always)
  Continuation continuation;  // empty where the statement has one physical line
  // For the parser:
  bool consumed = false;  // it has dealt with the whole line
  bool faulty = false;    // an error was reported for it: its instruction reports none
};

struct LexedFile {
  source::FileId file;
  std::vector<Line> lines;  // statements with continuations are one line
  std::vector<Token> tokens;
};

LexedFile Lex(const source::SourceManager& sources, source::FileId file);

/// A part of a row: what stands between the brackets of an element. A block has its mnemonic first and chooses the
/// reading by it.
enum class ElementKind : uint8_t { kContactOrCoil, kBlock };
std::vector<Token> LexElement(const source::File& file, source::Range range, ElementKind kind);

/// The word at the start of a line, "END_LADDER"; empty when it begins with something else.
std::string_view FirstWord(std::string_view line);

/// The parts of a source and their END words: "TITLE", ... , "LADDER".
enum class PartKind : uint8_t { kTitle, kSymbols, kAlarms, kMCodes, kFast, kSlow, kSub, kLadder };
std::string_view Name(PartKind part);
/// By its opening word.
std::optional<PartKind> PartByName(std::string_view word);
/// By its END word.
std::optional<PartKind> PartByEnd(std::string_view word);

}  // namespace plcxx::host50
