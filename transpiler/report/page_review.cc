// What changed between two versions: a table, and for each finding the statements of both side by side.

#include <array>

#include "transpiler/report/html.h"
#include "transpiler/report/page_parts.h"

namespace plcxx::report {
namespace {

constexpr const char* TextOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kDifferent:
      return "different";
    case Verdict::kNotDecided:
      return "not decided";
    case Verdict::kEqual:
      return "proved equal";
  }
  return "";
}

constexpr const char* ClassOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kDifferent:
      return "different";
    case Verdict::kNotDecided:
      return "undecided";
    case Verdict::kEqual:
      return "equal";
  }
  return "";
}

void AppendLinks(const View& view, const std::vector<ir::StatementId>& statements, std::string& out) {
  out += "<td>";
  for (const ir::StatementId id : statements) out += Link(view, id) + " ";
  out += statements.empty() ? "–</td>" : "</td>";
}

void AppendSide(const View& view, const char* title, const std::vector<ir::StatementId>& statements, std::string& out) {
  // Signals are looked up in the tables of the new version only.
  out +=
      std::string("<div class=\"side\"") + (view.prefix.empty() ? "" : " data-old=\"1\"") + "><h4>" + title + "</h4>";
  if (statements.empty()) out += "<p>no statement</p>";
  uint32_t before = kNoRow;
  for (const ir::StatementId id : statements) {
    const uint32_t row = view.rows.of_statement[id.index];
    if (row == before) continue;
    before = row;
    out += "<div class=\"pair\"><div class=\"meta\">" + Link(view, id) + "</div>";
    AppendCells(view, view.rows.rows[row], out);
    out += "</div>";
  }
  out += "</div>";
}

}  // namespace

void AppendReview(const View& old_view, const View& view, const Review& review, std::string& out) {
  std::array<size_t, 3> counts{};
  for (const Finding& finding : review.findings) ++counts[static_cast<size_t>(finding.verdict)];
  const std::string summary = !review.summary.empty()
                                  ? review.summary
                                  : std::to_string(counts[0]) + " different, " + std::to_string(counts[1]) +
                                        " not decided, " + std::to_string(counts[2] + review.equal) + " proved equal";
  out += "<section id=\"review\" aria-labelledby=\"h-review\">\n<h2 id=\"h-review\">Review: what changed</h2>\n<p>" +
         Escape(summary) + ".</p>\n";
  if (!review.changes.empty()) out += "<pre class=\"changes\">" + Escape(review.changes) + "</pre>\n";
  out +=
      "<table><thead><tr><th>Place</th><th>Kind</th><th>Verdict</th><th>Old</th><th>New</th><th>What is "
      "known</th></tr></thead><tbody>";
  for (size_t i = 0; i < review.findings.size(); ++i) {
    const Finding& finding = review.findings[i];
    const std::string place = Escape(finding.place);
    out += std::string("<tr class=\"") + ClassOf(finding.verdict) + "\"><th scope=\"row\">";
    out += finding.verdict == Verdict::kEqual ? place
                                              : "<a href=\"#finding-" + std::to_string(i + 1) + "\">" + place + "</a>";
    out += "</th>" + Cell(finding.kind) + Cell(TextOf(finding.verdict));
    AppendLinks(old_view, finding.old_statements, out);
    AppendLinks(view, finding.new_statements, out);
    out += Cell(finding.text) + "</tr>";
  }
  out += "</tbody></table>\n";
  for (size_t i = 0; i < review.findings.size(); ++i) {
    const Finding& finding = review.findings[i];
    if (finding.verdict == Verdict::kEqual) continue;
    out += std::string("<article class=\"finding ") + ClassOf(finding.verdict) + "\" id=\"finding-" +
           std::to_string(i + 1) + "\" tabindex=\"-1\"><h3>" + Escape(finding.place) + " <span class=\"count\">" +
           TextOf(finding.verdict) + "</span></h3><p>" + Escape(finding.text) + "</p><div class=\"sides\">";
    AppendSide(old_view, "Old", finding.old_statements, out);
    AppendSide(view, "New", finding.new_statements, out);
    out += "</div>";
    if (!finding.counterexample.empty()) {
      out += "<details><summary>Counterexample, a scenario</summary><pre class=\"scenario\">" +
             Escape(finding.counterexample) + "</pre></details>";
    }
    out += "</article>\n";
  }
  out += "</section>\n";
}

}  // namespace plcxx::report
