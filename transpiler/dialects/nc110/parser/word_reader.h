// Functions, arithmetic and comparators: everything in brackets (specification 3.2, 6.4 to 6.6).
#pragma once

#include "transpiler/dialects/nc110/parser/item_reader.h"
#include "transpiler/dialects/nc110/parser/operand_reader.h"

namespace plcxx::nc110 {

class ExpressionReader;

class WordReader : private ItemReader {
 public:
  WordReader(Parsing& parsing, OperandReader& operands, ExpressionReader& expressions)
      : ItemReader(parsing), operands_(operands), expressions_(expressions) {}

  ExprId ParseFunction(Type type);
  ExprId ParseBracket();
  ExprId ParseComparator();

 private:
  ExprId ParseWordFunction();
  ExprId ParseSgn();
  ExprId ParseSum();
  ExprId ParseTerm();
  ExprId DoubledSign(ExprId left, TokenKind first);
  ExprId ParseComparatorArgument();
  void CheckComparison(ExprId comparison);

  OperandReader& operands_;
  ExpressionReader& expressions_;
};

}  // namespace plcxx::nc110
