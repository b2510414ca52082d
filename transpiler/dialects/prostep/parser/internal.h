// The parser of dialect prostep by families of lines. Shared by its files only.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/prostep/parser/brackets.h"
#include "transpiler/dialects/prostep/parser/parser.h"
#include "transpiler/dialects/prostep/source/lexer.h"
#include "transpiler/dialects/prostep/source/numbers.h"

namespace plcxx::prostep {

class Parser {
 public:
  Parser(const source::SourceManager& sources, diag::Engine& diagnostics)
      : sources_(sources), diagnostics_(diagnostics), brackets_(diagnostics) {}

  void TakeFile(source::FileId file);
  Program Finish();

 private:
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
  };

  struct PendingJump {
    InstructionId instruction;
    std::string name;
    source::Range range;
  };

  // parser.cc
  void TakeLine(const LexedFile& lexed, const Line& line);
  void TakeStatement(const LexedFile& lexed, const Line& line);
  Statement Split(const LexedFile& lexed, const Line& line) const;
  void EmptyStatement(const Statement& statement);
  void ReportOutside(const Statement& statement);
  bool IsReported(const Statement& statement) const;

  // comments.cc
  void AddComment(source::Range range, CommentPlace place);
  /// What has not been attached yet.
  Span TakeComments();
  void AttachTrailing(Span& comments, const Token& comment);
  void AttachInside(Instruction& instruction, const Token& comment);
  void AttachHeader(SourceFile& file);

  // modules.cc
  void OpenModule(const Statement& statement);
  void CloseModule(const Statement& statement);
  /// The number after MOD or END; none when it is wrong (reported).
  std::optional<uint32_t> ModuleNumber(const Statement& statement);
  std::optional<uint32_t> ClosedNumber(const Statement& statement);
  void LeaveModule(source::Range close);
  void ResolveJumps(const Module& module);
  void EndOfFile();

  // labels.cc
  /// The word before the colon; none when there is none or it is none (reported).
  const Token* TheLabel(const Statement& statement);
  void DefineLabel(const Token& token);
  /// Reports what is wrong with it as a label of a line or as the target of a jump.
  bool IsLabel(std::string_view name, source::Range range);

  // instructions.cc
  void TakeInstruction(const Statement& statement);
  void UnknownInstruction(const Statement& statement, Instruction& instruction);
  void KnownInstruction(const Statement& statement, Instruction& instruction);
  void WithoutOperand(std::string_view mnemonic, Instruction& instruction);
  void WithOperand(const Statement& statement, std::string_view mnemonic, Instruction& instruction);
  void WithTarget(const Token& target, std::string_view mnemonic, Instruction& instruction);
  void Attach(Instruction& instruction);
  void CallFunction(Instruction& instruction);
  void WarnOfComment(const Statement& statement, bool without_operand);

  // operand_lines.cc
  void TakeOperandLine(const Statement& statement);
  void TakeNextOperand(const Statement& statement, Instruction& instruction);
  void TakeArgument(const Statement& statement, Instruction& instruction, Function function);
  void CheckArgument(Operand& operand, const ShapeInfo& shape, std::string_view call);
  void CheckField(const Operand& operand, const ShapeInfo& shape, std::string_view call);
  void CheckBcd(const Operand& operand, BcdUse use);
  void CheckVariable(const Instruction& instruction, Function function);
  /// No operand line follows any more.
  void FinishWaiting();
  bool IsWrongOperand(const Statement& statement);

  // operands.cc
  /// The operand that `tokens` spell from `first` on: its class, its number in that form and within any range that does
  /// not depend on what it is used for. kNone when it is faulty (reported).
  void ReportMalformed(const Token& number);
  Operand ReadOperand(const std::vector<Token>& tokens, size_t first);
  Operand ReadConstantOperand(const Token& class_token, const Token* number);
  /// The places that the operand names exist: bytes of a space, or ports.
  bool IsInRange(const Operand& operand, Access access);
  void WarnOfBorder(const Operand& operand);
  std::string OperandText(const std::vector<Token>& tokens, size_t first) const;
  OperandClass ClassOf(const std::vector<Token>& tokens, size_t first) const;

  // declarations.cc
  void TakeDeclaration(const LexedFile& lexed, const Line& line);
  void DeclareData(std::string_view word, const std::vector<Token>& tokens, source::Range range, Span comments);
  void CheckIoCount(const DataDeclaration& declared, std::string_view text, source::Range range);
  void WarnOfOverlap(const DataDeclaration& declared, std::string_view text);
  void DeclareMFunction(const std::vector<Token>& tokens, source::Range range, Span comments);
  bool TakeSwitch(const Token& token, std::string_view name, MFunction& function, std::set<char>& seen);
  void WarnOfSharedBits(const MFunction& function);
  void DeclareText(std::string_view word, const std::vector<Token>& tokens, source::Range range, Span comments);
  /// The declaration's number between `first` and `last`; none when it is wrong (reported).
  std::optional<uint8_t> DeclarationNumber(std::string_view word, const Token& number, uint32_t first, uint32_t last);
  /// False when the number has been declared before (reported).
  bool IsFirst(std::map<uint8_t, source::Range>& declared, std::string_view name, uint8_t number, source::Range range);

  std::string_view TextOf(const Token& token) const { return sources_.Text(token.range); }
  std::string UpperOf(const Token& token) const { return Upper(TextOf(token)); }
  Instruction& Current() { return program_.instructions[waiting_.instruction]; }

  const source::SourceManager& sources_;
  diag::Engine& diagnostics_;
  BracketChecker brackets_;
  Program program_;

  source::FileId file_;
  std::string faulty_module_;  // the operand of a MOD whose number is wrong
  ModuleId module_;            // open; not valid: outside
  bool forgiving_ = false;     // what stands outside has its cause in a module within a module
  bool seen_module_ = false;
  std::set<uint32_t> abandoned_;  // numbers of modules that an inner MOD closed and that wait for their END
  std::map<std::string, LabelId, std::less<>> labels_;  // of the open module
  std::vector<PendingJump> jumps_;
  Waiting waiting_;

  uint32_t first_free_comment_ = 0;
  bool blank_line_before_ = false;
  bool file_has_items_ = false;

  std::map<uint8_t, source::Range> m_functions_, messages_, menu_texts_;
  std::array<uint32_t, kFirstKeptByte> data_owner_{};  // index of the declaration + 1
};

/// "I 0.0, C 1, T 1": what an instruction accepts, for remedies.
std::string Accepted(std::string_view mnemonic);
std::string Accepted(OperandSet set);

}  // namespace plcxx::prostep
