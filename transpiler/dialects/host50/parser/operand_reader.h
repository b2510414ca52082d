// Operands by their roles (specification 3 and 6.2 to 6.8): type, direction, range.
#pragma once

#include <string_view>
#include <vector>

#include "transpiler/dialects/host50/parser/parts.h"
#include "transpiler/dialects/host50/parser/statement_reader.h"
#include "transpiler/dialects/host50/parser/symbol_reader.h"

namespace plcxx::host50 {

class OperandReader : private StatementReader {
 public:
  OperandReader(Parsing& parsing, const Parts& parts, SymbolReader& symbols)
      : StatementReader(parsing), parts_(parts), symbols_(symbols) {}

  /// An instruction's operands come.
  void BeginOperands() { number_tokens_.clear(); }
  /// A role that is an operand of its own.
  Operand ReadOperand(OperandRole role);
  /// Of TON, TOF and TP without a unit in their names.
  void ReadUnit(Instruction& instruction);
  /// The constants of MOV and of compares: a float opposite a float, else an int32. The field of BTOW and WTOB.
  void SettleConstants(Instruction& instruction);

 private:
  void ReadBit(Operand& operand);
  void ReadCoil(Operand& operand);
  void ReadNumber(Operand& operand);
  void ReadResult(Operand& operand);
  void ReadField(Operand& operand);
  void ReadBitCount(Operand& operand);
  void ReadInstance(Operand& operand);
  void ReadSubroutine(Operand& operand);
  void ReadJumpTarget(Operand& operand);
  void ReadText(Operand& operand);
  void SetInteger(Operand& operand, const Token& token);
  void SetFloat(Operand& operand, const Token& token);
  void CheckAxisNumber(const Operand& operand);
  /// The address at the cursor; false when there is none or a fault was reported.
  bool ReadPlace(Operand& operand, std::string_view what);
  void FaultOfType(Type wanted, source::Range range, std::string_view found);

  const Parts& parts_;
  SymbolReader& symbols_;
  std::vector<Token> number_tokens_;  // of the operands of the instruction; kEnd where it is no number
};

}  // namespace plcxx::host50
