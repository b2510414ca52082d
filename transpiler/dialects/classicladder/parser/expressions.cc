#include "transpiler/dialects/classicladder/parser/expressions.h"

#include <algorithm>
#include <optional>

#include "transpiler/dialects/classicladder/source/lines.h"

namespace plcxx::classicladder {
namespace {

bool IsCapital(char c) { return c >= 'A' && c <= 'Z'; }

uint32_t HexDigit(char c) {
  if (IsDigit(c)) return static_cast<uint32_t>(c - '0');
  return static_cast<uint32_t>((c | 0x20) - 'a') + 10;
}

bool IsHexDigit(char c) { return IsDigit(c) || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f'); }

struct FunctionRow {
  std::string_view name;
  ExprKind kind;
};
constexpr FunctionRow kFunctions[] = {{"ABS", ExprKind::kAbs},
                                      {"MINI", ExprKind::kMinimum},
                                      {"MAXI", ExprKind::kMaximum},
                                      {"MOY", ExprKind::kAverage},
                                      {"AVG", ExprKind::kAverage}};

struct OperatorRow {
  char sign;
  ExprKind kind;
  uint32_t level;
};
/// From the loosest to the tightest. '^' is read by Power, before the engine's own '^' for an exclusive or can see it.
constexpr OperatorRow kOperators[] = {{'|', ExprKind::kOr, 0},       {'&', ExprKind::kAnd, 1},
                                      {'+', ExprKind::kAdd, 2},      {'-', ExprKind::kSubtract, 2},
                                      {'*', ExprKind::kMultiply, 3}, {'/', ExprKind::kDivide, 3},
                                      {'%', ExprKind::kModulo, 3}};
constexpr uint32_t kTightest = 4;

/// Reads one text. After the first fault nothing more is said of it.
class Reader {
 public:
  Reader(std::string_view text, source::Offset begin, LinuxCnc version, Expression& into, diag::Engine& diagnostics)
      : text_(text), begin_(begin), version_(version), into_(into), diagnostics_(diagnostics) {}

  bool faulty() const { return faulty_; }
  bool AtEnd() const { return at_ >= text_.size(); }
  char Peek() const { return AtEnd() ? '\0' : text_[at_]; }
  void Skip() { ++at_; }
  source::Range From(size_t first) const {
    return {begin_ + static_cast<source::Offset>(first), begin_ + static_cast<source::Offset>(at_)};
  }

  void Expected(std::string_view what) {
    if (faulty_) return;
    faulty_ = true;
    const source::Offset place = begin_ + static_cast<source::Offset>(std::min(at_, text_.size()));
    const std::string found = AtEnd() ? "the end" : "'" + std::string(1, Peek()) + "'";
    diagnostics_.Report({place, place + (AtEnd() ? 0 : 1)}, diag::ClassicladderExpected, what, found);
  }

  /// All of the text; what the engine does not look at any more gets a warning.
  uint32_t Whole() {
    const uint32_t node = Level(0);
    if (!faulty_ && !AtEnd() && text_.find_first_not_of(' ', at_) != std::string_view::npos) {
      const size_t first = at_;
      at_ = text_.size();
      diagnostics_.Report(From(first), diag::ClassicladderTextIgnored, text_.substr(first));
    }
    return node;
  }

  /// "@200/0@" or "@200/0[200/9]@".
  Variable ReadVariable() {
    Variable variable;
    const size_t first = at_;
    if (Peek() != '@') {
      Expected("a variable such as @200/0@");
      return variable;
    }
    Skip();
    ReadAddress(variable.address);
    if (!faulty_ && Peek() == '[') {
      Skip();
      Address index;
      ReadAddress(index);
      variable.index = index;
      if (!faulty_ && Peek() != ']') Expected("']'");
      if (!faulty_) Skip();
    }
    if (!faulty_ && Peek() != '@') Expected("'@'");
    if (!faulty_) Skip();
    variable.range = From(first);
    return variable;
  }

 private:
  uint32_t Add(ExprNode node) {
    into_.nodes.push_back(std::move(node));
    return static_cast<uint32_t>(into_.nodes.size() - 1);
  }

  std::optional<uint32_t> Digits() {
    if (!IsDigit(Peek())) return std::nullopt;
    uint32_t value = 0;
    constexpr uint32_t kMost = 1'000'000;
    for (; IsDigit(Peek()); Skip()) value = std::min(kMost, 10 * value + static_cast<uint32_t>(Peek() - '0'));
    return value;
  }

  void ReadAddress(Address& address) {
    const size_t first = at_;
    const auto type = Digits();
    if (!type) return Expected("the type of a variable");
    if (Peek() != '/') return Expected("'/'");
    const auto kind = VariableByNumber(*type, version_);
    if (!kind) {
      faulty_ = true;
      diagnostics_.Report(From(first), diag::ClassicladderVariableType, std::to_string(*type));
      return;
    }
    Skip();
    const auto number = Digits();
    if (!number) return Expected("the number of a variable");
    address = {*kind, *number};
  }

  uint32_t Constant() {
    const size_t first = at_;
    const bool negative = Peek() == '-';
    if (negative) Skip();
    uint32_t value = 0;
    if (Peek() == '$') {
      Skip();
      if (!IsHexDigit(Peek())) Expected("a hexadecimal digit");
      for (; IsHexDigit(Peek()); Skip()) value = 16 * value + HexDigit(Peek());
    } else if (Peek() == '\'') {
      Skip();
      // A byte above 127 counts as negative, as the engine's characters do.
      for (; !AtEnd() && Peek() != '\''; Skip()) {
        value = 256 * value + static_cast<uint32_t>(static_cast<int32_t>(static_cast<signed char>(Peek())));
      }
      if (AtEnd()) Expected("a closing apostrophe");
      Skip();
    } else if (IsDigit(Peek())) {
      for (; IsDigit(Peek()); Skip()) value = 10 * value + static_cast<uint32_t>(Peek() - '0');
    } else if (!faulty_) {
      faulty_ = true;
      diagnostics_.Report(From(first), diag::ClassicladderSignOfVariable);
    }
    return Add({.kind = ExprKind::kConstant,
                .value = negative ? 0 - value : value,
                .variable = {},
                .operands = {},
                .range = From(first)});
  }

  uint32_t VariableNode() {
    const size_t first = at_;
    const Variable variable = ReadVariable();
    return Add({.kind = ExprKind::kVariable, .variable = variable, .operands = {}, .range = From(first)});
  }

  uint32_t Function() {
    const size_t first = at_;
    while (IsCapital(Peek())) Skip();
    const std::string_view name = text_.substr(first, at_ - first);
    const auto row = std::ranges::find(kFunctions, name, &FunctionRow::name);
    if (row == std::end(kFunctions)) {
      if (!faulty_) diagnostics_.Report(From(first), diag::ClassicladderFunction, name);
      faulty_ = true;
      return 0;
    }
    ExprNode node{.kind = row->kind, .variable = {}, .operands = {}, .range = {}};
    if (Peek() != '(') Expected("'('");
    do {
      if (faulty_) return 0;
      Skip();
      node.operands.push_back(VariableNode());
    } while (Peek() == ',' && row->kind != ExprKind::kAbs);
    if (Peek() != ')') Expected(row->kind == ExprKind::kAbs ? "')'" : "',' or ')'");
    Skip();
    node.range = From(first);
    return Add(std::move(node));
  }

  uint32_t Term() {
    if (faulty_) return 0;
    const size_t first = at_;
    if (Peek() == '(') {
      Skip();
      const uint32_t inside = Level(0);
      if (Peek() != ')') Expected("')'");
      Skip();
      return inside;
    }
    if (Peek() == '!') {
      Skip();
      const uint32_t operand = Term();
      return Add({.kind = ExprKind::kNot, .variable = {}, .operands = {operand}, .range = From(first)});
    }
    const bool characters = Peek() == '\'' && version_ != LinuxCnc::kTwoNine;
    if (IsDigit(Peek()) || Peek() == '$' || Peek() == '-' || characters) return Constant();
    if (IsCapital(Peek())) return Function();
    if (Peek() == '@') return VariableNode();
    Expected("a constant, a variable, a function or '('");
    return 0;
  }

  uint32_t Power() {
    const size_t first = at_;
    const uint32_t left = Term();
    if (faulty_ || Peek() != '^') return left;
    Skip();
    const uint32_t right = Power();
    if (!faulty_) diagnostics_.Report(From(first), diag::ClassicladderPower);
    return Add({.kind = ExprKind::kPower, .variable = {}, .operands = {left, right}, .range = From(first)});
  }

  uint32_t Level(uint32_t level) {
    if (level == kTightest) return Power();
    const size_t first = at_;
    uint32_t left = Level(level + 1);
    while (!faulty_) {
      const auto row = std::ranges::find_if(
          kOperators, [&](const OperatorRow& each) { return each.level == level && each.sign == Peek(); });
      if (row == std::end(kOperators)) break;
      Skip();
      const uint32_t right = Level(level + 1);
      left = Add({.kind = row->kind, .variable = {}, .operands = {left, right}, .range = From(first)});
    }
    return left;
  }

  std::string_view text_;
  source::Offset begin_;
  LinuxCnc version_;
  Expression& into_;
  diag::Engine& diagnostics_;
  size_t at_ = 0;
  bool faulty_ = false;
};

bool IsEmpty(std::string_view text) { return text.empty() || text.front() == '#'; }

}  // namespace

Expression ParseComparison(const ExpressionText& text, LinuxCnc version, diag::Engine& diagnostics) {
  Expression comparison;
  comparison.empty = IsEmpty(text.text);
  if (comparison.empty) return comparison;
  // The first sign cuts the text, whatever is around it; '=' or '>' after it belongs to it.
  const size_t sign = std::min(text.text.find_first_of("<>="), text.text.size());
  Reader left(text.text.substr(0, sign), text.range.begin, version, comparison, diagnostics);
  comparison.left = left.Whole();
  if (left.faulty()) return comparison;
  if (sign == text.text.size()) {
    diagnostics.Report({text.range.end, text.range.end}, diag::ClassicladderExpected, "'<', '>' or '='", "the end");
    return comparison;
  }
  const char first = text.text[sign], second = sign + 1 < text.text.size() ? text.text[sign + 1] : '\0';
  const size_t length = second == '=' || second == '>' ? 2 : 1;
  if (first == '=') {
    comparison.relation = Relation::kEqual;
  } else if (first == '<' && second == '>') {
    comparison.relation = Relation::kNotEqual;
  } else if (first == '<') {
    comparison.relation = second == '=' ? Relation::kLessEqual : Relation::kLess;
  } else {
    comparison.relation = second == '=' ? Relation::kGreaterEqual : Relation::kGreater;
  }
  Reader right(text.text.substr(sign + length), text.range.begin + static_cast<source::Offset>(sign + length), version,
               comparison, diagnostics);
  comparison.right = right.Whole();
  return comparison;
}

Expression ParseOperation(const ExpressionText& text, LinuxCnc version, diag::Engine& diagnostics) {
  Expression operation;
  operation.empty = IsEmpty(text.text);
  if (operation.empty) return operation;
  Reader head(text.text, text.range.begin, version, operation, diagnostics);
  operation.target = head.ReadVariable();
  while (!head.faulty() && head.Peek() != '=') {
    if (head.Peek() == ':' || head.Peek() == ' ') {
      head.Skip();
    } else {
      head.Expected("':='");
    }
  }
  if (head.faulty()) return operation;
  const size_t equals = text.text.find('=');
  const size_t begin = std::min(text.text.find_first_not_of(' ', equals + 1), text.text.size());
  Reader right(text.text.substr(begin), text.range.begin + static_cast<source::Offset>(begin), version, operation,
               diagnostics);
  operation.right = right.Whole();
  return operation;
}

}  // namespace plcxx::classicladder
