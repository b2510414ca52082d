#include "transpiler/driver/diff_page.h"

#include "transpiler/driver/diff_output.h"
#include "transpiler/driver/diff_told_runs.h"
#include "transpiler/driver/report_page.h"
#include "transpiler/report/page.h"
#include "transpiler/review/diff/groups.h"

namespace plcxx::driver {
namespace {

constexpr const char* KindOf(review::diff::ItemKind kind) {
  switch (kind) {
    case review::diff::ItemKind::kSchedule:
      return "schedule";
    case review::diff::ItemKind::kData:
      return "data";
    case review::diff::ItemKind::kOutput:
      return "output";
    case review::diff::ItemKind::kCalls:
      return "calls";
    case review::diff::ItemKind::kRetentive:
      return "retentive";
    case review::diff::ItemKind::kInternal:
      return "internal";
  }
  return "";
}

constexpr report::Verdict VerdictOf(review::diff::ItemVerdict verdict) {
  switch (verdict) {
    case review::diff::ItemVerdict::kEqual:
      return report::Verdict::kEqual;
    case review::diff::ItemVerdict::kDifferent:
      return report::Verdict::kDifferent;
    case review::diff::ItemVerdict::kUndecided:
      return report::Verdict::kNotDecided;
  }
  return report::Verdict::kNotDecided;
}

/// What the text form of the diff says of the group, in sentences.
std::string TextOf(const review::diff::DiffGroup& group, ToldRuns& runs) {
  const review::diff::DiffItem& item = group.first();
  const bool is_one = group.items.size() == 1;
  std::string text = item.meaning.empty() || !is_one ? "" : item.meaning + ". ";
  if (const std::string cause = Cause(group); !cause.empty()) text += cause + ". ";
  for (const std::string& run : runs.Of(group)) text += run + ". ";
  return text;
}

}  // namespace

std::string DiffPage(const review::diff::Diff& diff, const review::diff::DiffSide& old_side,
                     const review::diff::DiffSide& new_side) {
  report::Review review;
  review.old_program = PageInput(old_side.compilation);
  review.equal = diff.equal;
  review.summary = DiffSummary(diff);
  review.changes = ChangesAsPatch(diff);
  ToldRuns runs;
  for (const review::diff::DiffGroup& group : review::diff::GroupsOf(diff)) {
    const review::diff::DiffItem& item = group.first();
    report::Finding finding;
    finding.place = Heading(group);
    finding.kind = KindOf(item.kind);
    finding.verdict = VerdictOf(item.verdict);
    // What follows from a change stands with that.
    if (item.changed_itself || group.causes.empty()) {
      for (const review::diff::ItemStatement& statement : item.old_statements)
        finding.old_statements.push_back(statement.statement);
      for (const review::diff::ItemStatement& statement : item.new_statements)
        finding.new_statements.push_back(statement.statement);
    }
    finding.text = TextOf(group, runs);
    for (const review::diff::DiffItem* const one : group.items) {
      if (!one->counterexample || one->counterexample->scenario.empty()) continue;
      finding.counterexample += (finding.counterexample.empty() ? "" : "\n") + one->counterexample->scenario;
    }
    review.findings.push_back(std::move(finding));
  }
  return report::Page(PageInput(new_side.compilation), review);
}

}  // namespace plcxx::driver
