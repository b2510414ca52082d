#include "transpiler/dialects/classicladder/parser/parser.h"

#include <set>

#include "transpiler/dialects/classicladder/parser/checks.h"
#include "transpiler/dialects/classicladder/parser/internal.h"
#include "transpiler/support/check.h"

namespace plcxx::classicladder {

std::vector<FilePart> Parser::SplitParts(const std::vector<Line>& lines) {
  std::vector<FilePart> parts;
  std::set<std::string_view> names;
  bool open = false;
  for (const Line& line : lines) {
    if (line.text.size() > kMostLine) {
      diagnostics_.Report(line.range, diag::ClassicladderLineLong, static_cast<int64_t>(line.text.size()));
    }
    if (line.kind == LineKind::kPart) {
      FilePart part{.name = PartName(line), .range = line.range};
      if (open) diagnostics_.Report(line.range, diag::ClassicladderPartInside, part.name, parts.back().name);
      if (!names.insert(part.name).second) diagnostics_.Report(line.range, diag::ClassicladderPartTwice, part.name);
      part.kind = PartByName(part.name, part.rung);
      parts.push_back(std::move(part));
      open = true;
    } else if (line.kind == LineKind::kPartEnd) {
      if (!open) {
        diagnostics_.Report(line.range, diag::ClassicladderOutsideParts, line.text);
      } else if (parts.back().lines.empty()) {
        diagnostics_.Report(line.range, diag::ClassicladderPartEmpty, parts.back().name);
      }
      open = false;
    } else if (open) {
      // The engine passes over blank lines until the part has a line.
      if (line.kind != LineKind::kBlank || !parts.back().lines.empty()) parts.back().lines.push_back(line);
    } else if (line.kind != LineKind::kBlank && line.kind != LineKind::kProjectEnd) {
      diagnostics_.Report(line.range, diag::ClassicladderOutsideParts, line.text);
    }
  }
  if (open) diagnostics_.Report(parts.back().range, diag::ClassicladderPartOpen, parts.back().name);
  return parts;
}

/// Before everything else: the sizes bound the other parts.
void Parser::ReadSizes(const std::vector<FilePart>& parts) {
  program_.sizes.version = settings_.sizes.version;
  for (const FilePart& part : parts) {
    if (part.kind != PartKind::kGeneral) continue;
    for (const Line& line : part.lines) {
      for (const SizeInfo& size : SizeInfos()) {
        if (size.line.empty() || !line.text.starts_with(size.line)) continue;
        const size_t equals = size.line.size();
        if (line.text.size() <= equals || line.text[equals] != '=') continue;
        const Field field{line.text.substr(equals + 1),
                          {line.range.begin + static_cast<source::Offset>(equals + 1), line.range.end}};
        int32_t value = 0;
        constexpr int32_t kMostSize = 10'000;
        if (ReadNumberIn(field, size.meaning, 1, kMostSize, value))
          program_.sizes.*size.member = static_cast<uint32_t>(value);
      }
    }
  }
  for (const SizeInfo& size : SizeInfos()) {
    const auto given = settings_.given.find(std::string(size.parameter));
    if (given != settings_.given.end() && given->second) program_.sizes.*size.member = settings_.sizes.*size.member;
  }
}

bool Parser::CheckVersion(const FilePart& part, const Line& directive, int32_t newest) {
  constexpr std::string_view kVersion = "#VER=";
  if (!directive.text.starts_with(kVersion)) return true;
  const std::string_view text = directive.text.substr(kVersion.size());
  int32_t version = 0;
  const Field field{text.substr(0, text.find('.')), directive.range};
  if (!ReadNumber(field, "a version", version)) return false;
  if (version <= newest) return true;
  // One message for all parts: a project of ClassicLadder 0.9 has dozens.
  if (!std::exchange(is_newer_, true))
    diagnostics_.Report(directive.range, diag::ClassicladderVersion, text, part.name);
  return false;
}

void Parser::ParsePart(const FilePart& part) {
  const Sizes& sizes = program_.sizes;
  switch (part.kind) {
    case PartKind::kGeneral:
      return;  // read before
    case PartKind::kTimers:
      return ParsePresets(part, program_.timers, sizes.timers, "timers");
    case PartKind::kMonostables:
      return ParsePresets(part, program_.monostables, sizes.monostables, "monostables");
    case PartKind::kCounters:
      return ParsePresets(part, program_.counters, sizes.counters, "counters");
    case PartKind::kTimersIec:
      return ParsePresets(part, program_.timers_iec, sizes.timers_iec, "IEC timers");
    case PartKind::kExpressions:
      return ParseExpressions(part);
    case PartKind::kSections:
      return ParseSections(part);
    case PartKind::kSequential:
      return ParseSequential(part);
    case PartKind::kSymbols:
      return ParseSymbols(part);
    case PartKind::kRung:
      return ParseRung(part);
    case PartKind::kIgnored:
      for (const Line& line : part.lines) {
        if (line.kind != LineKind::kData || line.text.starts_with("MODBUS_")) continue;
        diagnostics_.Report(part.range, diag::ClassicladderPartIgnored, part.name);
        return;
      }
      return;
  }
  PLCXX_UNREACHABLE();
}

void Parser::ParseFile(source::FileId file) {
  const std::vector<Line> lines = LinesOfProject(sources_, file);
  program_.line_count += static_cast<uint32_t>(lines.size());
  const source::Range first =
      lines.empty() ? source::Range{sources_.Get(file).base, sources_.Get(file).base} : lines.front().range;
  if (std::exchange(has_project_, true)) {
    diagnostics_.Report(first, diag::ClassicladderTwoProjects);
    return;
  }
  if (lines.empty() || lines.front().kind != LineKind::kProject) {
    diagnostics_.Report(first, diag::ClassicladderNoProject);
    return;
  }
  const size_t errors = diagnostics_.error_count();
  const std::vector<FilePart> parts = SplitParts({lines.begin() + 1, lines.end()});
  const bool whole = diagnostics_.error_count() == errors;  // else the part may be inside another one
  ReadSizes(parts);
  bool has_sections = false;
  for (const FilePart& part : parts) {
    has_sections = has_sections || part.kind == PartKind::kSections;
    ParsePart(part);
  }
  if (!has_sections && whole) diagnostics_.Report(first, diag::ClassicladderNoSections);
  for (auto& [number, section] : program_.sections) {
    const auto name = section_names_.find(number);
    section.name = name == section_names_.end() ? std::to_string(number) : name->second;
  }
}

Program Parse(const source::SourceManager& sources, std::span<const source::FileId> files, const Settings& settings,
              diag::Engine& diagnostics) {
  Parser parser(sources, settings, diagnostics);
  for (const source::FileId file : files) parser.ParseFile(file);
  Program program = parser.Take();
  CheckProgram(program, settings, diagnostics);
  return program;
}

}  // namespace plcxx::classicladder
