#include "transpiler/driver/mutate_output.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "transpiler/diagnostics/terminal_text.h"
#include "transpiler/support/counted.h"

namespace plcxx::driver {
namespace {

using mutate::Outcome;
using support::Counted;

std::string_view WithoutMargins(std::string_view line) {
  const size_t first = line.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(" \t") - first + 1);
}

/// "lathe.plc:12: U4A0 = I0A0", the line where the statement begins.
std::string HeadOf(const ir::Statement& statement, const source::SourceManager& sources) {
  const source::Position position = sources.Locate(statement.range.begin);
  if (!position.file.valid()) return "the program's own data";
  return sources.Get(position.file).path + ":" + std::to_string(position.line) + ": " +
         std::string(WithoutMargins(sources.Line(position.file, position.line)));
}

std::string StatementsText(const mutate::Mutated& mutated, const compilation::Compilation& compilation,
                           Outcome outcome) {
  std::string text;
  ir::StatementId last;
  for (const mutate::ChangeResult& result : mutated.results) {
    if (result.outcome != outcome) continue;
    const ir::StatementId statement = result.change.statement;
    if (statement != last) {
      text += HeadOf(compilation.program.statements[statement], *compilation.sources) + "\n";
      last = statement;
    }
    // Of a statement that nothing executes the changes say no more than the statement.
    if (outcome != Outcome::kNotReached) text += "    " + result.change.text + "\n";
  }
  return text;
}

}  // namespace

size_t CountOf(const mutate::Mutated& mutated, Outcome outcome) {
  return static_cast<size_t>(std::ranges::count(mutated.results, outcome, &mutate::ChangeResult::outcome));
}

std::string MutateText(const mutate::Mutated& mutated, const compilation::Compilation& compilation, size_t scenarios) {
  const size_t tried = mutated.results.size(), noticed = CountOf(mutated, Outcome::kNoticed);
  const size_t not_noticed = CountOf(mutated, Outcome::kNotNoticed);
  const size_t not_reached = CountOf(mutated, Outcome::kNotReached);
  std::string text = compilation.name + ": " + Counted(tried, "change");
  if (tried != mutated.found) text += " of " + std::to_string(mutated.found);
  text += ", " + Counted(scenarios, "scenario") + "\nnoticed: " + std::to_string(noticed);
  if (tried != 0) text += " (" + std::to_string(noticed * kPercent / tried) + " %)";
  text += "; not noticed: " + std::to_string(not_noticed) + "; not executed: " + std::to_string(not_reached) + "\n";
  if (not_noticed != 0) {
    text += "\nAll scenarios pass although\n" + StatementsText(mutated, compilation, Outcome::kNotNoticed);
  }
  if (not_reached != 0) {
    text += "\nno scenario executes what was changed in\n" + StatementsText(mutated, compilation, Outcome::kNotReached);
  }
  return diag::EscapedLines(text);
}

nlohmann::json MutateJson(const mutate::Mutated& mutated, const compilation::Compilation& compilation,
                          size_t scenarios) {
  nlohmann::json changes = nlohmann::json::array();
  for (const mutate::ChangeResult& result : mutated.results) {
    const source::Position position = compilation.sources->Locate(result.change.range.begin);
    changes.push_back({{"file", position.file.valid() ? compilation.sources->Get(position.file).path : ""},
                       {"line", position.line},
                       {"column", position.column},
                       {"kind", mutate::Name(result.change.kind)},
                       {"text", result.change.text},
                       {"outcome", mutate::Name(result.outcome)}});
  }
  return {{"program", compilation.name},
          {"scenarios", scenarios},
          {"found", mutated.found},
          {"noticed", CountOf(mutated, Outcome::kNoticed)},
          {"not_noticed", CountOf(mutated, Outcome::kNotNoticed)},
          {"not_reached", CountOf(mutated, Outcome::kNotReached)},
          {"changes", std::move(changes)}};
}

}  // namespace plcxx::driver
