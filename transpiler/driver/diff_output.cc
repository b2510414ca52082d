#include "transpiler/driver/diff_output.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string_view>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/driver/diff_groups.h"

namespace plcxx::driver {
namespace {

using Json = nlohmann::ordered_json;

struct KindWords {
  std::string_view title, one, many;
};
KindWords WordsOf(ItemKind kind) {
  switch (kind) {
    case ItemKind::kSchedule:
      return {"Schedule", "part of the schedule", "parts of the schedule"};
    case ItemKind::kData:
      return {"Texts and tables", "text or table item", "texts or table items"};
    case ItemKind::kOutput:
      return {"Outputs", "output", "outputs"};
    case ItemKind::kCalls:
      return {"Calls of the control", "kind of call", "kinds of calls"};
    case ItemKind::kRetentive:
      return {"Retentive memory", "retentive location", "retentive locations"};
    case ItemKind::kInternal:
      return {"Internal state", "internal location", "internal locations"};
  }
  return {};
}
constexpr std::array kKinds = {ItemKind::kSchedule, ItemKind::kOutput,    ItemKind::kCalls,
                               ItemKind::kData,     ItemKind::kRetentive, ItemKind::kInternal};

std::string_view VerdictText(ItemVerdict verdict) {
  switch (verdict) {
    case ItemVerdict::kEqual:
      return "equal";
    case ItemVerdict::kDifferent:
      return "different";
    case ItemVerdict::kUndecided:
      return "not decided";
  }
  return {};
}

std::string Count(size_t count, const KindWords& words) {
  return std::to_string(count) + " " + std::string(count == 1 ? words.one : words.many);
}

std::string Joined(const std::vector<std::string>& names, size_t most) {
  std::string text;
  for (size_t i = 0; i < names.size() && i < most; ++i) text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text;
}

std::string Paint(std::string text, const char* code, diag::Colour colour) {
  return colour == diag::Colour::kOn ? "\x1B[" + std::string(code) + "m" + text + "\x1B[0m" : text;
}

}  // namespace

std::string Cause(const DiffGroup& group) {
  const DiffItem& item = group.first();
  if (item.declared)
    return item.declared->old_text + " in the old version, " + item.declared->new_text + " in the new one";
  std::string text;
  const bool undecided = item.verdict == ItemVerdict::kUndecided;
  if (!group.causes.empty()) text = (undecided ? "at most through " : "through ") + Joined(group.causes, 4);
  if (!undecided) return text;
  std::string reason = item.reason;
  for (const DiffItem* const other : group.items) {
    if (other->reason != reason) reason = "of some " + item.reason + "; of others " + other->reason;
    if (other->reason != item.reason) break;
  }
  return text + (text.empty() ? "" : "; ") + reason;
}

std::string Heading(const DiffGroup& group) {
  const std::string names = NamesOf(group);
  return group.items.size() == 1 ? names : names + " (" + std::to_string(group.items.size()) + ")";
}

namespace {

/// Runs of one group that are shown; each location has one in JSON and among the written scenarios.
constexpr size_t kMostRunsTold = 8;

std::string RestOfRuns(size_t count) {
  return "and " + std::to_string(count) + " more, each with a run of its own in --format json and --counterexamples";
}

constexpr size_t kMostStatements = 6;  // of one location
constexpr size_t kMostChanges = 20;    // of all

void AddStatements(std::string& text, std::string_view side, const std::vector<ItemStatement>& statements,
                   diag::Colour colour, size_t most) {
  size_t shown = 0;
  for (const ItemStatement& statement : statements) {
    if (shown++ == most) {
      text += "      " + std::string(side) + "  and " + std::to_string(statements.size() - most) + " more\n";
      return;
    }
    const std::string line = statement.file + ":" + std::to_string(statement.line) + "  " + statement.text;
    text += "      " + std::string(side) + (statement.changed ? " * " : "   ") +
            (statement.changed ? Paint(line, "1", colour) : line) + "\n";
  }
}

/// As lines of a patch.
void AddChanges(std::string& text, std::string_view sign, const std::vector<ItemStatement>& statements) {
  for (size_t i = 0; i < statements.size() && i < kMostChanges; ++i) {
    text += std::string(sign) + " " + statements[i].file + ":" + std::to_string(statements[i].line) + "  " +
            statements[i].text + "\n";
  }
  if (statements.size() > kMostChanges)
    text += std::string(sign) + " and " + std::to_string(statements.size() - kMostChanges) + " more\n";
}

const char* CodeOf(ItemVerdict verdict) { return verdict == ItemVerdict::kDifferent ? "1;31" : "1;33"; }

std::string ExampleText(const Counterexample& example) {
  std::string text = (example.steps.empty() ? "a run that no scenario can say" : example.steps) + ": ";
  text += example.old_value == example.new_value
              ? "the calls differ"
              : example.old_value + " in the old version, " + example.new_value + " in the new one";
  if (example.from_state) text += " (from this state; no run from power-on to it is known)";
  if (example.replay == Replay::kSideBySide) text += " (both versions beside each other; not as a scenario)";
  return text;
}

Json ToJson(const std::vector<ItemStatement>& statements) {
  Json list = Json::array();
  for (const ItemStatement& statement : statements) {
    list.push_back({{"file", statement.file},
                    {"line", statement.line},
                    {"column", statement.column},
                    {"text", statement.text},
                    {"changed", statement.changed}});
  }
  return list;
}

std::string EscapedMarkdown(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '\\' || c == '`' || c == '*' || c == '_' || c == '<' || c == '[') result += '\\';
    result += c;
  }
  return result;
}

}  // namespace

