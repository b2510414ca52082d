// The first half of the parser of dialect technol, by families of lines: it expands includes and macros, lays out the
// data, defines all names, and leaves the operands of instructions to operands_internal.h. Shared by its files only.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "transpiler/dialects/technol/parser/expressions.h"
#include "transpiler/dialects/technol/parser/macros.h"
#include "transpiler/dialects/technol/parser/parser.h"
#include "transpiler/dialects/technol/parser/parsing_context.h"
#include "transpiler/dialects/technol/parser/pending.h"
#include "transpiler/dialects/technol/source/token_reader.h"

namespace plcxx::technol {

class Parser {
 public:
  Parser(dialects::Request& request, const Settings& settings)
      : request_(request), context_(*request.sources, *request.diagnostics, settings) {}

  Program Run();

 private:
  /// A line without its comment.
  struct Statement {
    const Token* label = nullptr;
    std::span<const Token> words;    // after the label and its colon; may be empty
    const Token* comment = nullptr;  // of a line of a file
    std::string_view line;           // its whole text
    source::Range range;             // of `words`, or of the label alone
    std::string upper;               // the first word in capitals; empty when it is no word

    const Token& first() const { return words.front(); }
  };

  struct StructureField {
    uint32_t offset = 0;
    uint8_t width = 8;
    uint32_t bytes = 0;
  };
  struct Structure {
    SymbolId symbol;
    std::string name;
    source::Range range;
    std::vector<StructureField> fields;
    std::vector<uint8_t> initial;
  };

  // parser.cc
  void TakeSource(source::FileId file);
  void TakeLines(source::FileId file);
  void TakeLine(std::string_view text, const LinePlace& place);
  bool CheckTokens(std::span<const Token> tokens);
  void TakeStatement(Statement& statement);
  bool TakeDirective(const Statement& statement);
  bool TakeDefinition(const Statement& statement);
  void UnknownLine(const Statement& statement);
  void KeepUnknown(const Statement& statement);
  void KeepFaultyLine(Statement& statement, std::span<const Token> words);
  void EndOfSource(source::FileId file);
  void CheckWhole();
  /// The last line of a file that is not blank.
  source::Range LastLine(source::FileId file) const;

  // comments.cc
  void AddComment(const Token& comment, CommentPlace place);
  void TakeBlankLine();
  Span TakeComments();
  Span TakeComments(const Statement& statement);

  // structure.cc: modules, mechanisms, data blocks, STOP, labels, instructions
  void OpenModule(const Statement& statement, ModuleKind kind);
  void CloseModule(const Statement& statement, std::string_view keyword);
  void OpenMechanism(const Statement& statement);
  void CloseMechanism(const Statement& statement);
  void OpenData(const Statement& statement);
  void CloseData(const Statement& statement);
  void TakeStop(const Statement& statement);
  void TakeInstruction(const Statement& statement, Op op);
  void DefineLabel(const Token& token);
  /// The label of a directive outside of modules stands in front of what follows it.
  void TakeLabel(const Statement& statement);
  void LeaveMechanism(source::Range close);
  void LeaveModule(source::Range close);
  void EndStretch(source::Range range);
  Pending& AddPending(const Statement& statement, Op op);
  UnitId CurrentUnit() const { return mechanism_.valid() ? mechanism_ : module_; }
  /// Reports a statement that may not stand where the program is: in an include file, in data, in a module.
  bool IsOutside(const Statement& statement);
  bool IsCodePlace(const Statement& statement);
  bool ExpectEnd(const Statement& statement, size_t words);

  // constants.cc
  void TakeEqui(const Statement& statement);
  void DefineConstant(const Token& name, std::span<const Token> expression);
  void AssignConstant(const Token& name, std::span<const Token> expression);

  // data.cc
  void TakeAllocation(const Statement& statement, const Token* name, size_t directive);
  void ReserveBytes(const Statement& statement, const Token* name, std::span<const Token> words);
  void TakeBits(const Statement& statement, size_t directive);
  void TakeInstance(const Statement& statement, const Token* name, size_t structure);
  void DefineCell(const Statement& statement, const Token* name, uint8_t width, std::span<const uint8_t> bytes);
  bool IsDataPlace(const Statement& statement, const Token* name);
  /// Values of DB, DW, DD after the reader, `width` bits each; false when one is wrong (reported).
  bool ReadValues(TokenReader& reader, uint8_t width, uint32_t level, std::vector<uint8_t>& bytes);
  bool ReadValue(TokenReader& reader, uint8_t width, uint32_t level, std::vector<uint8_t>& bytes);
  bool ReadField(TokenReader& reader, const StructureField& field, std::vector<uint8_t>& instance);
  bool AppendNumber(int64_t value, uint8_t width, std::vector<uint8_t>& bytes);

  // structures.cc
  void OpenStructure(const Statement& statement);
  void TakeField(const Statement& statement);
  void CloseStructure(const Statement& statement);
  void FinishStructure();
  void DefineField(const Token& name, const StructureField& field);
  void AddControlStructures();

  // macro_statements.cc
  void OpenMacro(const Statement& statement);
  void TakeMacroLine(std::string_view text, std::span<const Token> tokens, const LinePlace& place);
  void FinishMacro();
  void CallMacro(const Statement& statement, const Macro& macro, const Token& name);
  void WarnOfCompletion(const Token& word);

  // includes.cc
  void TakeInclude(const Statement& statement);
  void TakeSystemHeader(const Statement& statement);
  std::optional<std::string> FindInclude(std::string_view name, TokenKind form) const;
  bool MayInclude(std::string_view name, const std::string& path) const;
  source::FileId LoadInclude(const std::string& path, const Token& name);

  // signals.cc
  void AddControlSymbols();
  void AddSignalFile();

  // tables.cc
  void TakeTables();

  // usage.cc: TW004
  void WarnOfUnused();

  dialects::Request& request_;
  ParsingContext context_;
  std::vector<source::FileId> sources_;  // without tables
  source::FileId last_source_;

  // The file and the place in the program.
  source::FileId file_;
  std::vector<std::string> including_;  // identities of the files that are open
  std::map<std::string, source::FileId> included_;
  uint32_t include_count_ = 0;
  bool in_data_ = false;
  bool has_data_ = false;
  bool stopped_ = false;
  bool has_stop_ = false;
  bool warned_behind_stop_ = false;
  UnitId module_, mechanism_;
  std::set<std::string> abandoned_modules_, abandoned_mechanisms_;  // closed by an inner one, their END may come
  std::map<std::string, source::Range> modules_;                    // where each is opened first
  bool stretch_open_ = false;                                       // subprogram lines since the last mark
  std::vector<LabelId> waiting_labels_;

  std::vector<Pending> code_, subprograms_;
  std::vector<Token> code_tokens_;
  uint32_t statement_number_ = 0;

  std::set<SymbolId> assigned_;         // constants defined by '='
  std::optional<Structure> structure_;  // open
  std::unordered_map<SymbolId, Structure> structures_;
  std::optional<Macro> macro_;  // being defined
  std::unordered_map<SymbolId, Macro> macros_;
  uint32_t macro_depth_ = 0;
  uint32_t expanded_lines_ = 0;
  uint32_t expansion_count_ = 0;
  bool expansion_full_ = false;  // too many lines: reported, no macro is expanded any more
  std::deque<std::string> expanded_texts_;

  std::vector<Comment> waiting_comments_;
  bool blank_line_before_ = false;
  bool file_has_items_ = false;
};

}  // namespace plcxx::technol
