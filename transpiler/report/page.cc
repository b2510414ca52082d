#include "transpiler/report/page.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "transpiler/cost/cost_model.h"
#include "transpiler/report/embedded_page.h"
#include "transpiler/report/html.h"
#include "transpiler/report/page_parts.h"

namespace plcxx::report {
namespace {

/// Letters and digits of a name, for an anchor; others as '-'.
std::string PlainName(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
    out += plain ? c : '-';
  }
  return out;
}

struct NavigationEntry {
  const char* anchor;
  const char* text;
};
constexpr NavigationEntry kSections[] = {
    {"overview", "Overview"}, {"program", "Program"}, {"signals", "Signals"},       {"lists", "Findings"},
    {"memory", "Memory"},     {"tables", "Lists"},    {"files", "Generated files"},
};

void AppendHead(const View& view, std::string& out) {
  out +=
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>" +
      Escape(view.input.program->name) + " - report</title>\n<style>\n";
  out += PageFile("ladder.css");
  out += PageFile("report.css");
  out += "</style>\n</head>\n<body>\n";
}

void AppendBar(const View& view, bool has_review, std::string& out) {
  out += "<header class=\"bar\">\n<a class=\"skip\" href=\"#program\">Skip to the program</a>\n<h1>" +
         Escape(view.input.program->name) + " <small>" + Escape(view.input.control) + "</small></h1>\n";
  out += "<nav aria-label=\"Sections\">";
  if (has_review) out += "<a href=\"#review\">Review</a>";
  for (const NavigationEntry& entry : kSections) {
    if (std::string_view(entry.anchor) == "tables" && view.input.tables.empty()) continue;
    out += std::string("<a href=\"#") + entry.anchor + "\">" + entry.text + "</a>";
  }
  if (has_review) out += "<a href=\"#old\">Old version</a>";
  out +=
      "</nav>\n<div class=\"tools\" role=\"search\"><label for=\"q\">Search</label>"
      "<input id=\"q\" type=\"search\" autocomplete=\"off\" spellcheck=\"false\" aria-keyshortcuts=\"/\" "
      "placeholder=\"signal, address, text\"/><output id=\"hits\" for=\"q\" aria-live=\"polite\"></output>"
      "<fieldset><legend>Show</legend>"
      "<label><input type=\"checkbox\" id=\"show-src\" checked=\"checked\"/>source</label>"
      "<label><input type=\"checkbox\" id=\"show-cpp\" checked=\"checked\"/>C++</label>"
      "<label><input type=\"checkbox\" id=\"show-lad\" "
      "checked=\"checked\"/>ladder</label></fieldset></div>\n</header>\n";
}

void AppendFoot(const View& view, std::string& out) {
  out +=
      "<aside id=\"card\" aria-label=\"Signal\" hidden=\"hidden\"><button id=\"card-close\" type=\"button\" "
      "aria-label=\"Close\">×</button><div id=\"card-body\"></div></aside>\n";
  out +=
      "<footer><p class=\"keys\"><kbd>/</kbd> search <kbd>Enter</kbd> next match <kbd>Esc</kbd> clear "
      "<kbd>j</kbd> <kbd>k</kbd> next, previous statement</p></footer>\n";
  out += "<script type=\"application/json\" id=\"index\">" + SearchIndex(view) + "</script>\n<script>\n";
  out += PageFile("report.js");
  out += "</script>\n</body>\n</html>\n";
}

Marks NoMarks(const View& view) {
  Marks marks;
  marks.verdict.assign(view.input.program->statements.size(), Verdict::kEqual);
  marks.places.resize(marks.verdict.size());
  return marks;
}

enum class Side : uint8_t { kOld, kNew };

Marks MarksOf(const View& view, const Review& review, Side side) {
  Marks marks = NoMarks(view);
  for (const Finding& finding : review.findings) {
    if (finding.verdict == Verdict::kEqual) continue;
    for (const ir::StatementId id : side == Side::kOld ? finding.old_statements : finding.new_statements) {
      if (id.index >= marks.verdict.size()) continue;
      marks.verdict[id.index] = std::min(marks.verdict[id.index], finding.verdict);
      std::string& places = marks.places[id.index];
      places += (places.empty() ? "" : ", ") + finding.place;
    }
  }
  return marks;
}

void AppendSections(const View& view, const Marks& marks, std::string& out) {
  AppendOverview(view, out);
  out += "<section id=\"program\" class=\"rows\" aria-labelledby=\"h-program\">\n<h2 id=\"h-program\">Program</h2>\n";
  AppendRows(view, marks, out);
  out += "</section>\n";
  AppendSignals(view, out);
  AppendLists(view, out);
  AppendMemory(view, out);
  AppendTables(view, out);
  AppendFiles(view, out);
}

}  // namespace