std::string DiffSummary(const Diff& diff) {
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  for (const auto& [verdict, one, many] :
       {std::tuple(ItemVerdict::kDifferent, " differs", " differ"),
        std::tuple(ItemVerdict::kUndecided, " is not decided", " are not decided")}) {
    for (const ItemKind kind : kKinds) {
      const auto count = static_cast<size_t>(std::ranges::count_if(
          diff.items, [&, v = verdict](const DiffItem& item) { return item.kind == kind && item.verdict == v; }));
      if (count != 0) add(Count(count, WordsOf(kind)) + (count == 1 ? one : many));
    }
  }
  if (text.empty()) text = "no difference";
  text += "; " + std::to_string(diff.equal) + " proved equal for every input and all scans";
  if (diff.invariants != 0) text += " (with " + std::to_string(diff.invariants) + " invariants)";
  for (const std::string& what : diff.not_looked_at) text += "; not looked at: " + what;
  return text;
}

std::vector<std::string> RunsOf(const DiffGroup& group) {
  std::vector<std::string> lines;
  size_t more = 0;
  std::string steps;
  for (const DiffItem* const item : group.items) {
    if (!item->counterexample) continue;
    if (lines.size() == kMostRunsTold) {
      ++more;
      continue;
    }
    Counterexample example = *item->counterexample;
    const bool is_same = !lines.empty() && !example.steps.empty() && example.steps == steps;
    steps = example.steps;
    if (is_same) example.steps = "after the same run";
    lines.push_back((group.items.size() == 1 ? std::string() : item->name + ": ") + ExampleText(example));
  }
  if (more != 0) lines.push_back(RestOfRuns(more));
  return lines;
}

namespace {

/// The changed statements, when they are not all told with one difference.
bool TellsChanges(const Diff& diff, const std::vector<DiffGroup>& groups) {
  if (diff.old_statements.empty() && diff.new_statements.empty()) return false;
  std::set<std::pair<bool, uint32_t>> open;
  for (const ItemStatement& statement : diff.old_statements) open.emplace(true, statement.statement.index);
  for (const ItemStatement& statement : diff.new_statements) open.emplace(false, statement.statement.index);
  for (const DiffGroup& group : groups) {
    if (!group.first().changed_itself) continue;
    for (const ItemStatement& statement : group.first().old_statements) open.erase({true, statement.statement.index});
    for (const ItemStatement& statement : group.first().new_statements) open.erase({false, statement.statement.index});
    return !open.empty();
  }
  return !groups.empty();
}

/// Of statements that nobody changed the first ones are enough.
std::vector<ItemStatement> Telling(const std::vector<ItemStatement>& statements) {
  std::vector<ItemStatement> changed;
  std::ranges::copy_if(statements, std::back_inserter(changed), &ItemStatement::changed);
  return changed.empty() ? statements : changed;
}

}  // namespace

