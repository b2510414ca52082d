#include "transpiler/dialects/classicladder/machine/elements.h"

#include <algorithm>
#include <charconv>

#include "transpiler/dialects/classicladder/machine/machine.h"

namespace plcxx::classicladder {
namespace {

std::string_view Trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

/// What is in front of the separator; the rest stays in `text`.
std::string_view TakeUntil(std::string_view& text, char separator) {
  const size_t end = text.find(separator);
  const std::string_view taken = text.substr(0, end);
  text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  return taken;
}

std::optional<uint32_t> Number(std::string_view text) {
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// "50/3" as "%I3".
std::string VariableText(std::string_view text) {
  const std::string_view type = TakeUntil(text, '/');
  const auto kind_number = Number(type), number = Number(text);
  if (!kind_number || !number) return "?";
  const auto kind = VariableByNumber(*kind_number, LinuxCnc::kTwoNine);
  return kind ? "%" + NameOf({*kind, *number}) : "?";
}

/// "-|/|-" with what is in the middle in front of the variable: "/%I3"; "-(S)-" as "(S%Q1)".
std::string DrawnWith(std::string_view drawn, const std::string& variable) {
  const std::string sign = drawn[2] == ' ' ? "" : std::string(1, drawn[2]);
  return drawn[1] == '(' ? "(" + sign + variable + ")" : sign + variable;
}

std::string ElementInWords(ElementKind kind, const ElementText& split) {
  if (kind == ElementKind::kFree || kind == ElementKind::kWire || kind == ElementKind::kPart) return {};
  const std::string_view drawn = Info(kind).drawn;
  std::string variable = UsesVariable(kind) ? VariableText(split.variable) : std::string();
  if (!split.index.empty()) variable += "[" + VariableText(split.index) + "]";
  std::string_view number = split.variable;
  TakeUntil(number, '/');
  if (UsesVariable(kind)) return DrawnWith(drawn, variable);
  if (drawn.starts_with('-')) return DrawnWith(drawn, std::string(number));
  return std::string(drawn) + " " + std::string(number);
}

std::string RowText(std::string_view row) {
  std::string text;
  const auto add = [&text](std::string_view word) {
    if (!word.empty()) text += (text.empty() ? "" : " ") + std::string(word);
  };
  while (!row.empty()) {
    const auto split = SplitElement(Trimmed(TakeUntil(row, ',')));
    if (!split) return {};
    const auto number = Number(split->type);
    const auto kind = number ? ElementByNumber(*number) : std::nullopt;
    if (split->joined != "0") add("+");
    if (kind) add(ElementInWords(*kind, *split));
  }
  return text;
}

/// "@200/3[200/9]@>=5" as "%W3[%W9]>=5".
std::string ExpressionInWords(std::string_view text) {
  std::string words;
  while (!text.empty()) {
    words += TakeUntil(text, '@');
    if (text.empty()) break;
    std::string_view variable = TakeUntil(text, '@');
    std::string_view index = variable;
    variable = TakeUntil(index, '[');
    words += VariableText(variable);
    if (!index.empty()) words += "[" + VariableText(TakeUntil(index, ']')) + "]";
  }
  return words;
}

/// Ten numbers of steps, of which those before the first -1 count.
std::string StepsInWords(std::string_view& fields) {
  std::string words;
  bool counts = true;
  for (uint32_t i = 0; i < kSwitches; ++i) {
    const std::string_view step = Trimmed(TakeUntil(fields, ','));
    counts = counts && !step.starts_with('-');
    if (counts) words += (words.empty() ? "S" : ", S") + std::string(step);
  }
  return words.empty() ? "nothing" : words;
}

/// "S1,1,2,0,1,3" as "S1: %X2, initial", "T1,3,-1,...,1,2,-1..." as "T1: S1, S2 -> S3", "C1,0,50/1" as "C1: %I1"; else
/// nothing.
std::string SequentialInWords(std::string_view line) {
  std::string_view fields = line;
  const std::string name(TakeUntil(fields, ','));
  if (name.size() < 2 || !Number(std::string_view(name).substr(1))) return {};
  if (name.front() == 'C') {
    TakeUntil(fields, ',');
    return name + ": " + VariableText(Trimmed(fields));
  }
  if (name.front() == 'S') {
    const bool is_initial = Number(Trimmed(TakeUntil(fields, ','))).value_or(0) != 0;
    return name + ": %X" + std::string(Trimmed(TakeUntil(fields, ','))) + (is_initial ? ", initial" : "");
  }
  if (name.front() != 'T') return {};
  const std::string begins = StepsInWords(fields);
  return name + ": " + StepsInWords(fields) + " -> " + begins;
}

/// "0007,@270/0@<5" and "@270/0@<5" as "%IW0<5"; else nothing.
std::string ExpressionLineInWords(std::string_view line) {
  constexpr size_t kDigits = 4;
  const bool numbered = line.size() > kDigits && line[kDigits] == ',' && Number(line.substr(0, kDigits));
  if (!numbered && line.find('@') == std::string_view::npos) return {};
  if (numbered) line.remove_prefix(kDigits + 1);
  return ExpressionInWords(Trimmed(line));
}

}  // namespace

std::optional<ElementText> SplitElement(std::string_view text) {
  const size_t first = text.find('-');
  if (first == std::string_view::npos) return std::nullopt;
  const size_t second = text.find('-', first + 1);
  if (second == std::string_view::npos) return std::nullopt;
  ElementText split{text.substr(0, first), text.substr(first + 1, second - first - 1), text.substr(second + 1), {}};
  const size_t bracket = split.variable.find('[');
  if (bracket == std::string_view::npos) return split;
  if (split.variable.back() != ']') return std::nullopt;
  split.index = split.variable.substr(bracket + 1, split.variable.size() - bracket - 2);
  split.variable = split.variable.substr(0, bracket);
  return split;
}

std::string StatementText(std::string_view source) {
  std::string text;
  for (std::string_view rest = source; !rest.empty();) {
    const std::string row = RowText(Trimmed(TakeUntil(rest, '\n')));
    if (!row.empty()) text += (text.empty() ? "" : "; ") + row;
  }
  if (!text.empty()) return text;
  if (std::string words = SequentialInWords(source); !words.empty()) return words;
  if (std::string words = ExpressionLineInWords(source); !words.empty()) return words;
  constexpr auto kSectionSeparators = 5;
  const bool wires_alone = SplitElement(Trimmed(source.substr(0, source.find(',')))).has_value();
  if (wires_alone || std::ranges::count(source, ',') != kSectionSeparators) return std::string(source);
  return "page " + std::string(Trimmed(source.substr(source.rfind(',') + 1)));
}

}  // namespace plcxx::classicladder
