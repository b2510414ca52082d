// W354: the count needs an edge. An input such as [C5W=0]*a+[C5W=1]*b stays 1 where b already is 1 when a's step ends.
#include <algorithm>
#include <utility>
#include <vector>

#include "transpiler/dialects/nc110/analysis/warnings.h"

namespace plcxx::nc110 {
namespace {

struct Factor {
  Operand operand;
  bool negated = false;
};

/// One term of the input: what it asks of the count, and its other factors as far as they are single operands.
struct Step {
  bool of_own_count = false;
  uint8_t count = 0;
  std::vector<Factor> factors;
};

void CollectTerms(const Program& tree, ExprId id, std::vector<ExprId>& terms) {
  const Expr& expr = tree.exprs[id];
  if (expr.kind == ExprKind::kOr) {
    CollectTerms(tree, expr.left, terms);
    CollectTerms(tree, expr.right, terms);
  } else {
    terms.push_back(id);
  }
}

void CollectFactors(const Program& tree, ExprId id, const Operand& count, Step& step) {
  const Expr& expr = tree.exprs[id];
  if (expr.kind == ExprKind::kAnd) {
    CollectFactors(tree, expr.left, count, step);
    CollectFactors(tree, expr.right, count, step);
  } else if (expr.kind == ExprKind::kOperand) {
    step.factors.push_back({AsBit(expr.operand)});
  } else if (expr.kind == ExprKind::kNot && tree.exprs[expr.left].kind == ExprKind::kOperand) {
    step.factors.push_back({AsBit(tree.exprs[expr.left].operand), true});
  } else if (expr.kind == ExprKind::kEqual) {
    const Expr &left = tree.exprs[expr.left], &right = tree.exprs[expr.right];
    for (const auto& [word, constant] : {std::pair(&left, &right), std::pair(&right, &left)}) {
      if (word->kind != ExprKind::kOperand || word->operand != count || constant->kind != ExprKind::kConstant) continue;
      step.of_own_count = true;
      step.count = constant->value;
    }
  }
}

/// Is one a condition and the other its complement? Or is `next` a pulse, which falls by itself?
bool InputFalls(const Step& step, const Step& next) {
  return std::ranges::any_of(next.factors, [&step](const Factor& factor) {
    if (factor.operand.kind == OperandKind::kOneShot && !factor.negated) return true;
    return std::ranges::any_of(step.factors, [&factor](const Factor& other) {
      return other.operand == factor.operand && other.negated != factor.negated;
    });
  });
}

bool CanStall(const std::vector<Step>& steps) {
  for (const Step& step : steps) {
    for (const Step& next : steps) {
      const bool successive = step.of_own_count && next.of_own_count && next.count == step.count + 1;
      if (successive && !InputFalls(step, next)) return true;
    }
  }
  return false;
}

}  // namespace

void CheckSequencers(const CheckedProgram& program, diag::Engine& diagnostics) {
  const Program& tree = program.tree;
  for (const Item& item : tree.items) {
    if (item.kind != ItemKind::kAssignment || item.faulty) continue;
    const Assignment& assignment = tree.assignments[item.assignment()];
    if (assignment.target.operand.kind != OperandKind::kCounterInput || !assignment.value.valid()) continue;
    const Operand count = {.kind = OperandKind::kCounterValue, .number = assignment.target.operand.number};
    std::vector<ExprId> terms;
    CollectTerms(tree, assignment.value, terms);
    std::vector<Step> steps;
    for (const ExprId term : terms) CollectFactors(tree, term, count, steps.emplace_back());
    if (CanStall(steps)) {
      diagnostics.Report(assignment.target.range, diag::Nc110SequencerStall, ToText(assignment.target.operand));
    }
  }
}

}  // namespace plcxx::nc110