std::string DiffText(const Diff& diff, const DiffNames& names, diag::Colour colour) {
  std::string text = names.old_label + " -> " + names.new_label + ": " + DiffSummary(diff) + "\n";
  const std::vector<DiffGroup> groups = GroupsOf(diff);
  if (TellsChanges(diff, groups)) {
    text += "\nChanged\n";
    AddStatements(text, "old", diff.old_statements, colour, kMostChanges);
    AddStatements(text, "new", diff.new_statements, colour, kMostChanges);
  }
  std::optional<ItemKind> kind;
  for (const DiffGroup& group : groups) {
    const DiffItem& item = group.first();
    if (kind != item.kind) text += "\n" + std::string(WordsOf(item.kind).title) + "\n";
    kind = item.kind;
    text += "  " + Paint(Heading(group), "1", colour);
    if (group.items.size() == 1 && !item.meaning.empty()) text += "  (" + item.meaning + ")";
    text += "  " + Paint(std::string(VerdictText(item.verdict)), CodeOf(item.verdict), colour);
    if (const std::string cause = Cause(group); !cause.empty()) text += ", " + cause;
    text += "\n";
    if (item.changed_itself) {
      AddStatements(text, "old", Telling(item.old_statements), colour, kMostStatements);
      AddStatements(text, "new", Telling(item.new_statements), colour, kMostStatements);
    }
    for (const std::string& line : RunsOf(group)) text += "      " + line + "\n";
  }
  return text;
}

std::string DiffMarkdown(const Diff& diff, const DiffNames& names) {
  std::string text = "### What changed from " + EscapedMarkdown(names.old_label) + " to " +
                     EscapedMarkdown(names.new_label) + "\n\n" + DiffSummary(diff) + ".\n";
  const std::vector<DiffGroup> groups = GroupsOf(diff);
  const auto statements = [](const std::vector<ItemStatement>& old_statements,
                             const std::vector<ItemStatement>& new_statements) {
    std::string all, separator;
    for (const auto& [sign, list] : {std::pair("-", &old_statements), std::pair("+", &new_statements)}) {
      for (const ItemStatement& statement : *list) {
        if (!statement.changed) continue;
        all += separator + sign + " " + EscapedMarkdown(statement.text);
        separator = "<br>";
      }
    }
    return all;
  };
  if (TellsChanges(diff, groups)) {
    text += "\n```diff\n";
    AddChanges(text, "-", diff.old_statements);
    AddChanges(text, "+", diff.new_statements);
    text += "```\n";
  }
  std::optional<ItemKind> kind;
  for (const DiffGroup& group : groups) {
    const DiffItem& item = group.first();
    if (kind != item.kind) {
      text += "\n**" + std::string(WordsOf(item.kind).title) +
              "**\n\n| | verdict | statements | shown by |\n|---|---|---|---|\n";
    }
    kind = item.kind;
    const bool is_one = group.items.size() == 1;
    text += "| `" + NamesOf(group) + "`" + (is_one ? "" : " (" + std::to_string(group.items.size()) + ")") +
            (is_one && !item.meaning.empty() ? " " + EscapedMarkdown(item.meaning) : std::string()) + " | " +
            std::string(VerdictText(item.verdict));
    if (const std::string cause = Cause(group); !cause.empty()) text += ", " + EscapedMarkdown(cause);
    text +=
        " | " + (item.changed_itself ? statements(item.old_statements, item.new_statements) : std::string()) + " | ";
    std::string separator;
    for (const std::string& line : RunsOf(group)) {
      text += separator + EscapedMarkdown(line);
      separator = "<br>";
    }
    text += " |\n";
  }
  return text;
}

