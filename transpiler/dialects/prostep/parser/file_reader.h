// A file line by line: what each is, and who reads it (specification 2.1, 2.2).
#pragma once

#include "transpiler/dialects/prostep/parser/brackets.h"
#include "transpiler/dialects/prostep/parser/comment_reader.h"
#include "transpiler/dialects/prostep/parser/declaration_reader.h"
#include "transpiler/dialects/prostep/parser/instruction_reader.h"
#include "transpiler/dialects/prostep/parser/label_reader.h"
#include "transpiler/dialects/prostep/parser/line_reader.h"
#include "transpiler/dialects/prostep/parser/module_reader.h"
#include "transpiler/dialects/prostep/parser/operand_line_reader.h"
#include "transpiler/dialects/prostep/parser/operand_reader.h"

namespace plcxx::prostep {

class FileReader : private LineReader {
 public:
  explicit FileReader(Parsing& parsing)
      : LineReader(parsing),
        brackets_(parsing.diagnostics),
        comments_(parsing),
        labels_(parsing, brackets_),
        operands_(parsing),
        instructions_(parsing, comments_, labels_, operands_, brackets_),
        lines_(parsing, comments_, labels_, operands_, instructions_),
        modules_(parsing, comments_, labels_, operands_, instructions_, brackets_),
        declarations_(parsing, comments_) {}
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;

  void TakeFile(source::FileId file);

 private:
  void TakeLine(const LexedFile& lexed, const Line& line);
  void TakeStatement(const LexedFile& lexed, const Line& line);
  Statement Split(const LexedFile& lexed, const Line& line) const;
  /// A colon and nothing more, perhaps with a label or a comment.
  void EmptyStatement(const Statement& statement);
  void ReportOutside(const Statement& statement);

  BracketChecker brackets_;
  CommentReader comments_;
  LabelReader labels_;
  OperandReader operands_;
  InstructionReader instructions_;
  OperandLineReader lines_;
  ModuleReader modules_;
  DeclarationReader declarations_;
};

}  // namespace plcxx::prostep
