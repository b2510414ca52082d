// Instructions with what stands on their own line (specification 2.2, 2.4, 2.6).
#pragma once

#include <string>
#include <string_view>

#include "transpiler/dialects/prostep/parser/comment_reader.h"
#include "transpiler/dialects/prostep/parser/label_reader.h"
#include "transpiler/dialects/prostep/parser/line_reader.h"
#include "transpiler/dialects/prostep/parser/operand_reader.h"

namespace plcxx::prostep {

/// "I 0.0, C 1, T 1": what an instruction accepts, for remedies.
std::string Accepted(std::string_view mnemonic);
std::string Accepted(OperandSet set);

class InstructionReader : private LineReader {
 public:
  InstructionReader(Parsing& parsing, CommentReader& comments, LabelReader& labels, OperandReader& operands,
                    BracketChecker& brackets)
      : LineReader(parsing), comments_(comments), labels_(labels), operands_(operands), brackets_(brackets) {}

  void TakeInstruction(const Statement& statement);
  /// Text behind an instruction that has no marker and may have been meant as a part of it (2.2).
  void WarnOfComment(const Statement& statement, bool without_operand);

 private:
  void UnknownInstruction(const Statement& statement, Instruction& instruction);
  void KnownInstruction(const Statement& statement, Instruction& instruction);
  void WithoutOperand(std::string_view mnemonic, Instruction& instruction);
  void WithOperand(const Statement& statement, std::string_view mnemonic, Instruction& instruction);
  void WithTarget(const Token& target, std::string_view mnemonic, Instruction& instruction);
  void Attach(Instruction& instruction);
  void CallFunction(Instruction& instruction);

  CommentReader& comments_;
  LabelReader& labels_;
  OperandReader& operands_;
  BracketChecker& brackets_;
};

}  // namespace plcxx::prostep
