// The tree as text, for `print syntax`: declarations, then each function with nested statements and its expressions in
// prefix form. Implicit conversions are shown, since lowering sees them.
#include <cstdio>

#include "transpiler/dialects/hnc/parser.h"
#include "transpiler/dialects/hnc/syntax.h"

namespace plcxx::hnc {
namespace {

constexpr const char* kUnaryNames[] = {"+", "-", "~", "!"};
constexpr const char* kIncrementNames[] = {"++x", "--x", "x++", "x--"};
constexpr const char* kStorageNames[] = {"global", "static local", "automatic", "parameter",
                                         "system", "plc1_time",    "plc2_time", "undefined"};
constexpr unsigned kDeepest = 200;  // levels of an expression that are shown

class Printer {
 public:
  Printer(const source::SourceManager& sources, const Unit& unit) : sources_(sources), unit_(unit) {}

  std::string Run() {
    for (const Record& record : unit_.records) Print(record);
    for (uint32_t i = 0; i < unit_.variables.size(); ++i) {
      const Variable& variable = unit_.variables[VariableId(i)];
      if (!variable.function.valid()) Print(variable, "");
    }
    for (const FunctionId id : unit_.definitions) Print(unit_.functions[id]);
    return std::move(text_);
  }

 private:
  const std::string& TypeText(TypeId type) const { return unit_.types[type].text; }
  void Line(const std::string& indent, const std::string& line) { text_ += indent + line + "\n"; }
  std::string LineOf(source::Range range) const {
    return range.begin == 0 ? std::string() : std::to_string(sources_.Locate(range.begin).line) + ": ";
  }

  void Print(const Record& record);
  void Print(const Variable& variable, const std::string& indent);
  void Print(const Function& function);
  void Print(StatementId id, const std::string& indent);
  std::string Text(ExprId id, unsigned depth = 0) const;
  std::string Operands(const Expr& expr, unsigned depth) const;
  static std::string Number(const Constant& value, const Type& type);

