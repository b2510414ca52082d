// Operand lines (specification 2.6) and the arguments of functional modules (6.9).
#pragma once

#include <string_view>

#include "transpiler/dialects/prostep/parser/comment_reader.h"
#include "transpiler/dialects/prostep/parser/instruction_reader.h"
#include "transpiler/dialects/prostep/parser/label_reader.h"
#include "transpiler/dialects/prostep/parser/line_reader.h"
#include "transpiler/dialects/prostep/parser/operand_reader.h"

namespace plcxx::prostep {

class OperandLineReader : private LineReader {
 public:
  OperandLineReader(Parsing& parsing, CommentReader& comments, LabelReader& labels, OperandReader& operands,
                    InstructionReader& instructions)
      : LineReader(parsing), comments_(comments), labels_(labels), operands_(operands), instructions_(instructions) {}

  void TakeOperandLine(const Statement& statement);
  /// `: 30.1` where an operand is waited for: no instruction, but what the operand would be in another language, or
  /// without its K. One fault with the missing operand.
  bool IsWrongOperand(const Statement& statement);
  /// No operand line follows any more.
  void FinishWaiting();

 private:
  void TakeNextOperand(const Statement& statement, Instruction& instruction);
  void TakeArgument(const Statement& statement, Instruction& instruction, Function function);
  void CheckArgument(Operand& operand, const ShapeInfo& shape, std::string_view call);
  void CheckField(const Operand& operand, const ShapeInfo& shape, std::string_view call);
  void CheckBcd(const Operand& operand, BcdUse use);
  void CheckVariable(const Instruction& instruction, Function function);
  Instruction& Current() { return program_.instructions[now_.waiting.instruction]; }

  CommentReader& comments_;
  LabelReader& labels_;
  OperandReader& operands_;
  InstructionReader& instructions_;
};

}  // namespace plcxx::prostep
