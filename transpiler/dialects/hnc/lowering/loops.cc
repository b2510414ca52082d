#include "transpiler/dialects/hnc/lowering/loops.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering/expressions.h"
#include "transpiler/dialects/hnc/lowering/faults.h"
#include "transpiler/dialects/hnc/lowering/intervals.h"
#include "transpiler/dialects/hnc/lowering/jumps.h"
#include "transpiler/dialects/hnc/lowering/live_path.h"
#include "transpiler/dialects/hnc/lowering/loop_bounds.h"
#include "transpiler/dialects/hnc/lowering/statement_writer.h"
#include "transpiler/dialects/hnc/lowering/statements.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr uint64_t kMostRounds = 10'000'000;

/// Whether a region is one store whose value needs nothing else: a step that can stand in the loop's head.
bool IsSingleStore(const ir::Program& program, ir::RegionId region) {
  const std::vector<ir::InstId>& insts = program.regions[region].insts;
  std::vector<uint32_t> uses(insts.size());
  for (size_t i = 0; i < insts.size(); ++i) {
    const ir::Inst& inst = program[insts[i]];
    const ir::Shape shape = ir::Info(inst.op).shape;
    const bool value = shape == ir::Shape::kConst || shape == ir::Shape::kPure || shape == ir::Shape::kLoad;
    if (i + 1 == insts.size() ? shape != ir::Shape::kStore : !value) return false;
    for (const ValueId used : ir::UsedValues(program, inst)) {
      const auto at = std::ranges::find(insts, used);
      if (at == insts.end()) return false;
      if (++uses[static_cast<size_t>(at - insts.begin())] > 1 && program[used].op != OpKind::kConst) return false;
    }
  }
  return !insts.empty();
}

}  // namespace

/// Whether something that was refused may be why it is not known how often the loop goes round: what Clang refuses as
/// a whole is not in the tree.
bool Loops::HasError(const Statement& statement) const {
  source::Offset end = statement.range.end;
  if (!statement.expression.valid()) {
    end = unit_.statements[statement.then].range.begin;  // the condition may be what is wrong in the head
  } else if (ConstantCondition(unit_, statement.expression) == true) {
    return false;  // it is endless, whatever is wrong in it
  }
  return std::ranges::any_of(diagnostics_.all(), [&](const diag::Diagnostic& diagnostic) {
    return diagnostic.severity == diag::Severity::kError && diagnostic.range.begin >= statement.range.begin &&
           diagnostic.range.begin < end;
  });
}

void Loops::CheckRounds(source::Range keyword, uint64_t rounds, const Statement* proved) {
  const uint64_t all = rounds_around_ * rounds;
  if (all <= std::min<uint64_t>(settings_.loop_warn, kMostRounds)) return;
  if (proved != nullptr && HasError(*proved)) return;
  if (all > kMostRounds) {
    diagnostics_.Report(keyword, diag::HncLoopRounds, static_cast<int64_t>(all), static_cast<int64_t>(kMostRounds));
  } else {
    diagnostics_.Report(keyword, diag::HncLongLoop, static_cast<int64_t>(all));
  }
}

void Loops::Lower(const Statement& statement) {
  const bool is_for = statement.kind == StatementKind::kFor, is_do = statement.kind == StatementKind::kDo;
  if (is_for) expressions_.Execute(statement.first);
  const std::optional<bool> always = ConstantCondition(unit_, statement.expression);
  const bool endless = !statement.expression.valid() || always == true;
  bool continues = false;
  const bool leaves = !jumps_.GoesOn(statement.then, continues) && !continues;
  const bool once = (is_do && always == false) || (leaves && (is_do || endless));
  const uint32_t on_break = path_.NewLabel(), on_continue = path_.NewLabel();
  path_.Enter({.on_break = on_break, .on_continue = on_continue, .is_loop = true, .at_ends = {}});
  if (once) {
    statements_.Lower(statement.then, Tail::kNone);
    path_.PlaceLabel(on_continue);
  } else if (always == false) {
    // Never entered.
    const Flow before = flow_;
    flow_.reachable = false;
    statements_.Lower(statement.then, Tail::kNone);
    flow_ = before;
  } else {
    Iterate(statement, on_continue, leaves);
  }
  path_.Leave();
  path_.PlaceLabel(on_break);
}

/// The condition's value as the last instruction of its region.
void Loops::ConditionRegion(ExprId id, ir::RegionId region) {
  builder_.SetRegion(region);
  const ValueId value = expressions_.Condition(id);
  const std::vector<ir::InstId>& insts = program_.regions[region].insts;
  if (insts.empty() || insts.back() != value) Pure(OpKind::kBitAnd, {value, value});
}

/// What is known of the loop's end, or the error that nothing is.
std::optional<LoopProof> Loops::Prove(const Statement& statement, bool leaves) {
  Refusal refusal;
  std::optional<LoopProof> proof =
      loop_bounds_.Prove({.condition = statement.expression,
                          .step = statement.kind == StatementKind::kFor ? statement.step : ExprId(),
                          .body = {statement.then},
                          .tests_first = statement.kind != StatementKind::kDo},
                         refusal);
  if (!proof && !leaves && !HasError(statement)) {
    diag::Diagnostic& refused = diagnostics_.Report(statement.keyword, diag::HncUnboundedLoop, refusal.why);
    if (refusal.counter.begin != refusal.counter.end) {
      refused.notes.push_back({refusal.counter, "what it is tried to count with"});
    }
  }
  return proof;
}

