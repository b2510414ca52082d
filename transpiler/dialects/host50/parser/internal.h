// The parser's state and its functions, split over parser_*.cc by family. Only those files include it.
//
// First the structure of all files (sections, networks, tables), then directives, symbols and tables, then the
// instructions: a symbol, a label or a subroutine may be used before it is defined. A statement reports one error at
// most; what follows from it is not reported again.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/dialects/host50/machine/addresses.h"
#include "transpiler/dialects/host50/parser/drawing.h"
#include "transpiler/dialects/host50/parser/parser.h"
#include "transpiler/dialects/host50/source/lexer.h"

namespace plcxx::host50 {

/// Where an instruction is written.
enum class Setting : uint8_t { kList, kDrawing };

/// The ASCII character of which this one is the full-width form; '\0' for all others.
char NarrowOf(char32_t point);

class Parser {
 public:
  Parser(const source::SourceManager& sources, const std::map<std::string, std::string>& options,
         diag::Engine& diagnostics)
      : sources_(sources), options_(options), diagnostics_(diagnostics) {}

  Program Run(std::span<const source::FileId> files);

 private:
  // --- statements and messages (parser.cc) ---
  void EnterFile(LexedFile& file);
  /// The cursor at the first token of a statement that may report one error.
  void Begin(const Line& line);
  void Begin(std::span<const Token> tokens, source::Range statement);
  Token Peek(size_t ahead = 0) const;
  Token Take();
  bool At(TokenKind kind) const { return Peek().kind == kind; }
  bool TakeIf(TokenKind kind);
  std::string_view TextOf(source::Range range) const {
    return std::string_view(source_->text).substr(range.begin - source_->base, range.end - range.begin);
  }
  std::string_view TextOf(const Token& token) const { return TextOf(token.range); }
  /// "'%I0'", "the end of the statement".
  std::string Found() const;
  /// Without its quotes, doubled quotes as one.
  std::string StringOf(const Token& token) const;
  std::string_view WordOf(const Line& line) const;

  template <class... Args>
  diag::Diagnostic& Fault(source::Range range, const diag::Message<Args...>& message,
                          std::type_identity_t<Args>... args) {
    program_.faulty = true;
    if (std::exchange(failed_, true)) return unreported_ = {};
    return diagnostics_.Report(range, message, args...);
  }
  template <class... Args>
  diag::Diagnostic& Report(source::Range range, const diag::Message<Args...>& message,
                           std::type_identity_t<Args>... args) {
    program_.faulty = true;
    return diagnostics_.Report(range, message, args...);
  }
  /// E111 when the cursor is at a bad token.
  bool FaultOfBadToken();
  void FaultOfBadCharacter(const Token& token);
  void FaultOfUnknownInstruction(const Token& token);
  /// E102: `what` is missing, or E111.
  void FaultOfMissing(std::string_view what);
  /// E102 when something is left of the statement.
  void ExpectEnd();
  void ReportUndefinedBytes();

  // --- structure (structure.cc) ---
  struct Body {  // of a network
    NetworkId network;
    uint32_t file = 0;
    uint32_t first = 0, last = 0;  // lines [first, last)
  };
  struct Table {
    PartKind part{};
    uint32_t file = 0;
    uint32_t first = 0, last = 0;
  };
  struct Place {
    uint32_t file = 0, line = 0;
  };
  void ReadStructure();
  void ReadTopLevelLine(uint32_t file);
  void ReadTable(PartKind part, uint32_t file);
  void ReadSection(PartKind part, uint32_t file);
  void ReadStray(uint32_t file);
  SectionId OpenSection(PartKind part);
  void CheckSection(SectionId id);
  void OpenNetwork(SectionId section, uint32_t file);
  void OpenStrayNetwork(SectionId section, uint32_t file);
  void ReadNetworkHead(Network& network);
  void CheckNetwork(SectionId section, NetworkId id);
  void TakeBodyLine(SectionId section, uint32_t file);
  void CloseLadder();
  void CloseBody();
  /// At an END word that does not close `part`: E312. True when it is taken for the one that is missing.
  bool ReadWrongEnd(PartKind part);
  bool EndsLater(PartKind part);
  void ReadEnd();
  bool IsDirective(std::string_view word) const;
  void ReportDirectiveInside(PartKind part);
  Span TakeComments(const Line& line);
  Line& CurrentLine() { return files_[file_].lines[line_]; }

  // --- directives and tables (tables.cc) ---
  void ReadDirectives();
  void ReadDirective(const Line& line);
  void ReadNumberDirective(std::string_view word);
  void ReadOption();
  void ReadTables();
  void ReadTitleRow(const Line& line);
  void ReadAlarmRow(const Line& line);
  void ReadMCodeRow(const Line& line);
  std::string ReadLastString(std::string_view what);

  // --- symbols and addresses (symbols.cc) ---
  struct Resolved {
    bool ok = false;
    Address address;
    SymbolId symbol;
  };
  void ReadSymbolRow(const Line& line);
  void AddPredefinedSymbols();
  SymbolId SymbolNamed(std::string_view name);
  /// An address or symbol at the cursor, which moves after it.
  Resolved ReadAddress();
  Resolved ResolveAddress(const Token& token);
  void FaultOfAddressNumber(const Token& token);
  std::string SymbolWithSign(const Token& token);
  bool IsAddressWithoutSign(std::string_view name) const;
  Resolved ResolveName(const Token& token, std::string_view name, std::string_view attribute);
  std::string RangesText(Area area) const;

