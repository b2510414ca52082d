// `plcxx print tokens` and `plcxx print syntax`: one line per token or statement, stable, places as line:column.
#include <bit>
#include <charconv>
#include <vector>

#include "transpiler/dialects/common/printing.h"
#include "transpiler/dialects/host50/parser/parser.h"
#include "transpiler/dialects/host50/source/lexer.h"

namespace plcxx::host50 {
namespace {

std::string_view OperatorName(ExprKind kind) {
  switch (kind) {
    case ExprKind::kError:
      return "error";
    case ExprKind::kConstant:
      return "constant";
    case ExprKind::kAddress:
      return "address";
    case ExprKind::kNegate:
      return "negate";
    case ExprKind::kMultiply:
      return "*";
    case ExprKind::kDivide:
      return "/";
    case ExprKind::kAdd:
      return "+";
    case ExprKind::kSubtract:
      return "-";
    case ExprKind::kAnd:
      return "&";
    case ExprKind::kOr:
      return "|";
    case ExprKind::kGreater:
      return ">";
    case ExprKind::kLess:
      return "<";
    case ExprKind::kGreaterEqual:
      return ">=";
    case ExprKind::kLessEqual:
      return "<=";
    case ExprKind::kEqual:
      return "=";
    case ExprKind::kNotEqual:
      return "<>";
  }
  PLCXX_UNREACHABLE();
}

std::string_view SectionName(SectionKind kind) {
  switch (kind) {
    case SectionKind::kFast:
      return "fast";
    case SectionKind::kSlow:
      return "slow";
    case SectionKind::kSubroutine:
      return "sub";
    case SectionKind::kNone:
      return "outside";
  }
  PLCXX_UNREACHABLE();
}

/// The shortest text that reads back as the same binary32, always with a point or an exponent.
std::string FloatText(uint32_t bits) {
  char buffer[32];
  const auto result = std::to_chars(std::begin(buffer), std::end(buffer), std::bit_cast<float>(bits));
  std::string text(buffer, result.ptr);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string ConstantText(Type type, uint32_t bits) {
  if (type == Type::kFloat) return FloatText(bits);
  return std::to_string(static_cast<int32_t>(bits));
}

class SyntaxPrinter : dialects::SyntaxLines {
 public:
  SyntaxPrinter(const source::SourceManager& sources, const Program& program)
      : SyntaxLines(sources), program_(program) {}

  std::string Run() {
    PrintSettings();
    PrintTables();
    for (const Section& section : program_.sections) Print(section);
    return writer_.Take();
  }

 private:
  void PrintSettings() {
    const Settings& settings = program_.settings;
    writer_.Line("slowdiv ", std::to_string(settings.slowdiv), " channels ", std::to_string(settings.channels));
#define HOST50_OPTION(Name, Member, Key, First, FirstText, Second, SecondText, Meaning) \
  writer_.Line("option ", Key, "=", settings.Member == Name##Option::First ? FirstText : SecondText);
#include "transpiler/dialects/host50/machine/machine.def"
  }

  void PrintTables() {
    for (const TitleField& field : program_.title) {
      Node(field.range, "title ", TitleKeys()[static_cast<size_t>(field.key)].name, " \"", field.text, "\"");
    }
    for (const Symbol& symbol : program_.symbols) {
      if (symbol.predefined) continue;
      Node(symbol.range, "symbol ", ToText(symbol.address), " '", symbol.name, "' \"", symbol.comment, "\"");
    }
    for (const Alarm& alarm : program_.alarms) {
      Node(alarm.range, "alarm ", std::to_string(alarm.index), " ",
           Severities()[static_cast<size_t>(alarm.severity)].keyword, " \"", alarm.text, "\"");
    }
    for (const MCode& code : program_.mcodes) {
      Node(code.range, "mcode ", std::to_string(code.number), " \"", code.text, "\"");
    }
  }

  void Print(const Section& section) {
    std::string head(SectionName(section.kind));
    if (section.kind == SectionKind::kSubroutine) head += " " + SubroutineName(section.number);
    if (!section.name.empty()) head += " \"" + section.name + "\"";
    Node(section.range, head);
    const support::Indented deeper(writer_);
    for (uint32_t i = 0; i < section.networks.count; ++i) {
      Print(program_.networks[NetworkId(section.networks.first + i)]);
    }
  }

  void Print(const Network& network) {
    std::string head = "network " + std::to_string(network.number);
    if (network.has_label) head += " labelled";
    if (network.is_drawing) head += " drawn";
    if (!network.comment.empty()) head += " \"" + network.comment + "\"";
    Node(network.range, head);
    const support::Indented deeper(writer_);
    for (uint32_t i = 0; i < network.instructions.count; ++i) {
      Print(InstructionId(network.instructions.first + i), network.instructions.first);
    }
  }

  /// Instructions are numbered in their network: "#2 AND %I1 <- #0 #1".
  void Print(InstructionId id, uint32_t first) {
    const Instruction& instruction = program_.instructions[id];
    std::string line = "#" + std::to_string(id.index - first) + " ";
    line += instruction.unknown ? "error" : std::string(Info(instruction.op).name);
    if (Info(instruction.op).state == State::kTimer) line += " " + std::to_string(Duration(instruction.unit)) + "ms";
    for (uint32_t i = 0; i < instruction.operands.count; ++i) {
      line += (i == 0 ? " " : ", ") + OperandText(program_.operands[instruction.operands.first + i]);
    }
    const auto number = [&](InstructionId result) { return "#" + std::to_string(result.index - first); };
    for (uint32_t i = 0; i < instruction.pins.count; ++i) {
      const Pin& pin = program_.pins[instruction.pins.first + i];
      line += std::string(", ") + pin.name + "=";
      if (!pin.from_stack) {
        line += OperandText(pin.operand);
      } else {
        line += pin.result.valid() ? number(pin.result) : "?";
      }
    }
    if (instruction.input.kind == InputKind::kRail) line += " <- rail";
    if (instruction.input.kind == InputKind::kResults) line += " <-";
    for (uint32_t i = 0; i < instruction.input.results.count; ++i) {
      line += " " + number(program_.results[instruction.input.results.first + i]);
    }
    if (instruction.other.valid()) line += " with " + number(instruction.other);
    if (instruction.faulty) line += " (faulty)";
    Node(instruction.range, line);
  }

  std::string AddressText(const Address& address, SymbolId symbol) const {
    return ToText(address) + (symbol.valid() ? ":" + program_.symbols[symbol].name : "");
  }

  std::string OperandText(const Operand& operand) const {
    switch (operand.kind) {
      case OperandKind::kError:
        return "error";
      case OperandKind::kAddress:
        return (operand.inverted ? "!" : "") + AddressText(operand.address, operand.symbol);
      case OperandKind::kConstant:
        return ConstantText(operand.type, operand.bits);
      case OperandKind::kSubroutine:
        return SubroutineName(program_.sections[operand.section].number);
      case OperandKind::kNetwork:
        return "L" + std::to_string(program_.networks[operand.network].number);
      case OperandKind::kCount:
        return std::to_string(operand.bits);
      case OperandKind::kText:
        return operand.range.end > operand.range.begin ? std::string(sources_.Text(operand.range)) : "\"\"";
      case OperandKind::kExpression:
        return ExprText(operand.expr);
    }
    PLCXX_UNREACHABLE();
  }

  std::string ExprText(ExprId id) const {
    const Expr& expr = program_.exprs[id];
    if (expr.kind == ExprKind::kConstant) return ConstantText(expr.type, expr.bits);
    if (expr.kind == ExprKind::kAddress) return AddressText(expr.address, expr.symbol);
    std::vector<ExprId> operands;
    for (const ExprId child : {expr.left, expr.right}) {
      if (child.valid()) operands.push_back(child);
    }
    return dialects::PrefixForm(OperatorName(expr.kind), operands, [this](ExprId child) { return ExprText(child); }) +
           (expr.type == Type::kFloat ? "f" : "");
  }

  const Program& program_;
};

}  // namespace

std::string PrintTokens(const source::SourceManager& sources, source::FileId file) {
  const LexedFile lexed = Lex(sources, file);
  return dialects::TokenLines(sources, lexed.tokens);
}

std::string PrintSyntax(const source::SourceManager& sources, const Program& program) {
  return SyntaxPrinter(sources, program).Run();
}

}  // namespace plcxx::host50