std::string_view PageFile(std::string_view name) {
  for (unsigned i = 0; i < kPageFilesCount; ++i) {
    if (kPageFiles[i].name == name) return {kPageFiles[i].text, kPageFiles[i].size};
  }
  PLCXX_UNREACHABLE();
}

View::View(const ProgramInput& data, std::string_view anchor_prefix)
    : input(data),
      prefix(anchor_prefix),
      uses(MakeCrossReference(data)),
      rows(MakeRows(data, MakeLadders(data, uses))) {
  const ir::Program& program = *data.program;
  time_ns.assign(program.statements.size(), 0);
  code_bytes.assign(program.statements.size(), 0);
  cost::RoutineTimes known_times;
  for (uint32_t i = 0; i < program.routines.size(); ++i) {
    for (const cost::StatementCost& statement :
         cost::EstimateRoutine(program, ir::RoutineId(i), known_times).statements) {
      time_ns[statement.statement.index] += statement.own.time_ns;
      code_bytes[statement.statement.index] += statement.own.code_bytes;
    }
  }
  std::unordered_map<std::string, uint32_t> count;
  for (const Signal& signal : uses.signals) {
    std::string anchor = prefix + "v-" + PlainName(signal.name);
    const uint32_t before = count[anchor]++;
    if (before > 0) anchor += "--" + std::to_string(before + 1);
    signal_anchors.push_back(std::move(anchor));
  }
}

std::string View::PlaceOf(ir::StatementId statement) const {
  const source::Range range = input.program->statements[statement].range;
  const source::Position at = input.sources->Locate(range.begin);
  if (!at.file.valid()) return input.program->statements[statement].subject;
  return std::string(FileName(input.sources->Get(at.file).path)) + ":" + std::to_string(at.line);
}

std::string View::PartsOf(ir::StatementId statement) const {
  const ir::RoutineId routine = rows.routines[statement.index];
  if (!routine.valid()) return "";
  const std::string& name = input.program->routines[routine].name;
  const std::string& parts = uses.parts[routine.index];
  if (parts == name) return name;
  return name + (parts.empty() ? " (never called)" : " in " + parts);
}

std::string Cell(std::string_view text, std::string_view element) {
  const std::string name(element);
  return "<" + name + ">" + Escape(text) + "</" + name.substr(0, name.find(' ')) + ">";
}

std::string TimeText(uint64_t ns) {
  if (ns < 1000) return std::to_string(ns) + " ns";
  const uint64_t hundredths = (ns + 5) / 10;
  std::string fraction = std::to_string(hundredths % 100);
  if (fraction.size() < 2) fraction.insert(fraction.begin(), '0');
  return std::to_string(hundredths / 100) + "." + fraction + " µs";
}

std::string Link(const View& view, ir::StatementId statement) {
  if (!statement.valid()) return "control";
  return "<a href=\"#" + view.AnchorOf(statement) + "\">" + Escape(view.PlaceOf(statement)) + "</a>";
}

std::string Page(const ProgramInput& program) {
  const View view(program);
  std::string out;
  AppendHead(view, out);
  AppendBar(view, false, out);
  out += "<main>\n";
  AppendSections(view, NoMarks(view), out);
  out += "</main>\n";
  AppendFoot(view, out);
  return out;
}

std::string Page(const ProgramInput& program, const Review& review) {
  const View view(program);
  const View old_view(review.old_program, "old-");
  std::string out;
  AppendHead(view, out);
  AppendBar(view, true, out);
  out += "<main>\n";
  AppendReview(old_view, view, review, out);
  AppendSections(view, MarksOf(view, review, Side::kNew), out);
  out +=
      "<section id=\"old\" class=\"rows\" data-old=\"1\" aria-labelledby=\"h-old\">\n<h2 id=\"h-old\">Old "
      "version</h2>\n";
  AppendRows(old_view, MarksOf(old_view, review, Side::kOld), out);
  out += "</section>\n</main>\n";
  AppendFoot(view, out);
  return out;
}

}  // namespace plcxx::report
