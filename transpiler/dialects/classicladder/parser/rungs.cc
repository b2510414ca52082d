// Parts rung_N.csv: directives, then a line for each row with its elements from left to right.

#include "transpiler/dialects/classicladder/machine/elements.h"
#include "transpiler/dialects/classicladder/parser/internal.h"

namespace plcxx::classicladder {
namespace {

/// "#NAME=": what is behind it; none when the line is another directive.
std::optional<Field> ValueOf(const Line& line, std::string_view name) {
  if (!line.text.starts_with(name)) return std::nullopt;
  return Field{line.text.substr(name.size()),
               {line.range.begin + static_cast<source::Offset>(name.size()), line.range.end}};
}

}  // namespace

void Parser::ParseDirective(const Line& line, Rung& rung) {
  if (const auto label = ValueOf(line, "#LABEL=")) {
    rung.label = label->text;
    if (!label->text.empty()) rung.label_range = label->range;
  } else if (const auto comment = ValueOf(line, "#COMMENT=")) {
    if (!comment->text.empty()) rung.comment_range = comment->range;
  } else if (const auto next = ValueOf(line, "#NEXTRUNG=")) {
    ReadNumberIn(*next, "next rung", -1, static_cast<int32_t>(program_.sizes.rungs) - 1, rung.next);
  }
}

void Parser::ParseElement(const Field& field, uint32_t x, uint32_t y, Rung& rung) {
  Element& element = rung.rows[y][x];
  element.range = field.range;
  const auto split = SplitElement(field.text);
  int32_t type = 0, joined = 0;
  if (!split) {
    diagnostics_.Report(field.range, diag::ClassicladderElementForm, field.text);
    return;
  }
  if (!ReadNumber({split->type, field.range}, "a type", type)) return;
  if (!ReadNumber({split->joined, field.range}, "0 or 1, whether it is joined with the row above,", joined)) return;
  element.joined_above = joined != 0 && y > 0;
  const auto kind = type < 0 ? std::nullopt : ElementByNumber(static_cast<uint32_t>(type));
  if (!kind) {
    if (type >= 0 && IsEditorsLeftover(static_cast<uint32_t>(type))) {
      diagnostics_.Report(field.range, diag::ClassicladderLeftover, split->type);
    } else {
      diagnostics_.Report(field.range, diag::ClassicladderElementUnknown, split->type);
    }
    return;
  }
  element.kind = *kind;
  const ElementInfo& info = Info(*kind);
  if (x < info.left || y + info.below >= kRungHeight) {
    diagnostics_.Report(field.range, diag::ClassicladderElementOutside, info.drawn, int64_t{x} + 1, int64_t{y} + 1);
  }
  if (*kind != ElementKind::kFree && *kind != ElementKind::kPart) ++program_.element_count;
  element.variable.range = field.range;
  if (UsesVariable(*kind)) {
    ReadVariable(split->variable, field.range, element.variable.address);
    if (!split->index.empty() && program_.sizes.version == LinuxCnc::kTwoNine) {
      diagnostics_.Report(field.range, diag::ClassicladderIndexIgnored, field.text);
    } else if (!split->index.empty()) {
      Address index;
      if (ReadVariable(split->index, field.range, index)) element.variable.index = index;
    }
  } else if (UsesNumber(*kind)) {
    const size_t slash = split->variable.find('/');
    int32_t number = 0;
    if (slash == std::string_view::npos) {
      diagnostics_.Report(field.range, diag::ClassicladderElementForm, field.text);
    } else if (ReadNumberIn({split->variable.substr(slash + 1), field.range}, "number", 0, 1'000'000, number)) {
      element.number = static_cast<uint32_t>(number);
    }
  }
}

void Parser::ParseRow(const Line& line, Rung& rung) {
  const auto y = static_cast<uint32_t>(rung.lines.size());
  if (y == kRungHeight) {
    diagnostics_.Report(line.range, diag::ClassicladderTooMany, kRungHeight, "rows in a rung");
    return;
  }
  rung.lines.push_back(line.range);
  const std::vector<Field> fields = FieldsOf(line);
  for (uint32_t x = 0; x < fields.size(); ++x) {
    if (x == kRungWidth) {
      diagnostics_.Report(fields[x].range, diag::ClassicladderTooMany, kRungWidth, "elements in a row");
      return;
    }
    ParseElement(fields[x], x, y, rung);
  }
}

void Parser::ParseRung(const FilePart& part) {
  if (part.rung >= program_.sizes.rungs) {
    diagnostics_.Report(part.range, diag::ClassicladderRange, "rung", std::to_string(part.rung), "0",
                        std::to_string(program_.sizes.rungs - 1));
    return;
  }
  Rung& rung = program_.rungs[part.rung];
  rung.number = part.rung;
  rung.range = part.range;
  bool more = true;
  for (const Line& line : part.lines) {
    if (line.kind == LineKind::kComment) continue;
    if (line.kind == LineKind::kDirective) {
      if (!CheckVersion(part, line, 2)) return;
      ParseDirective(line, rung);
    } else if (more) {
      more = rung.lines.size() < kRungHeight;
      ParseRow(line, rung);
    }
  }
}

}  // namespace plcxx::classicladder
