// What all parts of the parser share: the program that is made, the statement that is read, and messages about it.
//
// First the structure of all files (StructureReader), then directives, symbols and tables, then the instructions: a
// symbol, a label or a subroutine may be used before it is defined. A statement reports one error at most; what follows
// from it is not reported again.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/common/fault_reporter.h"
#include "transpiler/dialects/host50/parser/parser.h"
#include "transpiler/dialects/host50/source/lexer.h"

namespace plcxx::host50 {

/// The statement that is read, and where it is.
struct Statement {
  uint32_t file = 0;
  const source::File* source = nullptr;  // of that file
  SectionId section;
  std::span<const Token> tokens;
  source::Range range;
  size_t position = 0;  // of the cursor in the tokens
  bool failed = false;  // its error is reported
};

/// Files on their way to a program.
struct Parsing {
  const source::SourceManager& sources;
  diag::Engine& diagnostics;
  Program program{};
  std::vector<LexedFile> files{};
  Statement now{};
};

/// The ASCII character of which this one is the full-width form; '\0' for all others.
char NarrowOf(char32_t point);
/// With narrow characters in the place of full-width ones.
std::string Narrowed(std::string_view text);

/// What a part of the parser sees. Refers to the parsing.
class StatementReader : protected dialects::FaultReporter {
 public:
  explicit StatementReader(Parsing& parsing)
      : FaultReporter(parsing.diagnostics, parsing.now.failed, &parsing.program.faulty),
        sources_(parsing.sources),
        program_(parsing.program),
        files_(parsing.files),
        now_(parsing.now) {}

 protected:
  void EnterFile(uint32_t file);
  /// The cursor at the first token of a statement that may report one error.
  void Begin(const Line& line);
  void Begin(std::span<const Token> tokens, source::Range statement);
  Token Peek(size_t ahead = 0) const;
  Token Take();
  bool At(TokenKind kind) const { return Peek().kind == kind; }
  bool AtNumber() const { return At(TokenKind::kInteger) || At(TokenKind::kHex) || At(TokenKind::kFloat); }
  bool TakeIf(TokenKind kind);
  std::string_view TextOf(source::Range range) const {
    return std::string_view(now_.source->text).substr(range.begin - now_.source->base, range.end - range.begin);
  }
  std::string_view TextOf(const Token& token) const { return TextOf(token.range); }
  /// "'%I0'", "the end of the statement".
  std::string Found() const;
  /// Without its quotes, doubled quotes as one.
  std::string StringOf(const Token& token) const;
  std::string_view WordOf(const Line& line) const;
  /// The comments above a row and its own, to the program.
  Span AddComments(std::vector<source::Range>& above, source::Range row);

  /// E111 when the cursor is at a bad token.
  bool FaultOfBadToken();
  /// E102: `what` is missing, or E111.
  void FaultOfMissing(std::string_view what);
  /// E102 when something is left of the statement.
  void ExpectEnd();

  const source::SourceManager& sources_;
  Program& program_;
  std::vector<LexedFile>& files_;
  Statement& now_;

 private:
  void FaultOfBadCharacter(const Token& token);
};

}  // namespace plcxx::host50
