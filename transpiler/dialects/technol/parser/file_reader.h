// Files and their lines (specification 2.1, 4.1): what each statement is, and which reader it goes to.
#pragma once

#include <span>
#include <string_view>

#include "transpiler/dialects/technol/parser/code_reader.h"
#include "transpiler/dialects/technol/parser/comment_reader.h"
#include "transpiler/dialects/technol/parser/constant_reader.h"
#include "transpiler/dialects/technol/parser/data_reader.h"
#include "transpiler/dialects/technol/parser/include_reader.h"
#include "transpiler/dialects/technol/parser/macro_reader.h"
#include "transpiler/dialects/technol/parser/statement_reader.h"
#include "transpiler/dialects/technol/parser/structure_reader.h"
#include "transpiler/dialects/technol/parser/unit_reader.h"
#include "transpiler/dialects/technol/parser/unknown_statement.h"

namespace plcxx::technol {

class FileReader : private StatementReader {
 public:
  /// The control's own structures are known at once.
  explicit FileReader(Parsing& parsing);
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;

  void ReadSource(source::FileId file);
  /// After all sources.
  void EndOfProgram();

 private:
  void ReadLines(source::FileId file);
  /// Of a file or of a macro's expansion.
  void ReadLine(std::string_view text, const LinePlace& place);
  void CheckLength(std::string_view line, source::Offset begin);
  void ReadWords(Statement& statement, std::span<const Token> words);
  void ReadStatement(const Statement& statement);
  /// A statement whose first word tells what it is.
  bool ReadDirective(const Statement& statement);
  /// A statement whose second word tells what it is.
  bool ReadDefinition(const Statement& statement);
  /// A macro's call, or an instance of a structure.
  bool ReadUse(const Statement& statement);
  void ReadInclude(const Statement& statement);
  void ReadCall(const Statement& statement, const Macro& macro);
  /// A statement with a bad character: what it would load is not missed after it.
  void KeepFaultyLine(Statement& statement, std::span<const Token> words);
  void KeepUnknown(const Statement& statement);
  /// A misspelt word of the program's structure begins or ends what it means, so that nothing of it is missed.
  bool ReadMeant(const Statement& statement);
  CodePlace CurrentPlace() const;
  /// What a faulty line may define is no fault where it is used.
  void ExcuseNames(const Statement& statement);
  /// Macros and structures that are open at the end of a file.
  void LeaveOpenDefinitions(source::FileId file);
  /// The last line of a file that is not blank.
  source::Range LastLine(source::FileId file) const;

  const Parsing& parsing_;
  CommentReader comments_;
  CodeReader code_;
  UnitReader units_;
  ConstantReader constants_;
  StructureReader structures_;
  DataReader data_;
  MacroReader macros_;
  IncludeReader includes_;
};

}  // namespace plcxx::technol
