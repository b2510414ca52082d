// Operands: a class and a number (specification 2.4, 5.1).
#pragma once

#include <string>
#include <vector>

#include "transpiler/dialects/prostep/parser/line_reader.h"

namespace plcxx::prostep {

class OperandReader : private LineReader {
 public:
  using LineReader::LineReader;

  /// The operand that `tokens` spell from `first` on: its class, its number in that form and within any range that does
  /// not depend on what it is used for. kNone when it is faulty (reported).
  Operand ReadOperand(const std::vector<Token>& tokens, size_t first);
  /// The places that the operand names exist: bytes of a space, or ports.
  bool IsInRange(const Operand& operand, Access access);
  void WarnOfBorder(const Operand& operand);
  std::string OperandText(const std::vector<Token>& tokens, size_t first) const;
  OperandClass ClassOf(const std::vector<Token>& tokens, size_t first) const;

 private:
  Operand ReadConstantOperand(const Token& class_token, const Token* number);
  void ReportMalformed(const Token& number);
};

}  // namespace plcxx::prostep
