#include "transpiler/driver/soak_output.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

#include "transpiler/diagnostics/terminal_text.h"

namespace plcxx::driver {
namespace {

constexpr size_t kMostNames = 30;
constexpr uint64_t kMsPerHour = 3'600'000, kMsPerMinute = 60'000;

std::string Digits(uint64_t number) {
  std::string digits = std::to_string(number);
  for (size_t at = digits.size(); at > 3;) {
    at -= 3;
    digits.insert(at, ",");
  }
  return digits;
}

std::string Hours(uint64_t ms) {
  if (ms < kMsPerHour) {
    const uint64_t tenths = (ms * 10 + kMsPerMinute / 2) / kMsPerMinute;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " machine-minutes";
  }
  const uint64_t tenths = (ms * 10 + kMsPerHour / 2) / kMsPerHour;
  return Digits(tenths / 10) + "." + std::to_string(tenths % 10) + " machine-hours";
}

/// "a.plc:3-5, 9; b.plc:1"
std::string PlacesText(const std::map<std::string, std::set<uint32_t>>& lines_of) {
  std::string text;
  for (const auto& [file, lines] : lines_of) {
    text += (text.empty() ? "" : "; ") + file + ":";
    std::string separator;
    for (auto line = lines.begin(); line != lines.end();) {
      const uint32_t first = *line;
      uint32_t last = first;
      for (++line; line != lines.end() && *line == last + 1; ++line) ++last;
      text += separator + std::to_string(first) + (last == first ? "" : "-" + std::to_string(last));
      separator = ", ";
    }
  }
  return text;
}

/// Where goals of the kind were not reached, by file and line.
std::map<std::string, std::set<uint32_t>> Missing(const soak::Record& record, soak::GoalKind kind) {
  std::map<std::string, std::set<uint32_t>> missing;
  size_t goal = 0;
  for (const soak::StatementRecord& statement : record.statements) {
    bool is_executed = true;
    for (const soak::GoalKind one : statement.goals) {
      const bool is_reached = record.reached.Has(goal++);
      if (one == soak::GoalKind::kStatement) is_executed = is_reached;
      // Of a statement that is not executed nothing else is reached, either.
      if (one == kind && !is_reached && (is_executed || kind == soak::GoalKind::kStatement)) {
        missing[statement.file].insert(statement.line);
      }
    }
  }
  return missing;
}

std::string CountText(const soak::Record& record, soak::GoalKind kind) {
  const soak::Count count = CountOf(record, kind);
  return Digits(count.reached) + " of " + Digits(count.all);
}

std::string FindingText(const soak::FindingRecord& finding, const std::string& directory) {
  std::string text = "- " + finding.text + "\n";
  if (!finding.steps.empty()) text += "  " + finding.steps + "\n";
  if (!directory.empty()) text += "  " + (std::filesystem::path(directory) / finding.file).generic_string() + "\n";
  if (!finding.not_shown.empty()) text += "  its scenario does not show it: " + finding.not_shown + "\n";
  return text;
}

std::string NamelessText(size_t count) {
  return count == 0 ? "" : " (" + Digits(count) + " more have no name, and were not looked at)";
}

std::string OutputsText(const soak::Record& record) {
  std::vector<std::string> still;
  for (const soak::OutputRecord& output : record.outputs) {
    if (output.moved()) continue;
    still.push_back(output.name + " (" +
                    (output.width == 1 ? std::to_string(output.ones & 1) : std::to_string(output.ones)) + ")");
  }
  if (still.empty())
    return "all " + Digits(record.outputs.size()) + " outputs moved" + NamelessText(record.nameless_outputs) + "\n";
  std::string text = Digits(still.size()) + " of " + Digits(record.outputs.size()) + " outputs never moved in " +
                     Digits(record.parts) + " scans: ";
  for (size_t i = 0; i < still.size() && i < kMostNames; ++i) text += (i == 0 ? "" : ", ") + still[i];
  if (still.size() > kMostNames) text += " and " + std::to_string(still.size() - kMostNames) + " more";
  return text + NamelessText(record.nameless_outputs) + "\n";
}

std::string MessagesText(const soak::Record& record) {
  size_t never = 0;
  std::string standing;
  for (const auto& [number, message] : record.messages) {
    if (message.life.came == 0) ++never;
    if (message.life.came != 0 && message.life.went == 0)
      standing += (standing.empty() ? "" : ", ") + std::to_string(number);
  }
  std::string text = Digits(record.messages.size() - never) + " messages came";
  return text + (standing.empty() ? "" : "; never seen to go: " + standing) + "\n";
}

}  // namespace

std::string SoakText(const soak::Record& record, const std::string& directory) {
  using soak::GoalKind;
  std::string text = record.program + ": " + Hours(record.machine_ms) + " of " + std::to_string(record.machines) +
                     (record.machines == 1 ? " machine" : " machines") + ", " + Digits(record.parts) + " scans, seed " +
                     std::to_string(record.seed);
  for (const std::string& shard : record.shards) text += ", shard " + shard;
  if (record.out_of_time) text += "; the time was over before the machine-hours";
  if (record.was_asked_to_end) text += "; ended by a signal before the machine-hours were over";
  text += "\n";
  if (record.findings.empty()) {
    text += "found: nothing\n";
  } else {
    text += "found: " + Digits(record.findings.size()) + "\n";
    for (const soak::FindingRecord& finding : record.findings) text += FindingText(finding, directory);
  }
  if (!record.more.empty()) text += "- and " + Digits(record.more.size()) + " more, which were only counted\n";
  for (const std::string& one : record.not_repeated) text += "not repeated: " + one + "\n";
  text += "statements executed: " + CountText(record, GoalKind::kStatement) +
          "; conditions seen both ways: " + CountText(record, GoalKind::kCondition);
  if (CountOf(record, GoalKind::kCase).all != 0) text += "; cases taken: " + CountText(record, GoalKind::kCase);
  text += "\n";
  const auto add_missing = [&](const std::string& what, GoalKind kind) {
    const std::string places = PlacesText(Missing(record, kind));
    if (!places.empty()) text += what + ": " + places + "\n";
  };
  add_missing("not executed", GoalKind::kStatement);
  add_missing("with a condition seen one way only", GoalKind::kCondition);
  add_missing("with a case not taken", GoalKind::kCase);
  if (!record.outputs.empty()) text += OutputsText(record);
  if (!record.messages.empty()) text += MessagesText(record);
  text += "This says what was seen in these scans: faults, loops at their guard, parts that do not end, " +
          std::to_string(record.properties) + (record.properties == 1 ? " property" : " properties") + ", by " +
          std::to_string(record.inputs) + " inputs";
  if (record.nameless != 0)
    text += " (" + std::to_string(record.nameless) + " more have no name that a scenario can set)";
  if (!record.plant.empty()) {
    text += " and by the plant (" + record.plant + "), which drives " + std::to_string(record.driven) + " more";
  }
  text += ". It proves nothing of what was not reached.\n";
  if (record.wide_parts != 0) {
    text += Digits(record.wide_parts) +
            " of the scans were in a fleet, where only what is new and how outputs move is looked at: statements, "
            "conditions and calls of the control that had not been seen, properties of one moment.\n";
  }
  return diag::EscapedLines(text);
}

}  // namespace plcxx::driver
