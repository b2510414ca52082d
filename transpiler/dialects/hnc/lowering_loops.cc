// Loops (specification 6.6): proved to end, or counted where the program says how often they may go round.

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

namespace {

constexpr uint64_t kMostRounds = 10'000'000;

}  // namespace

void Lowering::CheckRounds(source::Range keyword, uint64_t rounds) {
  const uint64_t all = rounds_around_ * rounds;
  if (all > kMostRounds) {
    diagnostics_.Report(keyword, diag::HncLoopRounds, static_cast<int64_t>(all), static_cast<int64_t>(kMostRounds));
  } else if (all > settings_.loop_warn) {
    diagnostics_.Report(keyword, diag::HncLongLoop, static_cast<int64_t>(all));
  }
}

/// What the statement may change is not known any more.
void Lowering::ForgetWrites(StatementId id) {
  if (!id.valid()) return;
  ForEachExprIn(unit_, id, [&](ExprId part) { ForgetWritesOf(part); });
}

void Lowering::ForgetWritesOf(ExprId id) {
  const Expr& expr = ExprAt(id);
  if (expr.kind == ExprKind::kAssign || expr.kind == ExprKind::kCompoundAssign || expr.kind == ExprKind::kIncrement) {
    if (const std::optional<StaticAddress> at = facts_.AddressOf(expr.a)) {
      flow_.Forget(Cell{at->object, at->offset, std::max(1u, TypeAt(ExprAt(expr.a).type).size)});
      if (TypeAt(ExprAt(expr.a).type).kind == TypeKind::kPointer) flow_.Forget(at->object);
      return;
    }
  }
  for (const ObjectId object : facts_.WritesOf(expr).objects) flow_.Forget(object);
}

/// Whether control can get to the end of the statement, or round the loop by `continue`.
bool Lowering::GoesOn(StatementId id, bool& continues) const {
  if (!id.valid()) return true;
  const Statement& statement = unit_.statements[id];
  switch (statement.kind) {
    case StatementKind::kCompound: {
      bool on = true;
      for (const StatementId part : statement.body) {
        if (!on && !IsEntered(part)) continue;
        on = GoesOn(part, continues);
      }
      return on;
    }
    case StatementKind::kReturn:
    case StatementKind::kBreak:
      return false;
    case StatementKind::kGoto:
      // Out of the loop, or to a label in it, behind which all is looked at as well.
      return MayBeRefused(unit_, statement);
    case StatementKind::kContinue:
      continues = true;
      return false;
    case StatementKind::kIf: {
      const bool then = GoesOn(statement.then, continues);
      const bool otherwise = statement.otherwise.valid() ? GoesOn(statement.otherwise, continues) : true;
      return then || otherwise;
    }
    case StatementKind::kLabel:
      return GoesOn(statement.then, continues);
    default:
      ForEachStatement(unit_, id, [&](StatementId part) { continues = continues || Continues(part, id); });
      return true;
  }
}

/// Whether a statement in `outer` is a `continue` that belongs to a loop around `outer`.
bool Lowering::Continues(StatementId id, StatementId outer) const {
  if (unit_.statements[id].kind != StatementKind::kContinue) return false;
  for (StatementId at = ParentOf(id); at.valid(); at = ParentOf(at)) {
    if (IsLoop(unit_.statements[at].kind)) return false;
    if (at == outer) break;
  }
  return true;
}

void Lowering::LoopStatement(const Statement& statement) {
  const bool is_for = statement.kind == StatementKind::kFor, is_do = statement.kind == StatementKind::kDo;
  if (is_for) Execute(statement.first);
  const std::optional<bool> always = ConstantCondition(unit_, statement.expression);
  const bool endless = !statement.expression.valid() || always == true;
  bool continues = false;
  const bool leaves = endless && !GoesOn(statement.then, continues) && !continues;
  const bool once = (is_do && always == false) || leaves;
  const uint32_t on_break = NewLabel(), on_continue = NewLabel();
  around_.push_back({.on_break = on_break, .on_continue = on_continue, .is_loop = true});
  const StatementId outer_elided = std::exchange(elided_break_, {});
  if (once) {
    Lower(statement.then, false);
    PlaceLabel(on_continue);
  } else if (always == false && !is_do) {
    // Never entered.
    const Flow before = flow_;
    flow_.reachable = false;
    Lower(statement.then, false);
    flow_ = before;
  } else {
    Rounds(statement, on_continue);
  }
  around_.pop_back();
  PlaceLabel(on_break);
  elided_break_ = outer_elided;
}

/// The condition's value as the last instruction of its region.
void Lowering::ConditionRegion(ExprId id, ir::RegionId region) {
  builder_.SetRegion(region);
  const ValueId value = Condition(id);
  const std::vector<ir::InstId>& insts = program_.regions[region].insts;
  if (insts.empty() || insts.back() != value) Pure(OpKind::kBitAnd, {value, value});
}

/// Whether a region is one store whose value needs nothing else: a step that can stand in the loop's head.
bool Lowering::IsSingleStore(ir::RegionId region) const {
  const std::vector<ir::InstId>& insts = program_.regions[region].insts;
  std::vector<uint32_t> uses(insts.size());
  for (size_t i = 0; i < insts.size(); ++i) {
    const ir::Inst& inst = program_[insts[i]];
    const ir::Shape shape = ir::Info(inst.op).shape;
    const bool value = shape == ir::Shape::kConst || shape == ir::Shape::kPure || shape == ir::Shape::kLoad;
    if (i + 1 == insts.size() ? shape != ir::Shape::kStore : !value) return false;
    for (const ValueId used : ir::UsedValues(program_, inst)) {
      const auto at = std::ranges::find(insts, used);
      if (at == insts.end()) return false;
      if (++uses[static_cast<size_t>(at - insts.begin())] > 1 && program_[used].op != OpKind::kConst) return false;
    }
  }
  return !insts.empty();
}

