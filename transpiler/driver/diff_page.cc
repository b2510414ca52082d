#include "transpiler/driver/diff_page.h"

#include "transpiler/driver/diff_groups.h"
#include "transpiler/driver/diff_output.h"
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

/// What the text form of the diff says of the group, in sentences.
std::string TextOf(const DiffGroup& group) {
  const DiffItem& item = group.first();
  const bool is_one = group.items.size() == 1;
  std::string text = item.meaning.empty() || !is_one ? "" : item.meaning + ". ";
  if (const std::string cause = Cause(group); !cause.empty()) text += cause + ". ";
  for (const std::string& run : RunsOf(group)) text += run + ". ";
  return text;
}

}  // namespace

std::string DiffPage(const Diff& diff, const DiffSide& old_side, const DiffSide& new_side) {
  report::Review review;
  review.old_program = PageInput(old_side.compilation);
  review.equal = diff.equal;
  review.summary = DiffSummary(diff);
  for (const DiffGroup& group : GroupsOf(diff)) {
    const DiffItem& item = group.first();
    report::Finding finding;
    finding.place = Heading(group);
    finding.kind = KindOf(item.kind);
    finding.verdict = VerdictOf(item.verdict);
    // What follows from a change stands with that.
    if (item.changed_itself || group.causes.empty()) {
      for (const ItemStatement& statement : item.old_statements) finding.old_statements.push_back(statement.statement);
      for (const ItemStatement& statement : item.new_statements) finding.new_statements.push_back(statement.statement);
    }
    finding.text = TextOf(group);
    for (const DiffItem* const one : group.items) {
      if (!one->counterexample || one->counterexample->scenario.empty()) continue;
      finding.counterexample += (finding.counterexample.empty() ? "" : "\n") + one->counterexample->scenario;
    }
    review.findings.push_back(std::move(finding));
  }
  return report::Page(PageInput(new_side.compilation), review);
}

}  // namespace plcxx::driver
