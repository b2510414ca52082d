#include "transpiler/dialects/nc110/parser/assignment_reader.h"

namespace plcxx::nc110 {

void AssignmentReader::ParseAssignment(Item& item) {
  Assignment assignment;
  assignment.inverted = TakeIf(TokenKind::kSlash);
  if (!AtOperand()) {
    ReportNoStatement();
    return;
  }
  if (ParseTarget(assignment) && Require(TokenKind::kAssign, "'='")) {
    const Type type = TypeOf(assignment.target.operand.kind);
    if (At(TokenKind::kFunction) && Peek().function == Function::kMux) {
      assignment.mux = muxes_.ParseMux(type, assignment.target.range);
    } else {
      assignment.value = expressions_.ParseExpression(type);
    }
  }
  if (!assignment.value.valid() && !assignment.mux.valid()) {
    assignment.value = ErrorExpr(assignment.target.range);
  }
  item.kind = ItemKind::kAssignment;
  item.detail = program_.assignments.Add(assignment).index;
}

/// An operand that nothing is assigned to: the operator in front of it may be missing.
void AssignmentReader::ReportAssignMissing(const Token& operand, const Token& first) {
  const std::string text = Quoted(TextOf(operand));
  if (At(TokenKind::kColon) || At(TokenKind::kBad)) {
    Require(TokenKind::kAssign, "'='");
  } else if (first.first_on_line) {
    HardFault(MissingAt(), diag::Nc110ExpectedHint, "'='", Found(), text + " begins a statement: assign to it");
  } else {
    HardFault(MissingAt(), diag::Nc110ExpectedHint, "'='", Found(),
              text + " begins a statement here: put an operator in front of it, or assign to it");
  }
}

bool AssignmentReader::ParseTarget(Assignment& assignment) {
  const Token& first = now_.lexed.tokens[now_.position - (assignment.inverted ? 1 : 0)];
  const Token& operand = Peek();
  const std::string text(TextOf(operand));
  assignment.target = operands_.TakeOperand();
  const source::Range range = assignment.target.range;
  const OperandKind kind = assignment.target.operand.kind;
  if (kind == OperandKind::kNone) {
    now_.panic = true;
    return false;
  }
  const bool parameter = At(TokenKind::kOpenParenthesis);
  if (!parameter && !At(TokenKind::kAssign)) {
    const bool takes = kind == OperandKind::kTimerInput || kind == OperandKind::kCounterInput;
    if (takes && (At(TokenKind::kNumber) || At(TokenKind::kOpenBracket)) && !Peek().first_on_line) {
      ReportParameterMissing(kind, text);
      now_.panic = true;
    } else {
      ReportAssignMissing(operand, first);
    }
    return false;
  }
  switch (kind) {
    case OperandKind::kInput:
      Fault(range, diag::Nc110InputTarget, Quoted(text));
      break;
    case OperandKind::kTimerElapsed:
    case OperandKind::kTimerRunning:
    case OperandKind::kCounterCarry:
      Fault(range, diag::Nc110ReadOnlyTarget, Quoted(text));
      break;
    case OperandKind::kWord:
    case OperandKind::kCounterValue:
      if (assignment.inverted) {
        Fault(range, diag::Nc110SignalTargetExpected, text);
      }
      break;
    case OperandKind::kTimerInput:
    case OperandKind::kCounterInput:
      ParseParameter(assignment, text);
      return !now_.panic;
    case OperandKind::kNone:
    case OperandKind::kOutput:
    case OperandKind::kTimerHold:
    case OperandKind::kCounterReset:
    case OperandKind::kCounterDown:
    case OperandKind::kOneShot:
      break;
  }
  if (parameter) {
    HardFault(MissingAt(), diag::Nc110ExpectedHint, "'='", Found(),
              "only the inputs of timers and counters have a parameter: T3I(20) = ..., C5I(10) = ...");
  }
  return !now_.panic;
}

void AssignmentReader::ReportParameterMissing(OperandKind target, std::string_view target_text) {
  if (target == OperandKind::kTimerInput) {
    Fault(MissingAt(), diag::Nc110DelayExpected, target_text);
  } else {
    Fault(MissingAt(), diag::Nc110ModulusExpected, target_text);
  }
}

void AssignmentReader::ParseParameter(Assignment& assignment, std::string_view target_text) {
  const OperandKind target = assignment.target.operand.kind;
  assignment.parameter = ErrorExpr(assignment.target.range);
  if (!TakeIf(TokenKind::kOpenParenthesis)) {
    ReportParameterMissing(target, target_text);
    return;
  }
  if (At(TokenKind::kNumber)) {
    assignment.parameter = ParseParameterConstant(target);
  } else if (AtOperand()) {
    assignment.parameter = ParseParameterWord();
  } else if (At(TokenKind::kFunction) || At(TokenKind::kAscii)) {
    HardFault(Peek().range, diag::Nc110ParameterKind, Found());
    return;
  } else {
    now_.failed = now_.failed || At(TokenKind::kBad);
    ReportParameterMissing(target, target_text);
    if (!At(TokenKind::kCloseParenthesis)) {
      now_.panic = true;
      return;
    }
  }
  Require(TokenKind::kCloseParenthesis, "')'");
}

ExprId AssignmentReader::ParseParameterConstant(OperandKind target) {
  const ConstantUse constant = operands_.TakeConstant();
  if (!constant.well_formed) {
    return ErrorExpr(constant.range);
  }
  const bool timer = target == OperandKind::kTimerInput;
  if (timer && (constant.value < 1 || constant.value > 255)) {
    if (constant.value < 1) {
      Fault(constant.range, diag::Nc110DelayNone, constant.text);
    } else {
      Fault(constant.range, diag::Nc110DelayRange, constant.text);
    }
    return ErrorExpr(constant.range);
  }
  if (!timer && (constant.value < 2 || constant.value > 255)) {
    Fault(constant.range, diag::Nc110ModulusRange, constant.text);
    return ErrorExpr(constant.range);
  }
  Expr expr;
  expr.kind = ExprKind::kConstant;
  expr.type = Type::kWord;
  expr.range = constant.range;
  expr.value = static_cast<uint8_t>(constant.value);
  return program_.exprs.Add(expr);
}

/// The low byte of a pair; the last byte of a package has no neighbour.
ExprId AssignmentReader::ParseParameterWord() {
  const std::string text(TextOf(Peek()));
  const OperandUse use = operands_.TakeOperand();
  const Operand& word = use.operand;
  if (word.kind == OperandKind::kNone) {
    return ErrorExpr(use.range);
  }
  if (word.kind != OperandKind::kWord) {
    Fault(use.range, diag::Nc110ParameterKind, Quoted(text));
    return ErrorExpr(use.range);
  }
  if (word.number == ConnectorLimit(word.package) && word.index == 3) {
    const char letter = PackageLetter(word.package);
    Fault(use.range, diag::Nc110PairAtEnd, text, std::string_view(&letter, 1));
    return ErrorExpr(use.range);
  }
  return expressions_.OperandExpr(use);
}

void AssignmentReader::ReportNoStatement() {
  const Token& token = Peek();
  now_.panic = true;
  if (token.kind == TokenKind::kBad) {
    now_.failed = true;
    return;
  }
  if (token.kind == TokenKind::kMinus) {
    Fault(token.range, diag::Nc110MinusOutside);
    return;
  }
  if (token.kind == TokenKind::kFunction) {
    expressions_.ParseFunction(token.function == Function::kSgn ? Type::kWord : Type::kSignal);
    now_.panic = true;
    return;
  }
  if (token.kind == TokenKind::kEnd) {
    operands_.FaultOfUnknown(TextOf(token), token.range);
    return;
  }
  if (token.kind == TokenKind::kNumber && !Evaluate(TextOf(token)).well_formed) {
    operands_.ReportMalformedTarget(token);
    return;
  }
  const TokenKind next = Peek(1).kind;
  const bool second_slash = now_.position > 0 && now_.lexed.tokens[now_.position - 1].kind == TokenKind::kSlash;
  const bool comment = (second_slash && token.kind == TokenKind::kStar) ||
                       (token.kind == TokenKind::kSlash && (second_slash || next == TokenKind::kSlash)) ||
                       (token.kind == TokenKind::kOpenParenthesis && next == TokenKind::kStar) ||
                       (token.kind == TokenKind::kSlash && next == TokenKind::kStar);
  const bool closing = token.kind == TokenKind::kCloseParenthesis || token.kind == TokenKind::kCloseBracket;
  if (closing) {
    Fault(token.range, diag::Nc110StatementExpectedHint, Found(),
          "remove it, or open it where the expression begins that it closes");
  } else if (comment) {
    Fault(token.range, diag::Nc110StatementExpectedHint, Found(), "a comment begins with ';' and ends with its line");
  } else {
    Fault(token.range, diag::Nc110StatementExpected, Found());
  }
}

}  // namespace plcxx::nc110