/// What is known behind a loop whose condition has just been evaluated; here, what is known where it holds. A loop that
/// counts its iterations is also left while its condition holds.
Flow Lowering::RefineWaysOut(ExprId condition, bool counts) {
  const Flow evaluated = flow_;
  Refine(condition, false);
  Flow behind = flow_;
  flow_ = evaluated;
  Refine(condition, true);
  if (counts) behind.JoinWith(flow_);
  return behind;
}

void Lowering::Rounds(const Statement& statement, uint32_t on_continue) {
  const bool is_for = statement.kind == StatementKind::kFor, is_do = statement.kind == StatementKind::kDo;
  std::optional<LoopProof> proof;
  if (!statement.loop_bound) {
    proof = Prove({.condition = statement.expression,
                   .step = is_for ? statement.step : ExprId(),
                   .body = {statement.then},
                   .tests_first = !is_do});
    if (!proof) diagnostics_.Report(statement.keyword, diag::HncUnboundedLoop, why_unbounded_);
  }
  const uint64_t rounds = std::max<uint64_t>(1, statement.loop_bound ? statement.loop_bound->rounds
                                                : proof              ? proof->count.iterations
                                                                     : 1);
  if (statement.loop_bound || proof) CheckRounds(statement.keyword, rounds);
  // A counter or a limit in memory may be forced from outside: then the rounds are counted all the same.
  const bool counts =
      statement.loop_bound || (proof && (proof->rests_on_memory || !IsLocalObject(proof->counter.object)));
  ir::Loop loop{.kind = counts ? ir::LoopBound::kGuard : ir::LoopBound::kProven,
                .bound = rounds,
                .budget = {},
                .condition = {},
                .body = builder_.NewRegion(),
                .step = {},
                .exhausted = {}};
  const ir::RegionId behind = builder_.region();
  ForgetWrites(statement.then);
  if (statement.expression.valid()) ForEachExpr(unit_, statement.expression, [&](ExprId id) { ForgetWritesOf(id); });
  if (is_for && statement.step.valid()) ForEachExpr(unit_, statement.step, [&](ExprId id) { ForgetWritesOf(id); });
  const Origin origin = counts ? Origin::kStored : Origin::kTested;
  const LoopCount* values = proof && proof->knows_values ? &proof->count : nullptr;
  Flow at_end = flow_;
  if (statement.expression.valid() && !is_do) {
    loop.condition = builder_.NewRegion();
    if (values != nullptr) flow_.Learn(proof->counter, values->at_test, origin);
    ConditionRegion(statement.expression, loop.condition);
    at_end = RefineWaysOut(statement.expression, counts);
  }
  if (values != nullptr && values->in_body) {
    const std::optional<Bounds> known = flow_.Find(proof->counter);
    const std::optional<Bounds> both = known ? Meet(*known, *values->in_body) : values->in_body;
    if (both) flow_.Narrow(proof->counter, *both);
  }
  const uint64_t outer_rounds = std::exchange(rounds_around_, std::min(rounds_around_ * rounds, kMostRounds + 1));
  builder_.SetRegion(loop.body);
  iterated_.push_back(loop.body);
  Lower(statement.then, false);
  iterated_.pop_back();
  PlaceLabel(on_continue);
  ValueId again;
  if (is_for && statement.step.valid() && flow_.reachable) {
    const ir::RegionId step = builder_.NewRegion();
    builder_.SetRegion(step);
    Execute(statement.step);
    if (IsSingleStore(step)) {
      loop.step = step;
    } else {
      std::vector<ir::InstId>& body = program_.regions[loop.body].insts;
      const std::vector<ir::InstId> insts = std::exchange(program_.regions[step].insts, {});
      body.insert(body.end(), insts.begin(), insts.end());
    }
    builder_.SetRegion(loop.body);
  } else if (is_do && flow_.reachable) {
    MarkText(statement.close, SubjectOf(statement), false);
    if (values != nullptr) flow_.Learn(proof->counter, values->at_test, origin);
    again = Condition(statement.expression);
    at_end = RefineWaysOut(statement.expression, counts);
  } else if (is_do) {
    at_end.reachable = false;
  }
  rounds_around_ = outer_rounds;
  if (statement.loop_bound) {
    loop.exhausted = builder_.NewRegion();
    builder_.SetRegion(loop.exhausted);
    RecordFault(Fault::kLoop);
    at_end.reachable = true;
  }
  builder_.SetRegion(behind);
  const ir::InstId id = builder_.LoopWith(loop);
  if (again.valid()) {
    builder_.SetRegion(loop.body);
    builder_.Exit(id, Pure(OpKind::kBitNot, {again}));
    builder_.SetRegion(behind);
  }
  if (!statement.expression.valid() && !statement.loop_bound) at_end.reachable = false;
  flow_ = at_end;
}

bool Lowering::IsLocalObject(ObjectId object) const {
  return objects_[object].kind == ObjectKind::kVariable && !facts_.IsInMemory(VariableId(objects_[object].index));
}

}  // namespace plcxx::hnc
