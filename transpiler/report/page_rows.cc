// The program's rows: source, generated C++ and ladder side by side, and the index of the search.

#include <nlohmann/json.hpp>

#include "transpiler/report/html.h"
#include "transpiler/report/ladder_drawing.h"
#include "transpiler/report/page_parts.h"

namespace plcxx::report {
namespace {

constexpr size_t kGroupRows = 32;   // rows
constexpr size_t kLinesAround = 2;  // of a row: heading and margins, in lines

constexpr const char* ClassSuffix(Verdict verdict) {
  switch (verdict) {
    case Verdict::kDifferent:
      return " different";
    case Verdict::kNotDecided:
      return " undecided";
    case Verdict::kEqual:
      return "";
  }
  return "";
}

bool IsCodeComment(std::string_view line) {
  const size_t begin = line.find_first_not_of(' ');
  return begin != std::string_view::npos && line.substr(begin).starts_with("//");
}

/// Blanks in front of all lines, as many as are more than a few.
size_t Margin(const Row& row) {
  constexpr size_t kKept = 4;
  size_t margin = std::string_view::npos;
  for (const SourceLine& line : row.source) {
    margin = std::min(margin, std::min(line.text.find_first_not_of(' '), line.text.size()));
  }
  return row.source.empty() || margin < kKept ? 0 : margin - kKept;
}

void AppendSource(const Row& row, std::string& out) {
  out += "<pre class=\"src\" tabindex=\"-1\">";
  const size_t margin = Margin(row);
  if (row.source.empty() && !row.title.empty()) out += "<i>" + Escape(row.title) + "</i>";
  for (const SourceLine& line : row.source) {
    out += "<span data-n=\"" + std::to_string(line.number) + (line.comment ? "\" class=\"c\">" : "\">") +
           Escape(line.text.substr(std::min(margin, line.text.size()))) + "</span>";
  }
  out += "</pre>";
}

void AppendCode(const Row& row, std::string& out) {
  out += "<pre class=\"cpp\" tabindex=\"-1\">";
  size_t indent = std::string_view::npos;
  for (const CodeLine& line : row.code) indent = std::min(indent, line.text.find_first_not_of(' '));
  for (const CodeLine& line : row.code) {
    out += "<span data-n=\"" + std::to_string(line.number) + (IsCodeComment(line.text) ? "\" class=\"c\">" : "\">") +
           Escape(line.text.substr(indent)) + "</span>";
  }
  out += "</pre>";
}

void AppendMeta(const View& view, const Row& row, const Marks& marks, std::string& out) {
  out += "<div class=\"meta\">";
  for (const ir::StatementId id : row.statements) {
    const std::string anchor = view.AnchorOf(id);
    out += "<a";
    if (id != row.statements.front()) out += " id=\"" + anchor + "\"";
    out += " href=\"#" + anchor + "\">" + Escape(view.PlaceOf(id)) + "</a>";
    if (const std::string parts = view.PartsOf(id); !parts.empty()) out += "<span>" + Escape(parts) + "</span>";
    if (view.time_ns[id.index] > 0) out += "<span>" + TimeText(view.time_ns[id.index]) + "</span>";
    if (marks.verdict[id.index] != Verdict::kEqual) {
      out += "<strong>" +
             Escape((marks.verdict[id.index] == Verdict::kDifferent ? "changed behaviour: " : "not decided: ") +
                    marks.places[id.index]) +
             "</strong>";
    }
  }
  out += "</div>";
}

/// The heading of a file or of the control's own rows, where they begin.
void AppendHeading(const View& view, const Row* before, const Row& row, std::string& out) {
  if (before != nullptr && before->file == row.file) return;
  if (row.file.valid()) {
    out += "<h3>" + Escape(FileName(view.input.sources->Get(row.file).path)) + "</h3>\n";
  } else {
    out += "<h3>Around the program: what the control does</h3>\n";
  }
}

/// What a row will take before it is laid out, so that the scroll bar does not jump.
size_t LinesOf(const Row& row) { return std::max({row.source.size(), row.code.size(), row.ladder.size() * 3}); }

void AppendRow(const View& view, const Row& row, const Marks& marks, std::string& out) {
  Verdict verdict = Verdict::kEqual;
  for (const ir::StatementId id : row.statements) verdict = std::min(verdict, marks.verdict[id.index]);
  const bool text = row.code.empty() && row.ladder.empty();
  out += std::string("<article class=\"row") + (text ? " text" : "") + ClassSuffix(verdict) + "\"";
  if (!row.statements.empty()) out += " id=\"" + view.AnchorOf(row.statements.front()) + "\" tabindex=\"-1\"";
  out += " style=\"--n:" + std::to_string(LinesOf(row)) + "\">";
  if (!row.statements.empty()) AppendMeta(view, row, marks, out);
  AppendCells(view, row, out);
  out += "</article>\n";
}

}  // namespace

void AppendCells(const View& view, const Row& row, std::string& out) {
  AppendSource(row, out);
  AppendCode(row, out);
  out += "<div class=\"lad\">";
  if (!row.ladder.empty()) {
    const std::string of = row.statements.empty() ? row.title : view.PlaceOf(row.statements.front());
    AppendSvgElement(Draw(row.ladder), "ladder of " + of, out);
  }
  out += "</div>";
}

/// A browser lays out the groups near the window only, and of these the rows near it: scrolling through thousands of
/// rows costs the same as through a few.
void AppendRows(const View& view, const Marks& marks, std::string& out) {
  const std::vector<Row>& rows = view.rows.rows;
  for (size_t begin = 0; begin < rows.size();) {
    AppendHeading(view, begin == 0 ? nullptr : &rows[begin - 1], rows[begin], out);
    size_t end = begin, lines = 0;
    for (; end < rows.size() && end - begin < kGroupRows && rows[end].file == rows[begin].file; ++end) {
      lines += LinesOf(rows[end]) + kLinesAround;
    }
    out += "<div class=\"group\" style=\"--n:" + std::to_string(lines) + "\">\n";
    for (; begin < end; ++begin) AppendRow(view, rows[begin], marks, out);
    out += "</div>\n";
  }
}

std::string SearchIndex(const View& view) {
  nlohmann::ordered_json index;
  index["signals"] = nlohmann::json::array();
  for (const Signal& signal : view.uses.signals) {
    index["signals"].push_back(signal.name + " " + signal.address + " " + signal.words);
  }
  index["rows"] = nlohmann::json::array();
  for (const Row& row : view.rows.rows) {
    std::string text = row.title;
    for (const SourceLine& line : row.source) {
      text += ' ';
      text += line.text;
    }
    for (const ir::StatementId id : row.statements) text += " " + view.PlaceOf(id);
    index["rows"].push_back(std::move(text));
  }
  // Letters beyond ASCII are escaped; "</script>" and "<!--" must not end or change the element that holds it.
  std::string safe;
  for (const char c : index.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace)) {
    if (c == '<' || c == '>' || c == '&') {
      safe += c == '<' ? "\\u003c" : c == '>' ? "\\u003e" : "\\u0026";
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace plcxx::report
