#include "transpiler/driver/diff_page.h"

#include "transpiler/driver/report_page.h"
#include "transpiler/report/page.h"

namespace plcxx::driver {
namespace {

constexpr const char* KindOf(ItemKind kind) {
  switch (kind) {
    case ItemKind::kSchedule:
      return "schedule";
    case ItemKind::kData:
      return "data";
    case ItemKind::kOutput:
      return "output";
    case ItemKind::kCalls:
      return "calls";
    case ItemKind::kRetentive:
      return "retentive";
    case ItemKind::kInternal:
      return "internal";
  }
  return "";
}

constexpr report::Verdict VerdictOf(ItemVerdict verdict) {
  switch (verdict) {
    case ItemVerdict::kEqual:
      return report::Verdict::kEqual;
    case ItemVerdict::kDifferent:
      return report::Verdict::kDifferent;
    case ItemVerdict::kUndecided:
      return report::Verdict::kNotDecided;
  }
  return report::Verdict::kNotDecided;
}

/// What the text form of the diff says of the item, in sentences.
std::string TextOf(const DiffItem& item) {
  std::string text = item.meaning.empty() ? "" : item.meaning + ". ";
  if (item.declared)
    text += item.declared->old_text + " in the old version, " + item.declared->new_text + " in the new one. ";
  if (item.counterexample) {
    text += "Behind " + item.counterexample->steps + ": " + item.counterexample->old_value + " in the old version, " +
            item.counterexample->new_value + " in the new one" +
            (item.counterexample->replay == Replay::kSideBySide ? " (not as a scenario)" : "") + ". ";
  }
  if (!item.reason.empty()) text += "Not decided: " + item.reason + ". ";
  if (!item.through.empty()) {
    text += "Through";
    for (size_t i = 0; i < item.through.size(); ++i) text += (i == 0 ? " " : ", ") + item.through[i];
    text += ".";
  }
  return text;
}

}  // namespace

std::string DiffPage(const Diff& diff, const DiffSide& old_side, const DiffSide& new_side) {
  report::Review review;
  review.old_program = PageInput(old_side.compilation);
  review.equal = diff.equal;
  for (const DiffItem& item : diff.items) {
    report::Finding finding;
    finding.place = item.name;
    finding.kind = KindOf(item.kind);
    finding.verdict = VerdictOf(item.verdict);
    for (const ItemStatement& statement : item.old_statements) finding.old_statements.push_back(statement.statement);
    for (const ItemStatement& statement : item.new_statements) finding.new_statements.push_back(statement.statement);
    finding.text = TextOf(item);
    if (item.counterexample) finding.counterexample = item.counterexample->scenario;
    review.findings.push_back(std::move(finding));
  }
  return report::Page(PageInput(new_side.compilation), review);
}

}  // namespace plcxx::driver