  // --- instructions (instructions.cc) ---
  void ReadBodies();
  void ReadBody(const Body& body);
  void ReadInstruction(const Line& line, NetworkId network, std::vector<source::Range>& comments);
  /// The mnemonic at the cursor and what follows it.
  void ReadStatement(Instruction& instruction);
  void ReadOperands(Instruction& instruction, Setting setting);
  void ReadPins(Instruction& instruction, Setting setting);
  void ReadPin(const Instruction& instruction, std::vector<Pin>& pins);
  bool UnitIsNamed(const Instruction& instruction) const;
  void SettleConstants(Instruction& instruction);
  void CheckTimer(const Instruction& instruction);
  Span AddComments(std::vector<source::Range>& above, source::Range row);
  /// Where the text of an instruction's mnemonic or, in a drawing, its name in the table is.
  std::string_view MnemonicOf(const Instruction& instruction, Setting setting) const;

  // --- operands (operands.cc) ---
  Operand ReadOperand(OperandRole role);
  void ReadBit(Operand& operand);
  void ReadCoil(Operand& operand);
  void ReadNumber(Operand& operand);
  void ReadResult(Operand& operand);
  void ReadField(Operand& operand);
  void ReadBitCount(Operand& operand);
  void ReadInstance(Operand& operand);
  void ReadSubroutine(Operand& operand);
  void ReadJumpTarget(Operand& operand);
  void ReadUnit(Instruction& instruction);
  void ReadText(Operand& operand);
  void SetInteger(Operand& operand, const Token& token);
  void SetFloat(Operand& operand, const Token& token);
  void CheckAxisNumber(const Operand& operand);
  /// The address at the cursor; false when there is none or a fault was reported.
  bool ReadPlace(Operand& operand, std::string_view what);
  void FaultOfType(Type wanted, source::Range range, std::string_view found);
  bool AtNumber() const { return At(TokenKind::kInteger) || At(TokenKind::kHex) || At(TokenKind::kFloat); }

  // --- expressions (expressions.cc) ---
  enum class ExpressionOf : uint8_t { kComparison, kAssignment };
  Operand ReadComparison();
  void ReadAssignment(std::vector<Operand>& operands);
  ExprId ReadOr();
  ExprId ReadAnd();
  ExprId ReadSum();
  ExprId ReadProduct();
  ExprId ReadUnary();
  ExprId ReadPrimary();
  ExprId ReadParenthesis();
  ExprId ReadSignedConstant(const Token& sign);
  ExprId AddBinary(ExprKind kind, ExprId left, ExprId right, const Token& op);
  ExprId AddConstant(const Token& token, source::Range range, bool negative);
  ExprId ErrorExpr(source::Range range);
  void FaultOfExpression(std::string_view what);
  std::string_view MeantInExpression() const;
  void CloseExpression(bool quoted);
  bool AtExpressionEnd() const { return At(TokenKind::kEnd) || At(TokenKind::kQuote); }

  // --- drawings (drawings.cc) ---
  /// The rows from line `first` on; gives the line after the last one.
  uint32_t ReadDrawing(const Body& body, uint32_t first, std::vector<source::Range>& comments);
  void ReadElement(const DrawnElement& element, Instruction& instruction);
  void ReadContactOrCoil(const DrawnElement& element, Instruction& instruction);
  void ReadDrawnBlock(Instruction& instruction);
  void AddRowComments(const Drawing& drawing, const std::vector<std::vector<source::Range>>& above,
                      std::vector<Instruction>& instructions);
  void AddElements(const std::optional<Wiring>& wiring, const std::vector<Instruction>& instructions);

  const source::SourceManager& sources_;
  const std::map<std::string, std::string>& options_;
  diag::Engine& diagnostics_;
  Program program_;
  std::vector<LexedFile> files_;

  // The statement that is read.
  const source::File* source_ = nullptr;
  std::span<const Token> tokens_;
  source::Range statement_;
  size_t position_ = 0;
  bool failed_ = false;
  diag::Diagnostic unreported_;

  // Structure.
  uint32_t file_ = 0, line_ = 0;
  /// From each line in [from, line) of the file the first line that begins a part or ends this one is `line`.
  struct Ahead {
    uint32_t file = 0;
    PartKind part = PartKind::kTitle;
    uint32_t from = 0, line = 0;
    bool ends = false;  // it ends this one
  };
  Ahead ahead_;
  std::vector<Body> bodies_;
  std::vector<Table> tables_;
  std::vector<Place> directives_;
  std::vector<source::Range> comments_;        // above the next part
  std::optional<source::Range> open_ladder_;   // its opening line
  std::map<uint32_t, SectionId> subroutines_;  // by number
  std::map<std::pair<SectionId, uint32_t>, NetworkId> labels_;
  uint32_t program_count_ = 0, network_count_ = 0;
  bool programs_reported_ = false, networks_reported_ = false;

  // Tables.
  std::set<std::string, std::less<>> given_directives_;  // in capitals
  std::map<std::string, SymbolId, std::less<>> names_;
  std::set<std::string, std::less<>> poisoned_names_;  // defined with a fault
  std::set<std::pair<Area, uint16_t>> named_addresses_;
  std::set<uint32_t> alarms_, mcodes_;
  std::set<TitleKey> title_keys_;

  // Instructions.
  struct TimerUse {
    Op op{};
    TimerUnit unit{};
    source::Range range;
  };
  std::map<uint16_t, TimerUse> timers_;
  SectionId section_;
  std::vector<Token> number_tokens_;  // of the operands of the statement; kEnd where it is no number
  ExpressionOf expression_of_ = ExpressionOf::kComparison;
  uint32_t parentheses_ = 0, expression_operands_ = 0;
};

}  // namespace plcxx::host50
