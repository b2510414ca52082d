#include "transpiler/dialects/classicladder/source/elsewhere.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "transpiler/dialects/classicladder/machine/elements.h"
#include "transpiler/dialects/classicladder/machine/machine.h"
#include "transpiler/dialects/classicladder/source/lines.h"

namespace plcxx::classicladder {
namespace {

using Ranges = std::vector<source::Range>;

constexpr size_t kSectionFields = 6, kPageAt = 5;
constexpr size_t kStepFields = 6, kStepPageAt = 3, kTransitionFields = 44, kTransitionPageAt = 41;

std::optional<uint32_t> NumberAt(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  return number;
}

std::vector<std::string_view> FieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (size_t end = line.find(','); end != std::string_view::npos; end = line.find(',')) {
    fields.push_back(line.substr(0, end));
    line.remove_prefix(end + 1);
  }
  fields.push_back(line);
  return fields;
}

/// The lines of one project, by what refers to them.
struct Project {
  std::map<std::pair<PartKind, uint32_t>, source::Range> numbered;  // expressions and presets
  std::map<uint32_t, Ranges> steps, transitions;                    // by page
  std::map<uint32_t, source::Range> conditions;                     // by transition
};

/// Where a step or transition is drawn, its last two fields, is not what it does.
source::Range WithoutCoordinates(const Line& line) {
  source::Range range = line.range;
  size_t end = line.text.size();
  for (int i = 0; i < 2; ++i) end = line.text.rfind(',', end - 1);
  range.end = range.begin + static_cast<uint32_t>(end);
  return range;
}

void AddSequential(const Line& line, Project& project, std::map<uint32_t, uint32_t>& transition_at) {
  const std::vector<std::string_view> fields = FieldsOf(line.text.substr(1));
  const auto number = NumberAt(fields.front());
  if (!number) return;
  const char letter = line.text.front();
  if (letter == 'C') project.conditions[*number] = line.range;
  if (letter == 'S' && fields.size() >= kStepFields) {
    if (const auto page = NumberAt(fields[kStepPageAt])) project.steps[*page].push_back(WithoutCoordinates(line));
  }
  if (letter != 'T' || fields.size() < kTransitionFields) return;
  const auto page = NumberAt(fields[kTransitionPageAt]);
  if (!page) return;
  project.transitions[*page].push_back(WithoutCoordinates(line));
  transition_at[line.range.begin] = *number;
}

Project ProjectOf(const source::SourceManager& sources, source::FileId file) {
  Project project;
  PartKind part = PartKind::kIgnored;
  uint32_t number = 0, rung = 0;
  std::map<uint32_t, uint32_t> transition_at;  // by where its line begins
  for (const Line& line : LinesOfProject(sources, file)) {
    if (line.kind == LineKind::kPart) {
      part = PartByName(PartName(line), rung);
      number = 0;
    }
    const bool is_expression = part == PartKind::kExpressions;
    if (line.kind != LineKind::kData && !(is_expression && line.kind == LineKind::kBlank)) continue;
    switch (part) {
      case PartKind::kExpressions: {
        const auto own = line.text.empty() || line.text.front() == '@' ? std::nullopt : NumberAt(line.text);
        project.numbered[{part, own.value_or(number)}] = line.range;
        if (!own) ++number;
        break;
      }
      case PartKind::kTimers:
      case PartKind::kMonostables:
      case PartKind::kCounters:
      case PartKind::kTimersIec:
        project.numbered[{part, number++}] = line.range;
        break;
      case PartKind::kSequential:
        AddSequential(line, project, transition_at);
        break;
      case PartKind::kSections:
      case PartKind::kGeneral:
      case PartKind::kSymbols:
      case PartKind::kRung:
      case PartKind::kIgnored:
        break;
    }
  }
  // Each condition after its transition.
  for (auto& [page, lines] : project.transitions) {
    Ranges with_conditions;
    for (const source::Range line : lines) {
      with_conditions.push_back(line);
      const auto condition = project.conditions.find(transition_at.at(line.begin));
      if (condition != project.conditions.end()) with_conditions.push_back(condition->second);
    }
    lines = std::move(with_conditions);
  }
  return project;
}

std::optional<PartKind> PartOf(ElementKind kind) {
  switch (kind) {
    case ElementKind::kCompare:
    case ElementKind::kOperate:
      return PartKind::kExpressions;
    case ElementKind::kTimer:
      return PartKind::kTimers;
    case ElementKind::kMonostable:
      return PartKind::kMonostables;
    case ElementKind::kCounter:
      return PartKind::kCounters;
    case ElementKind::kTimerIec:
      return PartKind::kTimersIec;
    case ElementKind::kFree:
    case ElementKind::kContact:
    case ElementKind::kContactNot:
    case ElementKind::kRising:
    case ElementKind::kFalling:
    case ElementKind::kWire:
    case ElementKind::kCoil:
    case ElementKind::kCoilNot:
    case ElementKind::kSet:
    case ElementKind::kReset:
    case ElementKind::kJump:
    case ElementKind::kCall:
    case ElementKind::kPart:
      break;
  }
  return std::nullopt;
}

void AddLinesOfRow(const Project& project, std::string_view row, Ranges& lines) {
  for (std::string_view text : FieldsOf(row)) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    const auto split = SplitElement(text);
    const auto type = split ? NumberAt(split->type) : std::nullopt;
    const auto kind = type ? ElementByNumber(*type) : std::nullopt;
    const auto part = kind ? PartOf(*kind) : std::nullopt;
    if (!part) continue;
    const size_t slash = split->variable.find('/');
    if (slash == std::string_view::npos) continue;
    const auto number = NumberAt(split->variable.substr(slash + 1));
    const auto found = number ? project.numbered.find({*part, *number}) : project.numbered.end();
    if (found != project.numbered.end() && std::ranges::find(lines, found->second) == lines.end())
      lines.push_back(found->second);
  }
}

Ranges LinesOf(const Project& project, std::string_view statement) {
  Ranges lines;
  const std::vector<std::string_view> fields = FieldsOf(statement);
  if (fields.size() == kSectionFields && !SplitElement(fields.front())) {
    const auto page = NumberAt(fields[kPageAt]);
    for (const auto* const of_pages : {&project.steps, &project.transitions}) {
      const auto found = page ? of_pages->find(*page) : of_pages->end();
      if (found != of_pages->end()) lines.insert(lines.end(), found->second.begin(), found->second.end());
    }
    return lines;
  }
  while (!statement.empty()) {
    const size_t end = std::min(statement.find('\n'), statement.size());
    AddLinesOfRow(project, statement.substr(0, end), lines);
    statement.remove_prefix(std::min(end + 1, statement.size()));
  }
  return lines;
}

}  // namespace

std::vector<Ranges> LinesElsewhere(const source::SourceManager& sources, std::span<const source::Range> statements) {
  std::vector<Ranges> lines;
  std::map<source::FileId, Project> projects;
  for (const source::Range range : statements) {
    Ranges& of_statement = lines.emplace_back();
    const source::FileId file = sources.Locate(range.begin).file;
    if (!file.valid()) continue;
    auto found = projects.find(file);
    if (found == projects.end()) found = projects.emplace(file, ProjectOf(sources, file)).first;
    of_statement = LinesOf(found->second, sources.Text(range));
  }
  return lines;
}

}  // namespace plcxx::classicladder
