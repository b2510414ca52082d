// What all parts of the parser share: the program that is made, where in the files they are, and the instruction that
// waits for its operand lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/prostep/parser/brackets.h"
#include "transpiler/dialects/prostep/parser/parser.h"
#include "transpiler/dialects/prostep/source/lexer.h"
#include "transpiler/dialects/prostep/source/numbers.h"

namespace plcxx::prostep {

/// The tokens of a line with a colon.
struct Statement {
  std::vector<Token> labels;
  std::vector<Token> tokens;  // after the colon, without the comment
  Token comment;              // range empty: none
  source::Range range;        // of `tokens`
  bool has_comment() const { return comment.range.end > comment.range.begin; }
};

/// The instruction whose operand lines are being read.
struct Waiting {
  InstructionId instruction;
  uint32_t fewest = 0, most = 0, found = 0;
  bool reported = false;  // it lacks operand lines, or its operands are unknown: nothing more is said
  bool surplus = false;   // an operand line too much is reported, and those behind it with it
  std::vector<source::Range> operand_like{};  // comments that are what it lacks, where it lacks operand lines
};

/// Where the parser is.
struct Reading {
  source::FileId file;
  ModuleId module;  // open; not valid: outside
  bool seen_module = false;
  bool meant_end = false;  // the end of a block in STEP 5 is reported: the module may end there
  Waiting waiting{};
};

/// Files on their way to a program.
struct Parsing {
  const source::SourceManager& sources;
  diag::Engine& diagnostics;
  Program program{};
  Reading now{};
};

/// What a part of the parser sees. Refers to the parsing.
class LineReader {
 public:
  explicit LineReader(Parsing& parsing)
      : sources_(parsing.sources), diagnostics_(parsing.diagnostics), program_(parsing.program), now_(parsing.now) {}

 protected:
  std::string_view TextOf(const Token& token) const { return sources_.Text(token.range); }
  std::string UpperOf(const Token& token) const { return Upper(TextOf(token)); }
  /// Something of it is faulty, which the lexer has reported.
  bool IsReported(const Statement& statement) const;

  const source::SourceManager& sources_;
  diag::Engine& diagnostics_;
  Program& program_;
  Reading& now_;
};

}  // namespace plcxx::prostep
