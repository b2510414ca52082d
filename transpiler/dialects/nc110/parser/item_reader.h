// What all parts of the parser share: the program that is made, the file and the item that are read, and messages.
//
// Two kinds of faults: a soft one (wrong type, number out of range, unknown name) leaves a poisoned node and
// parsing goes on; a hard one (a token is missing) sets `panic`, every function returns, and the item is left at
// the next token that can begin an item. Either way an item reports one error at most.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "transpiler/dialects/common/fault_reporter.h"
#include "transpiler/dialects/nc110/parser/parser.h"
#include "transpiler/dialects/nc110/source/lexer.h"

namespace plcxx::nc110 {

/// Where the parser is.
struct Reading {
  // The file.
  LexedFile lexed{};
  const source::File* file = nullptr;
  size_t position = 0;  // of the cursor in its tokens
  size_t next_comment = 0;
  bool case_warned = false;
  bool constant_warned = false;

  // The item.
  bool failed = false;
  bool panic = false;
  uint32_t open_brackets = 0;
  uint32_t parentheses = 0;
  uint32_t operands = 0;
  std::string_view primary_name = "expression";  // what to call a missing operand: a condition in block heads
  bool in_condition = false;
  bool extension_warned = false;
};

/// Files on their way to a program.
struct Parsing {
  const source::SourceManager& sources;
  const ParseOptions& options;
  diag::Engine& diagnostics;
  Program program{};
  Reading now{};
};

/// Words of a message about what was found: "'U4A0'".
std::string Quoted(std::string_view text);

/// What a part of the parser sees. Refers to the parsing.
class ItemReader : protected dialects::FaultReporter {
 public:
  explicit ItemReader(Parsing& parsing)
      : FaultReporter(parsing.diagnostics, parsing.now.failed),
        sources_(parsing.sources),
        options_(parsing.options),
        program_(parsing.program),
        now_(parsing.now) {}

 protected:
  const Token& Peek(size_t ahead = 0) const {
    const size_t at = now_.position + ahead;
    return at < now_.lexed.tokens.size() ? now_.lexed.tokens[at] : now_.lexed.tokens.back();
  }
  bool At(TokenKind kind) const { return Peek().kind == kind; }
  bool AtOperand() const { return At(TokenKind::kOperand) || At(TokenKind::kSymbol) || At(TokenKind::kRun); }
  bool AtItemStart() const;
  /// Is the token at `ahead` an operand (or may it be one) in front of '=' or '('?
  bool LooksLikeTarget(size_t ahead) const;
  const Token& Take();
  bool TakeIf(TokenKind kind);
  /// Takes `kind` or reports it missing.
  bool Require(TokenKind kind, std::string_view what);
  /// False: they are too deep, which is reported.
  bool EnterParenthesis(source::Range range);

  std::string_view TextOf(const Token& token) const;
  std::string_view Plain(source::Range range) const { return sources_.Text(range); }
  /// "'U4A0'", "the end of the line".
  std::string Found() const;
  /// Where something is missing: the token in its place, or the end of the line when the line ends there.
  source::Range MissingAt() const;
  source::Range BehindPrevious() const;

  template <class... Args>
  ExprId HardFault(source::Range range, const diag::Message<Args...>& message, std::type_identity_t<Args>... args) {
    Fault(range, message, args...);
    now_.panic = true;
    return ErrorExpr(range);
  }
  ExprId Expected(std::string_view what);
  /// A keyword or operand that is used as such: W305 or, with strict case, error 1.
  void CheckCase(const Token& token);
  ExprId ErrorExpr(source::Range range);

  const source::SourceManager& sources_;
  const ParseOptions& options_;
  Program& program_;
  Reading& now_;
};

}  // namespace plcxx::nc110
