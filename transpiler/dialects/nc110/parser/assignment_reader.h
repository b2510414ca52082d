// Assignments: target, parameter, right-hand side (specification 6.3, 7).
#pragma once

#include <string_view>

#include "transpiler/dialects/nc110/parser/expression_reader.h"
#include "transpiler/dialects/nc110/parser/item_reader.h"
#include "transpiler/dialects/nc110/parser/mux_reader.h"
#include "transpiler/dialects/nc110/parser/operand_reader.h"

namespace plcxx::nc110 {

class AssignmentReader : private ItemReader {
 public:
  AssignmentReader(Parsing& parsing, OperandReader& operands, ExpressionReader& expressions)
      : ItemReader(parsing), operands_(operands), expressions_(expressions), muxes_(parsing, expressions) {}

  void ParseAssignment(Item& item);
  /// The word at the cursor is no operand: reported.
  void ReadUnknown() { operands_.TakeOperand(); }
  /// A token that begins nothing.
  void ReportNoStatement();

 private:
  /// Up to the '='. False: nothing can be said about the rest.
  bool ParseTarget(Assignment& assignment);
  void ParseParameter(Assignment& assignment, std::string_view target_text);
  ExprId ParseParameterConstant(OperandKind target);
  ExprId ParseParameterWord();
  /// `first`: of the statement, a slash or the operand itself.
  void ReportAssignMissing(const Token& operand, const Token& first);
  void ReportParameterMissing(OperandKind target, std::string_view target_text);

  OperandReader& operands_;
  ExpressionReader& expressions_;
  MuxReader muxes_;
};

}  // namespace plcxx::nc110
