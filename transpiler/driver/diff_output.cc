#include "transpiler/driver/diff_output.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "transpiler/diagnostics/terminal_text.h"

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

/// Why an item is in the list.
std::string Cause(const DiffItem& item) {
  if (item.declared)
    return item.declared->old_text + " in the old version, " + item.declared->new_text + " in the new one";
  std::string text;
  const bool undecided = item.verdict == ItemVerdict::kUndecided;
  if (!item.changed_itself && !item.through.empty()) {
    text = (undecided ? "at most through " : "through ") + Joined(item.through, 4);
  }
  if (undecided) text += (text.empty() ? "" : "; ") + item.reason;
  return text;
}

/// Of the wake of a change that reaches everything a few are enough; the outputs are shown all.
constexpr size_t kMostOfWake = 20;
bool IsWake(const DiffItem& item) {
  return item.verdict == ItemVerdict::kUndecided && !item.changed_itself && item.kind != ItemKind::kOutput;
}
std::string RestOfWake(size_t count) {
  return "and " + std::to_string(count) + " more that are not decided, at most through what stands above" +
         " (--format json lists them)";
}

void AddStatements(std::string& text, std::string_view side, const std::vector<ItemStatement>& statements,
                   diag::Colour colour) {
  constexpr size_t kMostStatements = 6;
  size_t shown = 0;
  for (const ItemStatement& statement : statements) {
    if (shown++ == kMostStatements) {
      text += "      " + std::string(side) + "  and " + std::to_string(statements.size() - kMostStatements) + " more\n";
      return;
    }
    const std::string line = statement.file + ":" + std::to_string(statement.line) + "  " + statement.text;
    text += "      " + std::string(side) + (statement.changed ? " * " : "   ") +
            (statement.changed ? Paint(line, "1", colour) : line) + "\n";
  }
}

std::string ExampleText(const Counterexample& example, const DiffNames&) {
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

std::string DiffText(const Diff& diff, const DiffNames& names, diag::Colour colour) {
  std::string text = names.old_label + " -> " + names.new_label + ": " + DiffSummary(diff) + "\n";
  for (const ItemKind kind : kKinds) {
    bool titled = false;
    size_t wake = 0;
    for (const DiffItem& item : diff.items) {
      if (item.kind != kind || (IsWake(item) && ++wake > kMostOfWake)) continue;
      if (!titled) text += "\n" + std::string(WordsOf(kind).title) + "\n";
      titled = true;
      const char* const code = item.verdict == ItemVerdict::kDifferent ? "1;31" : "1;33";
      text += "  " + Paint(item.name, "1", colour);
      if (!item.meaning.empty()) text += "  (" + item.meaning + ")";
      text += "  " + Paint(std::string(VerdictText(item.verdict)), code, colour);
      if (const std::string cause = Cause(item); !cause.empty()) text += ", " + cause;
      text += "\n";
      if (item.changed_itself) {
        AddStatements(text, "old", item.old_statements, colour);
        AddStatements(text, "new", item.new_statements, colour);
      }
      if (item.counterexample) text += "      " + ExampleText(*item.counterexample, names) + "\n";
    }
    if (wake > kMostOfWake) text += "  " + RestOfWake(wake - kMostOfWake) + "\n";
  }
  return text;
}

std::string DiffMarkdown(const Diff& diff, const DiffNames& names) {
  std::string text = "### What changed from " + EscapedMarkdown(names.old_label) + " to " +
                     EscapedMarkdown(names.new_label) + "\n\n" + DiffSummary(diff) + ".\n";
  for (const ItemKind kind : kKinds) {
    bool titled = false;
    size_t wake = 0;
    for (const DiffItem& item : diff.items) {
      if (item.kind != kind || (IsWake(item) && ++wake > kMostOfWake)) continue;
      if (!titled) {
        text += "\n**" + std::string(WordsOf(kind).title) +
                "**\n\n| | verdict | statements | shown by |\n|---|---|---|---|\n";
      }
      titled = true;
      text += "| `" + item.name + "`" + (item.meaning.empty() ? "" : " " + EscapedMarkdown(item.meaning)) + " | " +
              std::string(VerdictText(item.verdict));
      if (const std::string cause = Cause(item); !cause.empty()) text += ", " + EscapedMarkdown(cause);
      text += " | ";
      std::string separator;
      if (item.changed_itself) {
        for (const auto& [sign, list] : {std::pair("-", &item.old_statements), std::pair("+", &item.new_statements)}) {
          for (const ItemStatement& statement : *list) {
            if (!statement.changed) continue;
            text += separator + sign + " " + EscapedMarkdown(statement.text);
            separator = "<br>";
          }
        }
      }
      text += " | " +
              (item.counterexample ? EscapedMarkdown(ExampleText(*item.counterexample, names)) : std::string()) +
              " |\n";
    }
    if (wake > kMostOfWake) text += "\n" + RestOfWake(wake - kMostOfWake) + "\n";
  }
  return text;
}

std::string DiffJson(const Diff& diff, const DiffNames& names) {
  Json json = {{"old", names.old_label},       {"new", names.new_label},
               {"summary", DiffSummary(diff)}, {"notLookedAt", diff.not_looked_at},
               {"equal", diff.equal},          {"invariants", diff.invariants},
               {"items", Json::array()}};
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

std::string DiffSarif(const Diff& diff, const DiffNames& names) {
  Json results = Json::array();
  for (const DiffItem& item : diff.items) {
    std::string message = item.name + " " +
                          std::string(item.verdict == ItemVerdict::kDifferent ? "behaves differently"
                                                                              : "is not proved to behave as before");
    if (const std::string cause = Cause(item); !cause.empty()) message += " (" + cause + ")";
    if (item.counterexample) message += ": " + ExampleText(*item.counterexample, names);
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
                                             {"results", std::move(results)}}})}};
  return diag::JsonForTerminals(sarif.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace plcxx::driver
