// The tree as text, for `print syntax`: declarations, then each function with nested statements and its expressions in
// prefix form. Implicit conversions are shown, since lowering sees them.
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/common/printing.h"
#include "transpiler/dialects/hnc/parser/parser.h"
#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {
namespace {

constexpr const char* kUnaryNames[] = {"+", "-", "~", "!"};
constexpr const char* kIncrementNames[] = {"++x", "--x", "x++", "x--"};
constexpr const char* kStorageNames[] = {"global", "static local", "automatic", "parameter",
                                         "system", "plc1_time",    "plc2_time", "undefined"};
constexpr unsigned kDeepest = 200;  // levels of an expression that are shown

class Printer : dialects::SyntaxLines {
 public:
  Printer(const source::SourceManager& sources, const Unit& unit) : SyntaxLines(sources), unit_(unit) {}

  std::string Run() {
    for (const Record& record : unit_.records) Print(record);
    for (uint32_t i = 0; i < unit_.variables.size(); ++i) {
      const Variable& variable = unit_.variables[VariableId(i)];
      if (!variable.function.valid()) Print(variable);
    }
    for (const FunctionId id : unit_.definitions) Print(unit_.functions[id]);
    return writer_.Take();
  }

 private:
  const std::string& TypeText(TypeId type) const { return unit_.types[type].text; }
  std::string LineOf(source::Range range) const {
    return range.begin == 0 ? std::string() : std::to_string(sources_.Locate(range.begin).line) + ": ";
  }

  void Print(const Record& record);
  void Print(const Variable& variable);
  void Print(const Function& function);
  void Print(StatementId id);
  void PrintDeeper(StatementId id);
  std::string Text(ExprId id, unsigned depth = 0) const;
  static std::string Number(const Constant& value, const Type& type);

  const Unit& unit_;
};

void Printer::Print(const Record& record) {
  writer_.Line(record.is_union ? "union " : "struct ", record.name, " size ", std::to_string(record.size));
  const support::Indented deeper(writer_);
  for (const Member& member : record.members) {
    std::string line = member.name + " : " + TypeText(member.type) + " at " + std::to_string(member.offset);
    if (member.is_bit_field) {
      line += " bits " + std::to_string(member.bit_offset) + " to " +
              std::to_string(member.bit_offset + member.bit_width) + " exclusive";
    }
    writer_.Line(line);
  }
}

void Printer::Print(const Variable& variable) {
  std::string line = "variable " + variable.name + " : " + TypeText(variable.type) + ", " +
                     kStorageNames[static_cast<size_t>(variable.storage)];
  if (variable.is_const) line += ", const";
  writer_.Line(LineOf(variable.range), line);
  const support::Indented deeper(writer_);
  for (const InitialValue& value : variable.initial) {
    writer_.Line("at ", std::to_string(value.offset), ": ", Text(value.value));
  }
}

void Printer::Print(const Function& function) {
  std::string line = "function " + function.name + " : " + TypeText(function.result) + " (";
  for (size_t i = 0; i < function.parameters.size(); ++i) {
    const Variable& parameter = unit_.variables[function.parameters[i]];
    line += (i == 0 ? "" : ", ") + parameter.name + " : " + TypeText(parameter.type);
  }
  writer_.Line(LineOf(function.range), line, ")", function.has_prototype ? "" : " without prototype");
  PrintDeeper(function.body);
}

std::string Printer::Number(const Constant& value, const Type& type) {
  if (type.kind != TypeKind::kReal) return std::to_string(value.integer);
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value.real);
  return text;
}

std::string Printer::Text(ExprId id, unsigned depth) const {
  if (!id.valid()) return "none";
  if (depth > kDeepest) return "...";
  const Expr& expr = unit_.expressions[id];
  const std::string type = TypeText(expr.type);
  const auto form = [&](std::string_view name) {
    std::vector<ExprId> operands;
    for (const ExprId operand : {expr.a, expr.b, expr.c}) {
      if (operand.valid()) operands.push_back(operand);
    }
    operands.insert(operands.end(), expr.arguments.begin(), expr.arguments.end());
    return dialects::PrefixForm(name, operands, [&](ExprId operand) { return Text(operand, depth + 1); });
  };
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
      return form("load");
    case ExprKind::kDecay:
      return form("decay");
    case ExprKind::kConvert:
      return form("to<" + type + ">");
    case ExprKind::kCast:
      return form("cast<" + type + ">");
    case ExprKind::kNull:
      return "null";
    case ExprKind::kUnary:
      return form(kUnaryNames[static_cast<size_t>(expr.unary)]);
    case ExprKind::kBinary:
      return form(Info(expr.binary).printed);
    case ExprKind::kAnd:
      return form("&&");
    case ExprKind::kOr:
      return form("||");
    case ExprKind::kConditional:
      return form("?:");
    case ExprKind::kComma:
      return form(",");
    case ExprKind::kAssign:
      return form("=");
    case ExprKind::kCompoundAssign:
      return form(std::string(Info(expr.binary).printed) + "=<" + TypeText(expr.computation) + ">");
    case ExprKind::kIncrement:
      return form(kIncrementNames[static_cast<size_t>(expr.increment)]);
    case ExprKind::kAddress:
      return form("&");
    case ExprKind::kDereference:
      return form("*");
    case ExprKind::kIndex:
      return form("[]");
    case ExprKind::kMember:
      return form("." + std::to_string(expr.member));
    case ExprKind::kCall:
      return form(unit_.functions[expr.function].name);
  }
  return {};
}

void Printer::PrintDeeper(StatementId id) {
  const support::Indented deeper(writer_);
  Print(id);
}

void Printer::Print(StatementId id) {
  if (!id.valid()) return;
  const Statement& statement = unit_.statements[id];
  const auto line = [&](std::string_view text) { writer_.Line(LineOf(statement.range), text); };
  switch (statement.kind) {
    case StatementKind::kCompound:
      for (const StatementId inner : statement.body) Print(inner);
      return;
    case StatementKind::kDeclaration:
      for (const VariableId variable : statement.variables) Print(unit_.variables[variable]);
      return;
    case StatementKind::kExpression:
      return line(Text(statement.expression));
    case StatementKind::kEmpty:
      return line("empty");
    case StatementKind::kIf:
      line("if " + Text(statement.expression));
      PrintDeeper(statement.then);
      if (!statement.otherwise.valid()) return;
      writer_.Line("else");
      return PrintDeeper(statement.otherwise);
    case StatementKind::kSwitch:
      line("switch " + Text(statement.expression));
      return PrintDeeper(statement.then);
    case StatementKind::kWhile:
      line("while " + Text(statement.expression));
      return PrintDeeper(statement.then);
    case StatementKind::kDo:
      line("do while " + Text(statement.expression));
      return PrintDeeper(statement.then);
    case StatementKind::kFor:
      line("for " + Text(statement.first) + "; " + Text(statement.expression) + "; " + Text(statement.step));
      return PrintDeeper(statement.then);
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
      return Print(statement.then);
    case StatementKind::kCase:
      line("case " + std::to_string(statement.value));
      return PrintDeeper(statement.then);
    case StatementKind::kDefault:
      line("default");
      return PrintDeeper(statement.then);
    case StatementKind::kCriticalEnter:
      return line("cli");
    case StatementKind::kCriticalLeave:
      return line("sti");
  }
}

}  // namespace

std::string PrintSyntax(const source::SourceManager& sources, const Unit& unit) { return Printer(sources, unit).Run(); }

}  // namespace plcxx::hnc
