// The parser's state and its functions, split over parser_*.cc by family. Only those files include it.
//
// Two kinds of faults: a soft one (wrong type, number out of range, unknown name) leaves a poisoned node and
// parsing goes on; a hard one (a token is missing) sets panic_, every function returns, and the item is left at
// the next token that can begin an item. Either way an item reports one error at most.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transpiler/dialects/nc110/parser/parser.h"
#include "transpiler/dialects/nc110/source/lexer.h"

namespace plcxx::nc110 {

class Parser {
 public:
  Parser(const source::SourceManager& sources, const ParseOptions& options, diag::Engine& diagnostics)
      : sources_(sources), options_(options), diagnostics_(diagnostics) {}

  Program Run(std::span<const source::FileId> files);

 private:
  // --- tokens and messages (parser.cc) ---
  const Token& Peek(size_t ahead = 0) const {
    const size_t at = position_ + ahead;
    return at < lexed_.tokens.size() ? lexed_.tokens[at] : lexed_.tokens.back();
  }
  bool At(TokenKind kind) const { return Peek().kind == kind; }
  const Token& Take();
  bool TakeIf(TokenKind kind);
  std::string_view TextOf(const Token& token) const;
  /// "'U4A0'", "the end of the line".
  std::string Found() const;
  /// Where something is missing: the token in its place, or the end of the line when the line ends there.
  source::Range MissingAt() const;
  source::Range BehindPrevious() const;
  /// A keyword or operand that is used as such: W305 or, with strict case, error 1.
  void CheckCase(const Token& token);

  template <class... Args>
  diag::Diagnostic& Fault(source::Range range, const diag::Message<Args...>& message,
                          std::type_identity_t<Args>... args) {
    if (std::exchange(failed_, true)) {
      return unreported_ = {};
    }
    return diagnostics_.Report(range, message, args...);
  }
  template <class... Args>
  ExprId HardFault(source::Range range, const diag::Message<Args...>& message, std::type_identity_t<Args>... args) {
    Fault(range, message, args...);
    panic_ = true;
    return ErrorExpr(range);
  }
  template <class... Args>
  void Warn(source::Range range, const diag::Message<Args...>& message, std::type_identity_t<Args>... args) {
    if (!failed_) {
      diagnostics_.Report(range, message, args...);
    }
  }
  ExprId Expected(std::string_view what);
  /// Takes `kind` or reports it missing.
  bool Require(TokenKind kind, std::string_view what);

  // --- files and items (parser.cc) ---
  void ParseLogicFile(source::FileId file);
  void ParseItem();
  void ParseCycleMark(Item& item);
  void ParseMessage(Item& item);
  void ReportNoStatement();
  bool AtItemStart() const;
  /// Is the token at `ahead` an operand (or may it be one) in front of '=' or '('?
  bool LooksLikeTarget(size_t ahead) const;
  void SkipToNextItem(size_t item_begin);
  void AttachComments(Item& item, source::Offset next_token);
  void SplitOffHeader(SourceFile& file);
  void ReportProgramWarnings();

  // --- symbol files (symbols.cc) ---
  void ParseSymbolFile(source::FileId file);
  void ParseSymbolLine(std::string_view line, source::Offset begin, HomoglyphReader& homoglyphs);
  void DefineSymbol(Symbol symbol);
  SymbolId FindSymbol(std::string_view name) const;

  // --- operands (operands.cc) ---
  /// kOperand, kSymbol or kRun.
  OperandUse TakeOperand();
  void FaultOfUnknown(std::string_view run, source::Range range);
  bool IsMeantEnd(std::string_view run, source::Range range);
  Operand ReadOperand(std::string_view run, source::Range range);
  struct ConstantUse {
    uint32_t value = 0;
    bool well_formed = false;
    source::Range range;
    std::string_view text;
  };
  ConstantUse TakeConstant();
  void ReportMalformedNumber(const Token& token);
  void CountOperand();
  bool AtOperand() const { return At(TokenKind::kOperand) || At(TokenKind::kSymbol) || At(TokenKind::kRun); }

