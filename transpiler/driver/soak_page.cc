// The page of a soak: complete in itself, no script.
#include <map>
#include <string>
#include <vector>

#include "transpiler/driver/soak_output.h"
#include "transpiler/report/html.h"

namespace plcxx::driver {
namespace {

using report::Escape;

constexpr const char* kStyle =
    "body{font:14px/1.45 system-ui,sans-serif;margin:2em;max-width:80em;color:#1b1b1b;background:#fff}"
    "pre,td.t{font-family:ui-monospace,monospace;white-space:pre-wrap}table{border-collapse:collapse}"
    "td,th{padding:.1em .6em;text-align:left;vertical-align:top}td.n{text-align:right;color:#555}"
    "tr.all td.s{background:#d8efd8}tr.some td.s{background:#fdeebf}tr.none td.s{background:#f6c9c9}"
    "@media(prefers-color-scheme:dark){body{color:#ddd;background:#181818}tr.all td.s{background:#1f4a1f}"
    "tr.some td.s{background:#5a4a10}tr.none td.s{background:#6a2323}td.n{color:#aaa}}";

struct Row {
  const soak::StatementRecord* statement = nullptr;
  size_t first = 0;  // goal
};

std::string RowText(const soak::Record& record, const Row& row) {
  size_t conditions = 0, both = 0, cases = 0, taken = 0;
  bool executed = false;
  const std::vector<soak::GoalKind>& goals = row.statement->goals;
  for (size_t i = 0; i < goals.size(); ++i) {
    const bool is_reached = record.reached.Has(row.first + i);
    switch (goals[i]) {
      case soak::GoalKind::kStatement:
        executed = is_reached;
        break;
      case soak::GoalKind::kCondition:
        // Both ways follow each other.
        ++conditions;
        ++i;
        both += is_reached && record.reached.Has(row.first + i) ? 1 : 0;
        break;
      case soak::GoalKind::kCase:
        ++cases;
        taken += is_reached ? 1 : 0;
        break;
    }
  }
  const bool is_all = executed && both == conditions && taken == cases;
  std::string state = !executed ? "not executed" : is_all ? "reached" : "";
  if (executed && both != conditions) {
    state = std::to_string(both) + " of " + std::to_string(conditions) + " conditions both ways";
  }
  if (executed && taken != cases) {
    state += (state.empty() ? "" : ", ") + std::to_string(taken) + " of " + std::to_string(cases) + " cases";
  }
  return std::string("<tr class=\"") +
         (is_all     ? "all"
          : executed ? "some"
                     : "none") +
         "\"><td class=\"n\">" + std::to_string(row.statement->line) + "</td><td class=\"s\">" + state +
         "</td><td class=\"t\">" + Escape(row.statement->text) + "</td></tr>\n";
}

}  // namespace

std::string SoakPage(const soak::Record& record) {
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
                     Escape(record.program) + ": soak</title>\n<style>" + kStyle + "</style></head>\n<body>\n<h1>" +
                     Escape(record.program) + ": soak</h1>\n<pre>" + Escape(SoakText(record, "")) + "</pre>\n";
  std::vector<std::string> files;
  std::map<std::string, std::vector<Row>> rows_of;
  size_t goal = 0;
  for (const soak::StatementRecord& statement : record.statements) {
    std::vector<Row>& rows = rows_of[statement.file];
    if (rows.empty()) files.push_back(statement.file);
    rows.push_back({&statement, goal});
    goal += statement.goals.size();
  }
  for (const std::string& file : files) {
    page += "<h2>" + Escape(file) + "</h2>\n<table><tr><th>line</th><th>seen</th><th>statement</th></tr>\n";
    for (const Row& row : rows_of[file]) page += RowText(record, row);
    page += "</table>\n";
  }
  return page + "</body></html>\n";
}

}  // namespace plcxx::driver
