// Labels and instructions, in the order of the program: modules first, then what is outside of them, the subprograms.
#pragma once

#include <vector>

#include "transpiler/dialects/technol/parser/comment_reader.h"
#include "transpiler/dialects/technol/parser/pending.h"
#include "transpiler/dialects/technol/parser/statement_reader.h"

namespace plcxx::technol {

class CodeReader : private StatementReader {
 public:
  CodeReader(Parsing& parsing, CommentReader& comments) : StatementReader(parsing), comments_(comments) {}

  void DefineLabel(const Token& token);
  /// The label of a directive outside of modules is that of what follows it.
  void ReadLabel(const Statement& statement);
  /// Its operands are read later.
  void AddInstruction(const Statement& statement, Op op);
  /// Where a unit begins or ends.
  Instruction& AddMark(Op op, const Statement& place);
  /// Are there subprogram lines since the last unit?
  bool InSubprograms() const { return in_subprograms_; }
  /// Subprograms end here: one that runs on has lost its RET.
  void EndSubprograms(source::Range range);
  /// Of units: the number of the next instruction.
  InstructionId next() const { return InstructionId(static_cast<uint32_t>(code_.size())); }

  /// All instructions to the program, subprograms as its last unit; then their operands. `file`: that of the unit.
  void Finish(source::FileId file);

 private:
  Pending& AddPending(const Statement& statement, Op op);
  void AddSubprograms(source::FileId file);

  CommentReader& comments_;
  std::vector<Pending> code_, subprograms_;
  std::vector<Token> tokens_;  // of all instructions
  std::vector<LabelId> waiting_labels_;
  bool in_subprograms_ = false;
};

}  // namespace plcxx::technol
