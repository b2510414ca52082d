// Parts that are lists: presets, expressions, sections, symbols.

#include <algorithm>

#include "transpiler/dialects/classicladder/parser/internal.h"

namespace plcxx::classicladder {
namespace {

constexpr uint32_t kBases[] = {60'000, 1'000, 100};  // minutes, seconds, 100 ms
constexpr size_t kSectionNameAt = 9;                 // "#NAME000=": the engine counts characters
constexpr size_t kExpressionAt = 5;                  // "0000,": likewise

}  // namespace

/// A line for each, from number 0 on: "base,preset", of IEC timers "base,preset,mode", of counters "preset".
void Parser::ParsePresets(const FilePart& part, std::map<uint32_t, Preset>& into, uint32_t count,
                          std::string_view what) {
  const bool counters = part.kind == PartKind::kCounters, iec = part.kind == PartKind::kTimersIec;
  uint32_t number = 0;
  for (const Line& line : part.lines) {
    if (line.kind == LineKind::kComment) continue;
    // The author's ClassicLadder 0.9 (.clprj) has a version here, and numbers in front: "T0,1,5".
    if (line.kind == LineKind::kDirective && !CheckVersion(part, line, 0)) return;
    if (number == count) {
      diagnostics_.Report(line.range, diag::ClassicladderTooMany, static_cast<int64_t>(count), what);
      return;
    }
    Preset& preset = into[number++];
    preset.range = line.range;
    const std::vector<Field> fields = FieldsOf(line);
    if (counters) {
      if (HasFields(fields, 1, line, "preset")) ReadNumber(fields[0], "a preset", preset.preset);
      continue;
    }
    if (!HasFields(fields, iec ? 3 : 2, line, iec ? "base, preset, mode" : "base, preset")) continue;
    int32_t base = 1, mode = 0;
    if (!ReadNumberIn(fields[0], "time base", 0, 2, base)) continue;
    preset.base_ms = kBases[base];
    const int32_t most = iec ? 0x7FFFFFFF : 0x7FFFFFFF / static_cast<int32_t>(preset.base_ms);
    ReadNumberIn(fields[1], "preset", iec ? -0x7FFFFFFF : -most, most, preset.preset);
    if (iec && ReadNumberIn(fields[2], "timer mode", 0, 2, mode)) preset.mode = static_cast<TimerMode>(mode);
  }
}

/// A line that begins with a digit has its number in front; other ones are counted, blank ones too.
void Parser::ParseExpressions(const FilePart& part) {
  uint32_t number = 0;
  for (const Line& line : part.lines) {
    if (line.kind == LineKind::kComment || line.kind == LineKind::kDirective) continue;
    std::string_view text = line.text;
    source::Range range = line.range;
    const bool numbered = !text.empty() && IsDigit(text.front());
    if (numbered) {
      const size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
      if (end != kExpressionAt - 1 || end >= text.size() || text[end] != ',') {
        diagnostics_.Report(line.range, diag::ClassicladderLine, text, part.name);
        continue;
      }
      const Field field{text.substr(0, end), {range.begin, range.begin + static_cast<source::Offset>(end)}};
      if (!ReadIndex(field, "expression", program_.sizes.expressions, number)) continue;
      text.remove_prefix(kExpressionAt);
      range.begin += kExpressionAt;
    } else if (number == program_.sizes.expressions) {
      diagnostics_.Report(line.range, diag::ClassicladderTooMany, static_cast<int64_t>(number), "expressions");
      return;
    }
    const bool too_long = text.size() > kMostExpression;
    if (too_long) diagnostics_.Report(range, diag::ClassicladderExpressionLong, static_cast<int64_t>(text.size()));
    program_.expressions[number] = {text, range, too_long};
    if (!numbered) ++number;
  }
}

void Parser::ParseSectionName(const Line& line) {
  const bool has_name = line.text.size() >= kSectionNameAt && line.text[kSectionNameAt - 1] == '=' &&
                        std::ranges::all_of(line.text.substr(5, 3), IsDigit);
  if (!has_name) {
    diagnostics_.Report(line.range, diag::ClassicladderLine, line.text, "sections.csv");
    return;
  }
  const Field field{line.text.substr(5, 3), {line.range.begin + 5, line.range.begin + 8}};
  uint32_t number = 0;
  constexpr size_t kMostName = 19;
  if (ReadIndex(field, "section", program_.sizes.sections, number)) {
    section_names_[number] = line.text.substr(kSectionNameAt, kMostName);
  }
}

void Parser::ParseSection(const Line& line) {
  const std::vector<Field> fields = FieldsOf(line);
  if (!HasFields(fields, 6, line, "number, language, subroutine, first rung, last rung, page")) return;
  Section section{.range = line.range};
  int32_t language = 0;
  if (!ReadIndex(fields[0], "section", program_.sizes.sections, section.number)) return;
  if (!ReadNumberIn(fields[1], "language", 0, 1, language)) return;
  section.language = static_cast<Language>(language);
  constexpr int32_t kMostSubroutine = 9999;
  if (!ReadNumberIn(fields[2], "subroutine", -1, kMostSubroutine, section.subroutine)) return;
  if (section.language == Language::kSequential) {
    if (!ReadIndex(fields[5], "page", kPages, section.page)) return;
  } else {
    const uint32_t rungs = program_.sizes.rungs;
    if (!ReadIndex(fields[3], "rung", rungs, section.first_rung)) return;
    if (!ReadIndex(fields[4], "rung", rungs, section.last_rung)) return;
  }
  program_.sections[section.number] = section;
}

void Parser::ParseSections(const FilePart& part) {
  for (const Line& line : part.lines) {
    if (line.kind == LineKind::kComment) continue;
    if (line.kind != LineKind::kDirective) {
      ParseSection(line);
    } else if (line.text.starts_with("#NAME")) {
      ParseSectionName(line);
    } else if (!CheckVersion(part, line, 1)) {
      return;
    }
  }
}

void Parser::ParseSymbols(const FilePart& part) {
  for (const Line& line : part.lines) {
    if (line.kind == LineKind::kComment) continue;
    if (line.kind == LineKind::kDirective) {
      if (!CheckVersion(part, line, 1)) return;
      continue;
    }
    const std::vector<Field> fields = FieldsOf(line);
    if (fields.size() < 2) {
      diagnostics_.Report(line.range, diag::ClassicladderLine, line.text, part.name);
      continue;
    }
    Symbol symbol{.address = {}, .name = std::string(fields[1].text), .comment = {}};
    if (fields.size() > 2) symbol.comment = line.text.substr(fields[2].range.begin - line.range.begin);
    const std::string_view variable = fields[0].text;
    auto address = AddressByName(variable);
    if (!address && variable.starts_with('%')) {
      // "%T0" is a timer as a whole, "%X0" a step.
      for (const VariableInfo& info : Variables()) {
        if (address) break;
        address = AddressByName(std::string(variable) + "." + std::string(info.attribute));
        symbol.whole = address.has_value();
      }
    }
    if (symbol.name.empty() || symbol.name == variable) continue;
    if (!address || !variable.starts_with('%')) {
      diagnostics_.Report(fields[0].range, diag::ClassicladderSymbolDropped, fields[1].text,
                          "'" + std::string(variable) + "' is no variable");
      continue;
    }
    if (symbol.name.size() > kMostSymbol || variable.size() > kMostSymbol) {
      diagnostics_.Report(fields[1].range, diag::ClassicladderSymbolDropped, fields[1].text, "it is too long");
      continue;
    }
    symbol.address = *address;
    program_.symbols.push_back(std::move(symbol));
  }
}

}  // namespace plcxx::classicladder
