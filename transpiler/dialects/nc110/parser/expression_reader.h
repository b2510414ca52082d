// Operators and what both types share: precedence, parentheses, operands, constants (specification 3.5, 6.1, 6.2).
#pragma once

#include <string_view>
#include <unordered_map>

#include "transpiler/dialects/nc110/parser/item_reader.h"
#include "transpiler/dialects/nc110/parser/operand_reader.h"
#include "transpiler/dialects/nc110/parser/word_reader.h"

namespace plcxx::nc110 {

class ExpressionReader : private ItemReader {
 public:
  ExpressionReader(Parsing& parsing, OperandReader& operands)
      : ItemReader(parsing), operands_(operands), words_(parsing, operands, *this) {}
  ExpressionReader(const ExpressionReader&) = delete;
  ExpressionReader& operator=(const ExpressionReader&) = delete;

  ExprId ParseExpression(Type type);
  ExprId ParseFunction(Type type) { return words_.ParseFunction(type); }
  ExprId ParseOperand(Type type);
  ExprId ParseConstant(Type type);
  ExprId ParseAscii(Type type);

  ExprId OperandExpr(const OperandUse& use);
  ExprId Unary(ExprKind kind, Type type, source::Range range, ExprId left);
  ExprId Binary(ExprKind kind, Type type, ExprId left, ExprId right);

 private:
  ExprId ParseAnd(Type type);
  ExprId ParseNot(Type type);
  ExprId ParsePrimary(Type type);
  ExprId ParseGroup(Type type);
  ExprId ParseUnknownPrimary();
  void WarnOrOfNumber(source::Range sign, ExprId left, ExprId right);
  void WarnConstantSignal(source::Range range);

  OperandReader& operands_;
  WordReader words_;
  std::unordered_map<std::string_view, LiteralId> literals_;
};

}  // namespace plcxx::nc110
