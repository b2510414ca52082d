// `plcxx print tokens` and `plcxx print syntax`: one line per line of the project, or per section, rung, element.
#include <algorithm>

#include "transpiler/dialects/classicladder/parser/parser.h"
#include "transpiler/dialects/classicladder/source/lines.h"
#include "transpiler/dialects/common/printing.h"
#include "transpiler/support/check.h"

namespace plcxx::classicladder {
namespace {

std::string_view NameOfKind(ExprKind kind) {
  switch (kind) {
    case ExprKind::kConstant:
      return "constant";
    case ExprKind::kVariable:
      return "variable";
    case ExprKind::kNot:
      return "!";
    case ExprKind::kPower:
      return "^";
    case ExprKind::kMultiply:
      return "*";
    case ExprKind::kDivide:
      return "/";
    case ExprKind::kModulo:
      return "%";
    case ExprKind::kAdd:
      return "+";
    case ExprKind::kSubtract:
      return "-";
    case ExprKind::kAnd:
      return "&";
    case ExprKind::kOr:
      return "|";
    case ExprKind::kAbs:
      return "ABS";
    case ExprKind::kMinimum:
      return "MINI";
    case ExprKind::kMaximum:
      return "MAXI";
    case ExprKind::kAverage:
      return "AVG";
  }
  PLCXX_UNREACHABLE();
}

constexpr std::string_view kRelations[] = {"=", "<>", "<", "<=", ">", ">="};

class SyntaxPrinter : dialects::SyntaxLines {
 public:
  SyntaxPrinter(const source::SourceManager& sources, const Program& program)
      : SyntaxLines(sources), program_(program) {}

  std::string Run() {
    for (const SizeInfo& size : SizeInfos()) {
      writer_.Line("size ", size.parameter, " ", std::to_string(program_.sizes.*size.member));
    }
    PrintPresets("timer", program_.timers);
    PrintPresets("monostable", program_.monostables);
    PrintPresets("counter", program_.counters);
    PrintPresets("IEC timer", program_.timers_iec);
    for (const auto& [number, section] : program_.sections) Print(section);
    for (const auto& [number, rung] : program_.rungs) Print(rung);
    for (const auto& [number, expression] : program_.comparisons) {
      writer_.Line("compare ", std::to_string(number), " ", Text(expression, true));
    }
    for (const auto& [number, expression] : program_.operations) {
      writer_.Line("operate ", std::to_string(number), " ", Text(expression, false));
    }
    PrintPages();
    for (const Symbol& symbol : program_.symbols) {
      const std::string name = NameOf(symbol.address);
      writer_.Line("symbol ", symbol.whole ? name.substr(0, name.find('.')) : name, " '", symbol.name, "' \"",
                   symbol.comment, "\"");
    }
    return writer_.Take();
  }

 private:
  static std::string Text(const Variable& variable) {
    const std::string name = "%" + NameOf(variable.address);
    return variable.index ? name + "[%" + NameOf(*variable.index) + "]" : name;
  }

  std::string Text(const Expression& expression, uint32_t node) const {
    const ExprNode& at = expression.nodes[node];
    if (at.kind == ExprKind::kConstant) return std::to_string(static_cast<int32_t>(at.value));
    if (at.kind == ExprKind::kVariable) return Text(at.variable);
    return dialects::PrefixForm(NameOfKind(at.kind), at.operands,
                                [&](uint32_t operand) { return Text(expression, operand); });
  }

  std::string Text(const Expression& expression, bool compares) const {
    if (expression.empty || expression.nodes.empty()) return "nothing";
    const auto whole = [&](uint32_t node) {
      return node < expression.nodes.size() ? Text(expression, node) : std::string("?");
    };
    if (!compares) return "(:= " + Text(expression.target) + " " + whole(expression.right) + ")";
    return "(" + std::string(kRelations[static_cast<size_t>(expression.relation)]) + " " + whole(expression.left) +
           " " + whole(expression.right) + ")";
  }

  void PrintPresets(std::string_view what, const std::map<uint32_t, Preset>& presets) {
    for (const auto& [number, preset] : presets) {
      if (preset.preset == 0) continue;
      std::string text = std::string(what) + " " + std::to_string(number) + " preset " + std::to_string(preset.preset);
      if (what != "counter") text += " of " + std::to_string(preset.base_ms) + " ms";
      constexpr std::string_view kModes[] = {"TON", "TOF", "TP"};
      if (what == "IEC timer") text += " " + std::string(kModes[static_cast<size_t>(preset.mode)]);
      Node(preset.range, text);
    }
  }

  void Print(const Section& section) {
    std::string text = "section " + std::to_string(section.number) + " '" + section.name + "'";
    if (!section.is_main()) text += " subroutine " + std::to_string(section.subroutine);
    if (section.language == Language::kSequential) {
      text += " page " + std::to_string(section.page);
    } else {
      text += " rungs " + std::to_string(section.first_rung) + " to " + std::to_string(section.last_rung);
    }
    Node(section.range, text);
  }

  void Print(const Rung& rung) {
    Node(rung.range, "rung ", std::to_string(rung.number), " next ", std::to_string(rung.next));
    const support::Indented deeper(writer_);
    for (uint32_t y = 0; y < kRungHeight; ++y) {
      for (uint32_t x = 0; x < kRungWidth; ++x) {
        const Element& element = rung.At(x, y);
        if (element.kind == ElementKind::kFree && !element.joined_above) continue;
        const ElementInfo& info = Info(element.kind);
        std::string text = std::to_string(x) + "," + std::to_string(y) + " " + std::string(info.name);
        if (UsesNumber(element.kind)) text += " " + std::to_string(element.number);
        if (UsesVariable(element.kind)) text += " " + Text(element.variable);
        if (element.joined_above) text += " joined";
        Node(element.range, text);
      }
    }
  }

  void PrintPages() {
    for (const auto& [index, step] : program_.steps) {
      Node(step.range, "step ", std::to_string(index), " number ", std::to_string(step.number), " page ",
           std::to_string(step.page), step.initial ? " initial" : "");
    }
    for (const auto& [index, transition] : program_.transitions) {
      std::string text = "transition " + std::to_string(index) + " page " + std::to_string(transition.page) + " if " +
                         Text(transition.condition) + " from";
      for (const uint32_t step : transition.deactivates) text += " " + std::to_string(step);
      text += " to";
      for (const uint32_t step : transition.activates) text += " " + std::to_string(step);
      Node(transition.range, text);
    }
  }

  const Program& program_;
};

}  // namespace

std::string PrintTokens(const source::SourceManager& sources, source::FileId file) {
  return dialects::TokenLines(sources, LinesOfProject(sources, file));
}

std::string PrintSyntax(const source::SourceManager& sources, const Program& program) {
  return SyntaxPrinter(sources, program).Run();
}

}  // namespace plcxx::classicladder
