#include <algorithm>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

#include "transpiler/dialects/nc110/analysis/accesses.h"
#include "transpiler/dialects/nc110/analysis/warnings.h"
#include "transpiler/dialects/nc110/machine/signals.h"
#include "transpiler/dialects/nc110/source/tokens.h"

namespace plcxx::nc110 {
namespace {

bool Overlap(const Operand& a, const Operand& b) {
  return IsMemory(a) && IsMemory(b) && a.package == b.package && ByteOf(a) == ByteOf(b) && (BitsOf(a) & BitsOf(b)) != 0;
}

/// Memory that only the program gives a meaning.
bool IsFree(const Operand& operand, const Settings& settings) {
  if (operand.package == Package::kT) return !settings.t_initial[ByteOf(operand)].has_value();
  return operand.package == Package::kK && !InBasePart(Package::kK, operand.number, settings.processes);
}

bool IsTermOfOr(const Program& tree, ExprId id, const Operand& operand) {
  const Expr& expr = tree.exprs[id];
  if (expr.kind == ExprKind::kOr) return IsTermOfOr(tree, expr.left, operand) || IsTermOfOr(tree, expr.right, operand);
  return expr.kind == ExprKind::kOperand && AsBit(expr.operand) == operand;
}

}  // namespace

WriteCounts::WriteCounts(const Program& tree) : counts_(size_t{kAllPackageBytes} * 8) {
  for (const Item& item : tree.items) {
    if (item.kind != ItemKind::kAssignment) continue;
    const Operand& target = tree.assignments[item.assignment()].target.operand;
    if (!IsMemory(target)) continue;
    const size_t first = (size_t{PackageBase(target.package)} + ByteOf(target)) * 8;
    for (size_t bit = 0; bit < 8; ++bit) {
      uint8_t& count = counts_[first + bit];
      if ((BitsOf(target) >> bit & 1) != 0 && count < 255) ++count;
    }
  }
}

uint32_t WriteCounts::Of(const Operand& operand) const {
  const size_t first = (size_t{PackageBase(operand.package)} + ByteOf(operand)) * 8;
  uint32_t most = 0;
  for (size_t bit = 0; bit < 8; ++bit) {
    if ((BitsOf(operand) >> bit & 1) != 0) most = std::max<uint32_t>(most, counts_[first + bit]);
  }
  return most;
}

void CheckUnwritten(const CheckedProgram& program, diag::Engine& diagnostics) {
  const WriteCounts writes(program.tree);
  const std::vector<Operand>& external = program.settings.external;
  std::unordered_set<uint32_t> reported;
  ForEachAccess(program.tree, [&](const Access& access) {
    const Operand operand = AsBit(access.operand);
    if (IsWrite(access.kind) || !IsMemory(operand) || !IsFree(operand, program.settings)) return;
    if (writes.Of(operand) != 0 || program.help.Describes(operand)) return;
    if (std::any_of(external.begin(), external.end(), [&](const Operand& e) { return Overlap(e, operand); })) return;
    const uint32_t key = (PackageBase(operand.package) + ByteOf(operand)) << 8 | BitsOf(operand);
    if (reported.insert(key).second) {
      diagnostics.Report(access.range, diag::Nc110ReadNeverWritten, ToText(access.operand));
    }
  });
}

/// W324. A counter that is driven, but whose reset or direction nothing writes.
void CheckUnwrittenFields(const CheckedProgram& program, diag::Engine& diagnostics) {
  const auto what_it_does = [](OperandKind kind) -> std::string_view {
    if (kind == OperandKind::kCounterReset) return "the counter is to be reset";
    if (kind == OperandKind::kCounterDown) return "the counter is to count down";
    return kind == OperandKind::kTimerHold ? "the timer is to be held" : "";
  };
  using Field = std::pair<OperandKind, uint32_t>;
  std::set<Field> written;
  for (const Item& item : program.tree.items) {
    if (item.kind != ItemKind::kAssignment) continue;
    const Operand& target = program.tree.assignments[item.assignment()].target.operand;
    written.emplace(target.kind, target.number);
  }
  std::set<Field> reported;
  ForEachAccess(program.tree, [&](const Access& access) {
    const Operand& field = access.operand;
    const std::string_view what = what_it_does(field.kind);
    if (IsWrite(access.kind) || what.empty() || written.contains({field.kind, field.number})) return;
    const bool timer = field.kind == OperandKind::kTimerHold;
    const OperandKind input = timer ? OperandKind::kTimerInput : OperandKind::kCounterInput;
    if (!written.contains({input, field.number})) return;  // W352 speaks of the whole
    if (!reported.emplace(field.kind, field.number).second) return;
    diagnostics.Report(access.range, diag::Nc110FieldNeverWritten, ToText(access.operand), what);
  });
}

void CheckSelfHold(const CheckedProgram& program, diag::Engine& diagnostics) {
  const Program& tree = program.tree;
  const WriteCounts writes(tree);
  for (const Item& item : tree.items) {
    if (item.kind != ItemKind::kAssignment || item.faulty) continue;
    const Assignment& assignment = tree.assignments[item.assignment()];
    const Operand& target = assignment.target.operand;
    if (target.kind != OperandKind::kOutput || assignment.inverted || !assignment.value.valid()) continue;
    if (tree.exprs[assignment.value].kind != ExprKind::kOr || writes.Of(target) > 1) continue;
    if (IsTermOfOr(tree, assignment.value, target)) {
      diagnostics.Report(assignment.target.range, diag::Nc110SelfHoldWithoutReset, ToText(target));
    }
  }
}

namespace {

/// A constant as BCD: what was probably meant; a byte of BCD ends at 99.
std::string BcdDigits(uint32_t value) { return value > 99 ? "00H to 99H" : std::to_string(value) + "H"; }

}  // namespace

void CheckBcdComparisons(const CheckedProgram& program, diag::Engine& diagnostics) {
  const Program& tree = program.tree;
  const auto check = [&](const Expr& word, const Expr& constant) {
    if (word.kind != ExprKind::kOperand || word.operand.kind != OperandKind::kWord) return;
    if (constant.kind != ExprKind::kConstant || constant.value < 10) return;
    const std::string_view text = program.sources.Text(constant.range);
    if (text.empty() || Upper(text.back()) == 'H') return;
    if (!HoldsBcd(word.operand, program.settings.processes)) return;
    diagnostics.Report(constant.range, diag::Nc110BcdDecimal, ToText(word.operand), text, BcdDigits(constant.value));
  };
  for (const Expr& expr : tree.exprs) {
    if (expr.kind != ExprKind::kLess && expr.kind != ExprKind::kEqual && expr.kind != ExprKind::kGreater) continue;
    const Expr &left = tree.exprs[expr.left], &right = tree.exprs[expr.right];
    check(left, right);
    check(right, left);
  }
}

}  // namespace plcxx::nc110