  // --- expressions (expressions.cc, words.cc) ---
  ExprId ErrorExpr(source::Range range);
  ExprId OperandExpr(const OperandUse& use);
  ExprId Unary(ExprKind kind, Type type, source::Range range, ExprId left);
  ExprId Binary(ExprKind kind, Type type, ExprId left, ExprId right);
  ExprId ParseExpression(Type type);
  ExprId ParseAnd(Type type);
  ExprId ParseNot(Type type);
  ExprId ParsePrimary(Type type);
  ExprId ParseGroup(Type type);
  ExprId ParseOperand(Type type);
  ExprId ParseConstant(Type type);
  void WarnOrOfNumber(source::Range sign, ExprId left, ExprId right);
  void WarnConstantSignal(source::Range range);
  ExprId ParseAscii(Type type);
  ExprId ParseUnknownPrimary();
  ExprId ParseFunction(Type type);
  ExprId ParseWordFunction();
  ExprId ParseSgn();
  ExprId ParseBracket();
  ExprId ParseSum();
  ExprId ParseTerm();
  ExprId ParseComparator();
  ExprId DoubledSign(ExprId left, TokenKind first);
  ExprId ParseComparatorArgument();
  void CheckComparison(ExprId comparison);
  bool EnterParenthesis(source::Range range);

  // --- assignments (assignments.cc, mux.cc) ---
  void ParseAssignment(Item& item);
  bool ParseTarget(Assignment& assignment);
  void ParseParameter(Assignment& assignment, std::string_view target_text);
  ExprId ParseParameterConstant(OperandKind target);
  ExprId ParseParameterWord();
  void ReportParameterMissing(OperandKind target, std::string_view target_text);
  MuxId ParseMux(Type target_type, source::Range target);
  bool ParseMuxList(Type type, std::vector<ExprId>& list);
  void CheckMuxInput(Type type, ExprId input);

  // --- blocks (blocks.cc) ---
  void ParseBlockHead(Item& item);
  /// Is nothing on the rest of the line that could be the condition?
  bool NoConditionHere() const;
  void LinkChain(BlockId id, Block& block);
  void ParseBlockEnd(Item& item);
  source::Range TakeBlockName();
  void CloseBlock(BlockEnd& end, const Token& word);
  void ReportOpenBlocksAtMark(source::Range mark);
  void ReportOpenBlocksAtEnd();
  bool SameName(source::Range a, source::Range b) const;
  std::string_view BlockName(source::Range range) const;
  void ParseCondition(Block& block, source::Range colon);
  void CheckEndName(const BlockEnd& end);
  std::string_view Plain(source::Range range) const { return sources_.Text(range); }

  const source::SourceManager& sources_;
  const ParseOptions& options_;
  diag::Engine& diagnostics_;
  diag::Diagnostic unreported_;
  Program program_;

  // The file being read.
  LexedFile lexed_;
  const source::File* file_ = nullptr;
  size_t position_ = 0;
  size_t next_comment_ = 0;
  bool case_warned_ = false;
  bool constant_warned_ = false;

  // The item being read.
  bool failed_ = false;
  bool panic_ = false;
  uint32_t open_brackets_ = 0;
  uint32_t parentheses_ = 0;
  uint32_t operands_ = 0;
  std::string_view primary_name_ = "expression";  // what to call a missing operand: a condition in block heads
  bool in_condition_ = false;
  bool extension_warned_ = false;

  // The program so far.
  struct OpenBlock {
    BlockId block;
    bool reported = false;   // its missing end, too deep nesting
    source::Range lone_end;  // an END without its letter, or ENDIF, which was meant to close it
    bool continued = false;  // W304 given
  };
  std::vector<OpenBlock> open_blocks_;
  BlockId chain_;                                         // the member that a DOE right here would follow
  bool chain_unsure_ = false;                             // the item before was faulty: no error 45
  std::map<std::string, SymbolId, std::less<>> symbols_;  // by the first 10 characters
  std::set<std::string, std::less<>> undefined_;          // already reported
  std::map<source::Offset, std::string> mapped_names_;    // of blocks, where look-alike letters were replaced
  std::unordered_map<std::string_view, LiteralId> literals_;
  std::vector<MessageId> messages_by_number_ = std::vector<MessageId>(256);
  bool table_full_reported_ = false;
  bool logic_file_seen_ = false;
};

/// Words of a message about what was found: "'U4A0'".
std::string Quoted(std::string_view text);

}  // namespace plcxx::nc110