  const source::SourceManager& sources_;
  const Unit& unit_;
  std::string text_;
};

void Printer::Print(const Record& record) {
  Line("", std::string(record.is_union ? "union " : "struct ") + record.name + " size " + std::to_string(record.size));
  for (const Member& member : record.members) {
    std::string line = member.name + " : " + TypeText(member.type) + " at " + std::to_string(member.offset);
    if (member.is_bit_field) {
      line += " bits " + std::to_string(member.bit_offset) + " to " +
              std::to_string(member.bit_offset + member.bit_width) + " exclusive";
    }
    Line("  ", line);
  }
}

void Printer::Print(const Variable& variable, const std::string& indent) {
  std::string line = "variable " + variable.name + " : " + TypeText(variable.type) + ", " +
                     kStorageNames[static_cast<size_t>(variable.storage)];
  if (variable.is_const) line += ", const";
  Line(indent, LineOf(variable.range) + line);
  for (const InitialValue& value : variable.initial) {
    Line(indent + "  ", "at " + std::to_string(value.offset) + ": " + Text(value.value));
  }
}

void Printer::Print(const Function& function) {
  std::string line = "function " + function.name + " : " + TypeText(function.result) + " (";
  for (size_t i = 0; i < function.parameters.size(); ++i) {
    const Variable& parameter = unit_.variables[function.parameters[i]];
    line += (i == 0 ? "" : ", ") + parameter.name + " : " + TypeText(parameter.type);
  }
  Line("", LineOf(function.range) + line + ")" + (function.has_prototype ? "" : " without prototype"));
  Print(function.body, "  ");
}

std::string Printer::Number(const Constant& value, const Type& type) {
  if (type.kind != TypeKind::kReal) return std::to_string(value.integer);
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value.real);
  return text;
}

std::string Printer::Operands(const Expr& expr, unsigned depth) const {
  std::string text;
  for (const ExprId operand : {expr.a, expr.b, expr.c}) {
    if (operand.valid()) text += " " + Text(operand, depth + 1);
  }
  for (const ExprId argument : expr.arguments) text += " " + Text(argument, depth + 1);
  return text + ")";
}

std::string Printer::Text(ExprId id, unsigned depth) const {
  if (!id.valid()) return "none";
  if (depth > kDeepest) return "...";
  const Expr& expr = unit_.expressions[id];
  const std::string type = TypeText(expr.type);
  switch (expr.kind) {
    case ExprKind::kPoison:
      return "poison";
    case ExprKind::kConstant:
      return Number(*expr.constant, unit_.types[expr.type]) + ":" + type;
    case ExprKind::kString:
      return "string#" + std::to_string(expr.string);
    case ExprKind::kVariable:
      return unit_.variables[expr.variable].name;
    case ExprKind::kFunction:
      return "&" + unit_.functions[expr.function].name;
    case ExprKind::kLoad:
      return "(load" + Operands(expr, depth);
    case ExprKind::kDecay:
      return "(decay" + Operands(expr, depth);
    case ExprKind::kConvert:
      return "(to<" + type + ">" + Operands(expr, depth);
    case ExprKind::kCast:
      return "(cast<" + type + ">" + Operands(expr, depth);
    case ExprKind::kNull:
      return "null";
    case ExprKind::kUnary:
      return "(" + std::string(kUnaryNames[static_cast<size_t>(expr.unary)]) + Operands(expr, depth);
    case ExprKind::kBinary:
      return "(" + std::string(Info(expr.binary).printed) + Operands(expr, depth);
    case ExprKind::kAnd:
      return "(&&" + Operands(expr, depth);
    case ExprKind::kOr:
      return "(||" + Operands(expr, depth);
    case ExprKind::kConditional:
      return "(?:" + Operands(expr, depth);
    case ExprKind::kComma:
      return "(," + Operands(expr, depth);
    case ExprKind::kAssign:
      return "(=" + Operands(expr, depth);
    case ExprKind::kCompoundAssign:
      return "(" + std::string(Info(expr.binary).printed) + "=<" + TypeText(expr.computation) + ">" +
             Operands(expr, depth);
    case ExprKind::kIncrement:
      return "(" + std::string(kIncrementNames[static_cast<size_t>(expr.increment)]) + Operands(expr, depth);
    case ExprKind::kAddress:
      return "(&" + Operands(expr, depth);
    case ExprKind::kDereference:
      return "(*" + Operands(expr, depth);
    case ExprKind::kIndex:
      return "([]" + Operands(expr, depth);
    case ExprKind::kMember:
      return "(." + std::to_string(expr.member) + Operands(expr, depth);
    case ExprKind::kCall:
      return "(" + unit_.functions[expr.function].name + Operands(expr, depth);
  }
  return {};
}

void Printer::Print(StatementId id, const std::string& indent) {
  if (!id.valid()) return;
  const Statement& statement = unit_.statements[id];
  const std::string deeper = indent + "  ";
  const auto line = [&](const std::string& text) { Line(indent, LineOf(statement.range) + text); };
  switch (statement.kind) {
    case StatementKind::kCompound:
      for (const StatementId inner : statement.body) Print(inner, indent);
      return;
    case StatementKind::kDeclaration:
      for (const VariableId variable : statement.variables) Print(unit_.variables[variable], indent);
      return;
    case StatementKind::kExpression:
      return line(Text(statement.expression));
    case StatementKind::kEmpty:
      return line("empty");
    case StatementKind::kIf:
      line("if " + Text(statement.expression));
      Print(statement.then, deeper);
      if (!statement.otherwise.valid()) return;
      Line(indent, "else");
      return Print(statement.otherwise, deeper);
    case StatementKind::kSwitch:
      line("switch " + Text(statement.expression));
      return Print(statement.then, deeper);
    case StatementKind::kWhile:
      line("while " + Text(statement.expression));
      return Print(statement.then, deeper);
    case StatementKind::kDo:
      line("do while " + Text(statement.expression));
      return Print(statement.then, deeper);
    case StatementKind::kFor:
      line("for " + Text(statement.first) + "; " + Text(statement.expression) + "; " + Text(statement.step));
      return Print(statement.then, deeper);
    case StatementKind::kGoto:
      return line("goto " + unit_.labels[statement.label].name);
    case StatementKind::kContinue:
      return line("continue");
    case StatementKind::kBreak:
      return line("break");
    case StatementKind::kReturn:
      return line("return " + Text(statement.expression));
    case StatementKind::kLabel:
      line("label " + unit_.labels[statement.label].name);
      return Print(statement.then, indent);
    case StatementKind::kCase:
      line("case " + std::to_string(statement.value));
      return Print(statement.then, deeper);
    case StatementKind::kDefault:
      line("default");
      return Print(statement.then, deeper);
    case StatementKind::kCriticalEnter:
      return line("cli");
    case StatementKind::kCriticalLeave:
      return line("sti");
  }
}

}  // namespace

std::string PrintSyntax(const source::SourceManager& sources, const Unit& unit) { return Printer(sources, unit).Run(); }

}  // namespace plcxx::hnc