Loops::Bound Loops::BoundOf(const Statement& statement, bool leaves) {
  Bound bound;
  if (!statement.loop_bound) bound.proof = Prove(statement, leaves);
  const std::optional<LoopProof>& proof = bound.proof;
  bound.rounds = std::max<uint64_t>(1, statement.loop_bound ? statement.loop_bound->rounds
                                       : proof              ? proof->count.iterations
                                                            : 1);
  if (statement.loop_bound || proof) CheckRounds(statement.keyword, bound.rounds, proof ? &statement : nullptr);
  // A counter or a limit in memory may be forced from outside: then the rounds are counted all the same.
  bound.is_counted =
      statement.loop_bound || (proof && (proof->rests_on_memory || !intervals_.IsLocalObject(proof->counter.object)));
  return bound;
}

void Loops::LearnAtTest(const Bound& bound) {
  if (bound.knows_values()) flow_.Learn(bound.proof->counter, bound.proof->count.at_test, bound.origin());
}

void Loops::LearnInBody(const Bound& bound) {
  if (!bound.knows_values() || !bound.proof->count.in_body) return;
  const std::optional<Bounds> in_body = bound.proof->count.in_body, known = flow_.Find(bound.proof->counter);
  const std::optional<Bounds> both = known ? Meet(*known, *in_body) : in_body;
  if (both) flow_.Learn(bound.proof->counter, *both, bound.origin());
}

/// What an iteration may write is not known when the next one begins.
void Loops::ForgetWrites(const Statement& statement) {
  intervals_.ForgetWrites(statement.then);
  if (statement.expression.valid())
    ForEachExpr(unit_, statement.expression, [&](ExprId id) { intervals_.ForgetWritesOf(id); });
  if (statement.kind == StatementKind::kFor && statement.step.valid())
    ForEachExpr(unit_, statement.step, [&](ExprId id) { intervals_.ForgetWritesOf(id); });
}

/// A region of its own where the step is one assignment; else it is at the end of the body.
ir::RegionId Loops::LowerStep(ExprId id, ir::RegionId body) {
  const ir::RegionId step = builder_.NewRegion();
  builder_.SetRegion(step);
  expressions_.Execute(id);
  builder_.SetRegion(body);
  if (IsSingleStore(program_, step)) return step;
  std::vector<ir::InstId>& insts = program_.regions[body].insts;
  const std::vector<ir::InstId> of_step = std::exchange(program_.regions[step].insts, {});
  insts.insert(insts.end(), of_step.begin(), of_step.end());
  return {};
}

void Loops::Iterate(const Statement& statement, uint32_t on_continue, bool leaves) {
  const bool is_for = statement.kind == StatementKind::kFor, is_do = statement.kind == StatementKind::kDo;
  const Bound bound = BoundOf(statement, leaves);
  ir::Loop loop{.kind = bound.is_counted ? ir::LoopBound::kGuard : ir::LoopBound::kProven,
                .bound = bound.rounds,
                .budget = {},
                .condition = {},
                .body = builder_.NewRegion(),
                .step = {},
                .exhausted = {}};
  const ir::RegionId after = builder_.region();
  ForgetWrites(statement);
  Flow at_end = flow_;
  if (statement.expression.valid() && !is_do) {
    loop.condition = builder_.NewRegion();
    LearnAtTest(bound);
    ConditionRegion(statement.expression, loop.condition);
    at_end = intervals_.RefineWaysOut(statement.expression, bound.is_counted);
  }
  LearnInBody(bound);
  const uint64_t outer_rounds = std::exchange(rounds_around_, std::min(rounds_around_ * bound.rounds, kMostRounds + 1));
  builder_.SetRegion(loop.body);
  iterated_.push_back(loop.body);
  statements_.Lower(statement.then, Tail::kNone);
  iterated_.pop_back();
  path_.PlaceLabel(on_continue);
  // What the first iteration assigns on every path is assigned after the loop.
  if (bound.proof && bound.proof->is_entered && flow_.reachable) {
    std::erase_if(at_end.unassigned, [this](VariableId id) { return !flow_.unassigned.contains(id); });
  }
  ValueId again;
  if (is_for && statement.step.valid() && flow_.reachable) {
    loop.step = LowerStep(statement.step, loop.body);
  } else if (is_do && flow_.reachable) {
    writer_.MarkText(statement.close, writer_.SubjectOf(statement), false);
    LearnAtTest(bound);
    again = expressions_.Condition(statement.expression);
    at_end = intervals_.RefineWaysOut(statement.expression, bound.is_counted);
  } else if (is_do) {
    at_end.reachable = false;
  }
  rounds_around_ = outer_rounds;
  if (statement.loop_bound) {
    loop.exhausted = builder_.NewRegion();
    builder_.SetRegion(loop.exhausted);
    faults_.Record(Fault::kLoop);
    at_end.reachable = true;
  }
  builder_.SetRegion(after);
  const ir::InstId id = builder_.LoopWith(loop);
  if (again.valid()) {
    builder_.SetRegion(loop.body);
    builder_.Exit(id, Pure(OpKind::kBitNot, {again}));
    builder_.SetRegion(after);
  }
  if (!statement.expression.valid() && !statement.loop_bound) at_end.reachable = false;
  flow_ = at_end;
}

}  // namespace plcxx::hnc
