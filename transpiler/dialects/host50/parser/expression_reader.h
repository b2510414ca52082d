// The arguments of COMP and OPRT (specification 3, 6.6).
#pragma once

#include <string_view>
#include <vector>

#include "transpiler/dialects/host50/parser/operand_reader.h"
#include "transpiler/dialects/host50/parser/statement_reader.h"
#include "transpiler/dialects/host50/parser/symbol_reader.h"

namespace plcxx::host50 {

class ExpressionReader : private StatementReader {
 public:
  ExpressionReader(Parsing& parsing, SymbolReader& symbols, OperandReader& operands)
      : StatementReader(parsing), symbols_(symbols), operands_(operands) {}

  Operand ReadComparison();
  /// The destination, then the value.
  void ReadAssignment(std::vector<Operand>& operands);

 private:
  enum class ExpressionOf : uint8_t { kComparison, kAssignment };
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

  SymbolReader& symbols_;
  OperandReader& operands_;
  ExpressionOf expression_of_ = ExpressionOf::kComparison;
  uint32_t parentheses_ = 0, expression_operands_ = 0;
};

}  // namespace plcxx::host50
