#include "transpiler/driver/diff_output.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/diagnostics/uri.h"
#include "transpiler/driver/diff_told_runs.h"
#include "transpiler/review/diff/groups.h"
#include "transpiler/support/listed.h"

namespace plcxx::driver {
namespace {

using Json = nlohmann::ordered_json;

struct KindWords {
  std::string_view title, one, many;
};
KindWords WordsOf(review::diff::ItemKind kind) {
  switch (kind) {
    case review::diff::ItemKind::kSchedule:
      return {"Schedule", "part of the schedule", "parts of the schedule"};
    case review::diff::ItemKind::kData:
      return {"Texts and tables", "text or table item", "texts or table items"};
    case review::diff::ItemKind::kOutput:
      return {"Outputs", "output", "outputs"};
    case review::diff::ItemKind::kCalls:
      return {"Calls of the control", "kind of call", "kinds of calls"};
    case review::diff::ItemKind::kRetentive:
      return {"Retentive memory", "retentive location", "retentive locations"};
    case review::diff::ItemKind::kInternal:
      return {"Internal state", "internal location", "internal locations"};
  }
  return {};
}
constexpr std::array kKinds = {review::diff::ItemKind::kSchedule,  review::diff::ItemKind::kOutput,
                               review::diff::ItemKind::kCalls,     review::diff::ItemKind::kData,
                               review::diff::ItemKind::kRetentive, review::diff::ItemKind::kInternal};

std::string_view VerdictText(review::diff::ItemVerdict verdict) {
  switch (verdict) {
    case review::diff::ItemVerdict::kEqual:
      return "equal";
    case review::diff::ItemVerdict::kDifferent:
      return "different";
    case review::diff::ItemVerdict::kUndecided:
      return "not decided";
  }
  return {};
}

std::string Count(size_t count, const KindWords& words) {
  return std::to_string(count) + " " + std::string(count == 1 ? words.one : words.many);
}

std::string Paint(std::string text, const char* code, diag::Colour colour) {
  return colour == diag::Colour::kOn ? "\x1B[" + std::string(code) + "m" + text + "\x1B[0m" : text;
}

}  // namespace

std::string Cause(const review::diff::DiffGroup& group) {
  const review::diff::DiffItem& item = group.first();
  if (item.declared)
    return item.declared->old_text + " in the old version, " + item.declared->new_text + " in the new one";
  std::string text;
  const bool undecided = item.verdict == review::diff::ItemVerdict::kUndecided;
  if (!group.causes.empty()) text = (undecided ? "at most through " : "through ") + support::Listed(group.causes, 4);
  if (!undecided) return text;
  std::string reason = item.reason;
  for (const review::diff::DiffItem* const other : group.items) {
    if (other->reason != reason) reason = "of some " + item.reason + "; of others " + other->reason;
    if (other->reason != item.reason) break;
  }
  return text + (text.empty() ? "" : "; ") + reason;
}

std::string Heading(const review::diff::DiffGroup& group) {
  const std::string names = review::diff::NamesOf(group);
  return group.items.size() == 1 ? names : names + " (" + std::to_string(group.items.size()) + ")";
}

namespace {

constexpr size_t kMostStatements = 6;  // of one location
constexpr size_t kMostChanges = 20;    // of all

void AddStatements(std::string& text, std::string_view side, const std::vector<review::diff::ItemStatement>& statements,
                   diag::Colour colour, size_t most) {
  size_t shown = 0;
  for (const review::diff::ItemStatement& statement : statements) {
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
void AddChanges(std::string& text, std::string_view sign, const std::vector<review::diff::ItemStatement>& statements) {
  for (size_t i = 0; i < statements.size() && i < kMostChanges; ++i) {
    text += std::string(sign) + " " + statements[i].file + ":" + std::to_string(statements[i].line) + "  " +
            statements[i].text + "\n";
  }
  if (statements.size() > kMostChanges)
    text += std::string(sign) + " and " + std::to_string(statements.size() - kMostChanges) + " more\n";
}

const char* CodeOf(review::diff::ItemVerdict verdict) {
  return verdict == review::diff::ItemVerdict::kDifferent ? "1;31" : "1;33";
}

Json ToJson(const std::vector<review::diff::ItemStatement>& statements) {
  Json list = Json::array();
  for (const review::diff::ItemStatement& statement : statements) {
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

std::string DiffSummary(const review::diff::Diff& diff) {
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  for (const auto& [verdict, one, many] :
       {std::tuple(review::diff::ItemVerdict::kDifferent, " differs", " differ"),
        std::tuple(review::diff::ItemVerdict::kUndecided, " is not decided", " are not decided")}) {
    for (const review::diff::ItemKind kind : kKinds) {
      const auto count =
          static_cast<size_t>(std::ranges::count_if(diff.items, [&, v = verdict](const review::diff::DiffItem& item) {
            return item.kind == kind && item.verdict == v;
          }));
      if (count != 0) add(Count(count, WordsOf(kind)) + (count == 1 ? one : many));
    }
  }
  if (text.empty()) text = "no difference";
  text += "; " + std::to_string(diff.equal) + " proved equal for every input and all scans";
  if (diff.invariants != 0) text += " (with " + std::to_string(diff.invariants) + " invariants)";
  for (const std::string& what : diff.not_looked_at) text += "; not looked at: " + what;
  return text;
}

namespace {

/// The changed statements, when what comes first does not show them all.
bool TellsChanges(const review::diff::Diff& diff, const std::vector<review::diff::DiffGroup>& groups) {
  if (groups.empty() || (diff.old_statements.empty() && diff.new_statements.empty())) return false;
  const review::diff::DiffItem& first = groups.front().first();
  if (!first.changed_itself) return true;
  const auto are_among = [](const std::vector<review::diff::ItemStatement>& statements,
                            const std::vector<review::diff::ItemStatement>& told) {
    return std::ranges::all_of(statements, [&told](const review::diff::ItemStatement& statement) {
      return std::ranges::find(told, statement.statement, &review::diff::ItemStatement::statement) != told.end();
    });
  };
  return !are_among(diff.old_statements, first.old_statements) || !are_among(diff.new_statements, first.new_statements);
}

/// Of statements that nobody changed the first ones are enough.
std::vector<review::diff::ItemStatement> Telling(const std::vector<review::diff::ItemStatement>& statements) {
  std::vector<review::diff::ItemStatement> changed;
  std::ranges::copy_if(statements, std::back_inserter(changed), &review::diff::ItemStatement::changed);
  return changed.empty() ? statements : changed;
}

}  // namespace

std::string ChangesAsPatch(const review::diff::Diff& diff) {
  if (!TellsChanges(diff, review::diff::GroupsOf(diff))) return {};
  std::string text;
  AddChanges(text, "-", diff.old_statements);
  AddChanges(text, "+", diff.new_statements);
  return text;
}

std::string DiffText(const review::diff::Diff& diff, const DiffNames& names, diag::Colour colour) {
  std::string text = (names.program.empty() ? "" : names.program + ": ") + names.old_label + " -> " + names.new_label +
                     ": " + DiffSummary(diff) + "\n";
  const std::vector<review::diff::DiffGroup> groups = review::diff::GroupsOf(diff);
  if (TellsChanges(diff, groups)) {
    text += "\nChanged\n";
    AddStatements(text, "old", diff.old_statements, colour, kMostChanges);
    AddStatements(text, "new", diff.new_statements, colour, kMostChanges);
  }
  ToldRuns runs;
  std::optional<review::diff::ItemKind> kind;
  for (const review::diff::DiffGroup& group : groups) {
    const review::diff::DiffItem& item = group.first();
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
    for (const std::string& line : runs.Of(group)) text += "      " + line + "\n";
  }
  return text;
}

std::string DiffMarkdown(const review::diff::Diff& diff, const DiffNames& names) {
  const std::string heading = names.program.empty() ? "What" : EscapedMarkdown(names.program) + ": what";
  std::string text = "### " + heading + " changed from " + EscapedMarkdown(names.old_label) + " to " +
                     EscapedMarkdown(names.new_label) + "\n\n" + DiffSummary(diff) + ".\n";
  const std::vector<review::diff::DiffGroup> groups = review::diff::GroupsOf(diff);
  const auto statements = [](const std::vector<review::diff::ItemStatement>& old_statements,
                             const std::vector<review::diff::ItemStatement>& new_statements) {
    std::string all, separator;
    for (const auto& [sign, list] : {std::pair("-", &old_statements), std::pair("+", &new_statements)}) {
      for (const review::diff::ItemStatement& statement : *list) {
        if (!statement.changed) continue;
        all += separator + sign + " " + EscapedMarkdown(statement.text);
        separator = "<br>";
      }
    }
    return all;
  };
  if (TellsChanges(diff, groups)) {
    const std::string changes = ChangesAsPatch(diff);
    std::string fence = "```";
    while (changes.find(fence) != std::string::npos) fence += '`';
    text += "\n" + fence + "diff\n" + changes + fence + "\n";
  }
  ToldRuns runs;
  std::optional<review::diff::ItemKind> kind;
  for (const review::diff::DiffGroup& group : groups) {
    const review::diff::DiffItem& item = group.first();
    if (kind != item.kind) {
      text += "\n**" + std::string(WordsOf(item.kind).title) +
              "**\n\n| | verdict | statements | shown by |\n|---|---|---|---|\n";
    }
    kind = item.kind;
    const bool is_one = group.items.size() == 1;
    text += "| `" + review::diff::NamesOf(group) + "`" +
            (is_one ? "" : " (" + std::to_string(group.items.size()) + ")") +
            (is_one && !item.meaning.empty() ? " " + EscapedMarkdown(item.meaning) : std::string()) + " | " +
            std::string(VerdictText(item.verdict));
    if (const std::string cause = Cause(group); !cause.empty()) text += ", " + EscapedMarkdown(cause);
    text +=
        " | " + (item.changed_itself ? statements(item.old_statements, item.new_statements) : std::string()) + " | ";
    std::string separator;
    for (const std::string& line : runs.Of(group)) {
      text += separator + EscapedMarkdown(line);
      separator = "<br>";
    }
    text += " |\n";
  }
  return text;
}

std::string DiffJson(const review::diff::Diff& diff, const DiffNames& names) {
  Json json = {{"old", names.old_label},
               {"new", names.new_label},
               {"summary", DiffSummary(diff)},
               {"notLookedAt", diff.not_looked_at},
               {"onlyOldWrites", diff.old_only},
               {"onlyNewWrites", diff.new_only},
               {"equal", diff.equal},
               {"invariants", diff.invariants},
               {"oldStatements", ToJson(diff.old_statements)},
               {"newStatements", ToJson(diff.new_statements)},
               {"groups", Json::array()},
               {"items", Json::array()}};
  for (const review::diff::DiffGroup& group : review::diff::GroupsOf(diff)) {
    Json members = Json::array();
    for (const review::diff::DiffItem* const item : group.items) members.push_back(item->name);
    json["groups"].push_back({{"names", review::diff::NamesOf(group)},
                              {"kind", WordsOf(group.first().kind).one},
                              {"verdict", VerdictText(group.first().verdict)},
                              {"causes", group.causes},
                              {"text", Cause(group)},
                              {"items", std::move(members)}});
  }
  for (const review::diff::DiffItem& item : diff.items) {
    Json entry = {{"name", item.name},
                  {"meaning", item.meaning},
                  {"kind", WordsOf(item.kind).one},
                  {"verdict", VerdictText(item.verdict)},
                  {"changedItself", item.changed_itself},
                  {"through", item.through},
                  {"oldStatements", ToJson(item.old_statements)},
                  {"newStatements", ToJson(item.new_statements)}};
    if (item.declared) entry["declared"] = {{"old", item.declared->old_text}, {"new", item.declared->new_text}};
    if (!item.reason.empty() && item.verdict == review::diff::ItemVerdict::kUndecided) entry["reason"] = item.reason;
    if (item.counterexample) {
      entry["counterexample"] = {{"steps", item.counterexample->steps},
                                 {"old", item.counterexample->old_value},
                                 {"new", item.counterexample->new_value},
                                 {"fromState", item.counterexample->from_state},
                                 {"confirmed", item.counterexample->replay >= review::diff::Replay::kSimulator},
                                 {"compiled", item.counterexample->replay == review::diff::Replay::kCompiled},
                                 {"scenario", item.counterexample->scenario}};
    }
    json["items"].push_back(std::move(entry));
  }
  return diag::JsonForTerminals(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

namespace {

Json PlaceOf(const review::diff::ItemStatement& statement) {
  return {{"artifactLocation", {{"uri", diag::UriOf(statement.file)}}},
          {"region", {{"startLine", statement.line}, {"startColumn", statement.column}}}};
}

/// What an item is about in the new version: its own statements; where it has none, the only one that was changed.
const std::vector<review::diff::ItemStatement>& StatementsInNew(const review::diff::Diff& diff,
                                                                const review::diff::DiffItem& item) {
  return item.new_statements.empty() && diff.new_statements.size() == 1 ? diff.new_statements : item.new_statements;
}

}  // namespace

std::string DiffSarif(const review::diff::Diff& diff, const DiffNames& names) {
  Json results = Json::array();
  const std::vector<review::diff::DiffGroup> groups = review::diff::GroupsOf(diff);
  for (const review::diff::DiffGroup& group : groups) {
    const review::diff::DiffItem& item = group.first();
    const bool is_one = group.items.size() == 1;
    std::string message = Heading(group) + " ";
    if (item.verdict == review::diff::ItemVerdict::kDifferent) {
      message += is_one ? "behaves differently" : "behave differently";
    } else {
      message += is_one ? "is not proved to behave as before" : "are not proved to behave as before";
    }
    if (const std::string cause = Cause(group); !cause.empty()) message += " (" + cause + ")";
    std::string separator = ": ";
    // Each result is read by itself.
    for (const std::string& line : ToldRuns().Of(group)) {
      message += separator + line;
      separator = "; ";
    }
    Json result = {{"ruleId", item.verdict == review::diff::ItemVerdict::kDifferent ? "behaviour-differs"
                                                                                    : "behaviour-not-decided"},
                   {"level", item.verdict == review::diff::ItemVerdict::kDifferent ? "warning" : "note"},
                   {"message", {{"text", message}}}};
    for (const review::diff::ItemStatement& statement : StatementsInNew(diff, item))
      result["locations"].push_back({{"physicalLocation", PlaceOf(statement)}});
    if (!result.contains("locations")) {
      result["locations"].push_back(
          {{"physicalLocation", {{"artifactLocation", {{"uri", diag::UriOf(names.new_file)}}}}}});
    }
    if (item.new_statements.empty()) {  // they are in a file that who reads this need not have
      for (const review::diff::ItemStatement& statement : item.old_statements) {
        result["relatedLocations"].push_back(
            {{"physicalLocation", PlaceOf(statement)}, {"message", {{"text", "in the old version"}}}});
      }
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
                                             {"properties",
                                              {{"summary", DiffSummary(diff)},
                                               {"oldStatements", ToJson(diff.old_statements)},
                                               {"newStatements", ToJson(diff.new_statements)}}},
                                             {"results", std::move(results)}}})}};
  return diag::JsonForTerminals(sarif.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace plcxx::driver