std::string DiffJson(const Diff& diff, const DiffNames& names) {
  Json json = {{"old", names.old_label},
               {"new", names.new_label},
               {"summary", DiffSummary(diff)},
               {"notLookedAt", diff.not_looked_at},
               {"equal", diff.equal},
               {"invariants", diff.invariants},
               {"oldStatements", ToJson(diff.old_statements)},
               {"newStatements", ToJson(diff.new_statements)},
               {"groups", Json::array()},
               {"items", Json::array()}};
  for (const DiffGroup& group : GroupsOf(diff)) {
    Json members = Json::array();
    for (const DiffItem* const item : group.items) members.push_back(item->name);
    json["groups"].push_back({{"names", NamesOf(group)},
                              {"kind", WordsOf(group.first().kind).one},
                              {"verdict", VerdictText(group.first().verdict)},
                              {"causes", group.causes},
                              {"text", Cause(group)},
                              {"items", std::move(members)}});
  }
  for (const DiffItem& item : diff.items) {
    Json entry = {{"name", item.name},
                  {"meaning", item.meaning},
                  {"kind", WordsOf(item.kind).one},
                  {"verdict", VerdictText(item.verdict)},
                  {"changedItself", item.changed_itself},
                  {"through", item.through},
                  {"oldStatements", ToJson(item.old_statements)},
                  {"newStatements", ToJson(item.new_statements)}};
    if (item.declared) entry["declared"] = {{"old", item.declared->old_text}, {"new", item.declared->new_text}};
    if (!item.reason.empty() && item.verdict == ItemVerdict::kUndecided) entry["reason"] = item.reason;
    if (item.counterexample) {
      entry["counterexample"] = {{"steps", item.counterexample->steps},
                                 {"old", item.counterexample->old_value},
                                 {"new", item.counterexample->new_value},
                                 {"fromState", item.counterexample->from_state},
                                 {"confirmed", item.counterexample->replay >= Replay::kSimulator},
                                 {"compiled", item.counterexample->replay == Replay::kCompiled},
                                 {"scenario", item.counterexample->scenario}};
    }
    json["items"].push_back(std::move(entry));
  }
  return diag::JsonForTerminals(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

std::string DiffSarif(const Diff& diff, const DiffNames&) {
  Json results = Json::array();
  const std::vector<DiffGroup> groups = GroupsOf(diff);
  for (const DiffGroup& group : groups) {
    const DiffItem& item = group.first();
    const bool is_one = group.items.size() == 1;
    std::string message = Heading(group) + " ";
    if (item.verdict == ItemVerdict::kDifferent) {
      message += is_one ? "behaves differently" : "behave differently";
    } else {
      message += is_one ? "is not proved to behave as before" : "are not proved to behave as before";
    }
    if (const std::string cause = Cause(group); !cause.empty()) message += " (" + cause + ")";
    std::string separator = ": ";
    for (const std::string& line : RunsOf(group)) {
      message += separator + line;
      separator = "; ";
    }
    Json result = {{"ruleId", item.verdict == ItemVerdict::kDifferent ? "behaviour-differs" : "behaviour-not-decided"},
                   {"level", item.verdict == ItemVerdict::kDifferent ? "warning" : "note"},
                   {"message", {{"text", message}}}};
    const std::vector<ItemStatement>& statements =
        item.new_statements.empty() ? item.old_statements : item.new_statements;
    for (const ItemStatement& statement : statements) {
      result["locations"].push_back(
          {{"physicalLocation",
            {{"artifactLocation", {{"uri", statement.file}}},
             {"region", {{"startLine", statement.line}, {"startColumn", statement.column}}}}}});
    }
    results.push_back(std::move(result));
  }
  const Json rules = Json::array(
      {{{"id", "behaviour-differs"}, {"shortDescription", {{"text", "An output or state behaves differently"}}}},
       {{"id", "behaviour-not-decided"}, {"shortDescription", {{"text", "Equal behaviour is not proved"}}}}});
  const Json sarif = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                      {"version", "2.1.0"},
                      {"runs", Json::array({{{"tool", {{"driver", {{"name", "plcxx diff"}, {"rules", rules}}}}},
                                             {"columnKind", "unicodeCodePoints"},
                                             {"properties", {{"summary", DiffSummary(diff)}}},
                                             {"results", std::move(results)}}})}};
  return diag::JsonForTerminals(sarif.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace plcxx::driver
