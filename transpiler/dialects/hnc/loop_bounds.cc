// Proofs that loops end (specification 6.6): a conjunct of the condition compares a counter with a limit, the counter
// changes by a constant exactly once in each round, and cannot step over the end of its type before the relation fails.

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/loop_counts.h"
#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

namespace {

struct Relation {
  ExprId counter;  // the lvalue
  ExprId limit;    // none: 0
  BinaryOp op = BinaryOp::kNotEqual;
  ExprId change;                    // the condition itself changes the counter
  bool changes_before = false;      // ++n, --n: the value after the change is compared
  std::vector<Bounds> conversions;  // the types that it is converted to before it is compared
};

}  // namespace

/// The lvalue of the counter on one side of a comparison, and how the condition changes it.
static bool FindCounter(const Unit& unit, ExprId side, Relation& relation) {
  ExprId id = side;
  while (id.valid() && unit.expressions[id].kind == ExprKind::kConvert) {
    const Type& from = unit.TypeOf(unit.expressions[id].a);
    const Type& to = unit.TypeOf(id);
    if (!IsInteger(from) || !IsInteger(to) || to.bits < from.bits) return false;
    relation.conversions.insert(relation.conversions.begin(), BoundsOf(to));
    id = unit.expressions[id].a;
  }
  if (!id.valid()) return false;
  const Expr& expr = unit.expressions[id];
  if (!expr.type.valid() || !IsInteger(unit.types[expr.type])) return false;
  if (expr.kind == ExprKind::kLoad) {
    relation.counter = expr.a;
    return true;
  }
  if (expr.kind != ExprKind::kIncrement) return false;
  relation.counter = expr.a;
  relation.change = id;
  relation.changes_before =
      expr.increment == IncrementOp::kPreIncrement || expr.increment == IncrementOp::kPreDecrement;
  return true;
}

Bounds Lowering::BoundsOfExpr(ExprId id, Origin believed) {
  const Expr& expr = ExprAt(id);
  if (!expr.type.valid() || !IsInteger(TypeAt(expr.type))) return {0, 0};
  const Type& type = TypeAt(expr.type);
  const Bounds all = BoundsOf(type);
  if (expr.constant) return {expr.constant->integer, expr.constant->integer};
  switch (expr.kind) {
    case ExprKind::kLoad: {
      const std::optional<StaticAddress> at = facts_.AddressOf(expr.a);
      if (!at) return all;
      // The same bytes may have been looked at through a type with the other sign.
      const Cell cell{at->object, at->offset, type.size};
      const bool all_count = believed == Origin::kStored || IsLocalObject(at->object);
      const std::optional<Bounds> known = all_count ? flow_.Find(cell) : flow_.FindTested(cell);
      return known && known->Within(all) ? *known : all;
    }
    case ExprKind::kConvert: {
      if (!IsInteger(unit_.TypeOf(expr.a))) return all;
      const Bounds from = BoundsOfExpr(expr.a, believed);
      return from.Within(all) ? from : all;
    }
    case ExprKind::kBinary: {
      if (!IsInteger(unit_.TypeOf(expr.a))) return all;
      const Bounds a = BoundsOfExpr(expr.a, believed), b = BoundsOfExpr(expr.b, believed);
      const std::optional<Bounds> result = Apply(expr.binary, a, b, type);
      return result && result->Within(all) ? *result : all;
    }
    case ExprKind::kUnary: {
      if (expr.unary == UnaryOp::kNot) return {0, 1};
      const Bounds a = BoundsOfExpr(expr.a, believed);
      const Bounds result = expr.unary == UnaryOp::kMinus        ? Bounds{-a.high, -a.low}
                            : expr.unary == UnaryOp::kComplement ? Bounds{~a.high, ~a.low}
                                                                 : a;
      return result.Within(all) ? result : all;
    }
    case ExprKind::kConditional: {
      const Flow before = flow_;
      Refine(expr.a, true);
      const Bounds then = BoundsOfExpr(expr.b, believed);
      flow_ = before;
      Refine(expr.a, false);
      const Bounds otherwise = BoundsOfExpr(expr.c, believed);
      flow_ = before;
      return Join(then, otherwise);
    }
    case ExprKind::kAnd:
    case ExprKind::kOr:
      return {0, 1};
    case ExprKind::kCall: {
      const auto known = bounds_of_results_.find(expr.function.index);
      return known == bounds_of_results_.end() ? all : known->second;
    }
    default:
      return all;
  }
}

/// What conversions that keep the low `bits` are made of.
ExprId Lowering::Unwidened(ExprId id, uint32_t bits) const {
  while (ExprAt(id).kind == ExprKind::kConvert) {
    const Type& to = unit_.TypeOf(id);
    const Type& from = unit_.TypeOf(ExprAt(id).a);
    if (!IsInteger(to) || !IsInteger(from) || to.bits < bits || from.bits < bits) break;
    id = ExprAt(id).a;
  }
  return id;
}

/// The constant by which an expression changes the cell; none: otherwise, or not at all.
std::optional<int64_t> Lowering::StepOf(const Expr& expr, const StaticAddress& counter) const {
  switch (expr.kind) {
    case ExprKind::kIncrement: {
      const bool up = expr.increment == IncrementOp::kPreIncrement || expr.increment == IncrementOp::kPostIncrement;
      return up ? 1 : -1;
    }
    case ExprKind::kCompoundAssign: {
      const std::optional<Constant>& step = ExprAt(expr.b).constant;
      if (!step || !IsInteger(TypeAt(ExprAt(expr.b).type))) return std::nullopt;
      if (expr.binary == BinaryOp::kAdd) return step->integer;
      if (expr.binary == BinaryOp::kSubtract) return -step->integer;
      return std::nullopt;
    }
    case ExprKind::kAssign: {
      const ExprId id = Unwidened(expr.b, TypeAt(expr.type).bits);
      const Expr& sum = ExprAt(id);
      const bool minus = sum.kind == ExprKind::kBinary && sum.binary == BinaryOp::kSubtract;
      if (!minus && (sum.kind != ExprKind::kBinary || sum.binary != BinaryOp::kAdd)) return std::nullopt;
      for (const bool turned : {false, true}) {
        if (minus && turned) break;
        const ExprId read = Unwidened(turned ? sum.b : sum.a, TypeAt(expr.type).bits);
        const Expr& step = ExprAt(turned ? sum.a : sum.b);
        if (ExprAt(read).kind != ExprKind::kLoad || facts_.AddressOf(ExprAt(read).a) != counter) continue;
        if (TypeAt(ExprAt(read).type).bits != TypeAt(expr.type).bits) continue;
        if (!step.constant || !IsInteger(TypeAt(step.type))) continue;
        return minus ? -step.constant->integer : step.constant->integer;
      }
      return std::nullopt;
    }
    default:
      return std::nullopt;
  }
}

/// Whether the change is executed in every evaluation of `root`.
bool Lowering::IsUnconditional(ExprId change, ExprId root) const {
  std::vector<ExprId> open = {root};
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    if (!id.valid()) continue;
    if (id == change) return true;
    const Expr& expr = ExprAt(id);
    open.push_back(expr.a);
    const bool skips = expr.kind == ExprKind::kAnd || expr.kind == ExprKind::kOr || expr.kind == ExprKind::kConditional;
    if (skips) continue;
    open.push_back(expr.b);
    open.insert(open.end(), expr.arguments.begin(), expr.arguments.end());
  }
  return false;
}

/// Whether the change is executed exactly once in each iteration that comes to the next test.
bool Lowering::IsInEveryRound(ExprId change, const LoopShape& loop) const {
  if (loop.step.valid() && IsUnconditional(change, loop.step)) return true;
  for (const StatementId test : loop.tests) {
    if (IsUnconditional(change, unit_.statements[test].expression)) return !IsJumpedOver(test, loop);
  }
  // Statements one after the other.
  std::vector<StatementId> list(loop.body.rbegin(), loop.body.rend());
  while (!list.empty()) {
    const StatementId id = list.back();
    list.pop_back();
    if (!id.valid()) continue;
    const Statement& statement = unit_.statements[id];
    if (statement.kind == StatementKind::kCompound) {
      list.insert(list.end(), statement.body.rbegin(), statement.body.rend());
      continue;
    }
    if (statement.kind == StatementKind::kLabel) {
      list.push_back(statement.then);
      continue;
    }
    const bool plain = statement.kind == StatementKind::kExpression;
    const bool head = statement.kind == StatementKind::kIf || statement.kind == StatementKind::kSwitch;
    const bool first = statement.kind == StatementKind::kFor && statement.first.valid();
    if (((plain || head) && IsUnconditional(change, statement.expression)) ||
        (first && IsUnconditional(change, statement.first))) {
      return !IsJumpedOver(id, loop);
    }
  }
  return false;
}

/// Whether a jump inside of an iteration leads over the place, or back in front of it: `continue` of this loop, `goto`.
bool Lowering::IsJumpedOver(StatementId place, const LoopShape& loop) const {
  if (!loop.is_statement) return IsPassedBy(place, loop);  // `continue` belongs to a loop around it, and leaves it
  bool over = false;
  for (const StatementId part : loop.body) {
    if (!part.valid()) continue;
    ForEachStatement(unit_, part, [&](StatementId id) {
      const Statement& jump = unit_.statements[id];
      const bool in_front = IsBefore(id, place);
      if (jump.kind == StatementKind::kContinue) over = over || (in_front && !GoesToInnerLoop(id, loop));
      if (jump.kind != StatementKind::kGoto || !jump.label.valid()) return;
      const Label& label = unit_.labels[jump.label];
      const bool leads_in_front = label.statement == place || IsBefore(label.statement, place);
      if (IsPartOf(label.statement, loop.body)) over = over || in_front != leads_in_front;
    });
  }
  return over;
}

/// Whether the `continue` belongs to a loop in the body.
bool Lowering::GoesToInnerLoop(StatementId id, const LoopShape& loop) const {
  for (StatementId at = ParentOf(id); at.valid(); at = ParentOf(at)) {
    if (IsLoop(unit_.statements[at].kind)) {
      return std::ranges::find(loop.body, unit_.statements[at].then) == loop.body.end();
    }
  }
  return false;
}

void Lowering::WhyUnbounded(ProofStep step, std::string why) {
  if (why_unbounded_.empty() || step > failed_at_) {
    failed_at_ = step;
    why_unbounded_ = std::move(why);
  }
}

std::optional<LoopProof> Lowering::Prove(const LoopShape& loop) {
  why_unbounded_.clear();
  if (!loop.condition.valid()) {
    WhyUnbounded(ProofStep::kNothing, "it has no condition");
    return std::nullopt;
  }
  WhyUnbounded(ProofStep::kNothing, "its condition does not compare a counter with a limit");
  // Everything that is executed in a round.
  std::vector<ExprId> parts;
  const auto collect = [&](ExprId id) { parts.push_back(id); };
  if (loop.tests.empty()) ForEachExpr(unit_, loop.condition, collect);
  for (const StatementId test : loop.tests) ForEachExpr(unit_, unit_.statements[test].expression, collect);
  if (loop.step.valid()) ForEachExpr(unit_, loop.step, collect);
  for (const StatementId id : loop.body) ForEachExprIn(unit_, id, collect);
  // Declarations with initialisers are stores, too.
  ObjectSet declared;
  for (const StatementId id : loop.body) {
    ForEachStatement(unit_, id, [&](StatementId part) {
      for (const VariableId variable : unit_.statements[part].variables) {
        if (unit_.variables[variable].initialised && objects_.OfVariable(variable).valid()) {
          declared.Add(objects_.OfVariable(variable));
        }
      }
    });
  }
  // That none of `a || b` holds is what both of `!a && !b` say.
  std::vector<ExprId> conjuncts;
  const ExprKind joins = loop.holds ? ExprKind::kAnd : ExprKind::kOr;
  ExprId left = loop.condition;
  for (; ExprAt(left).kind == joins; left = ExprAt(left).a) conjuncts.push_back(ExprAt(left).b);
  conjuncts.push_back(left);
  std::optional<LoopProof> best;
  for (size_t i = conjuncts.size(); i-- > 0;) {
    const std::optional<LoopProof> proof = ProveBy(conjuncts[i], loop, parts, declared);
    if (proof && (!best || proof->count.iterations < best->count.iterations)) best = proof;
  }
  return best;
}

/// The only store into the cell; more than one, or one that is not plain: none.
std::optional<ExprId> Lowering::OnlyStore(const Cell& cell, const std::vector<ExprId>& parts) {
  std::optional<ExprId> only;
  for (const ExprId id : parts) {
    const Expr& expr = ExprAt(id);
    if (!facts_.MayChange(expr, cell)) continue;
    const bool stores =
        expr.kind == ExprKind::kAssign || expr.kind == ExprKind::kCompoundAssign || expr.kind == ExprKind::kIncrement;
    const std::optional<StaticAddress> at = stores ? facts_.AddressOf(expr.a) : std::nullopt;
    if (!at) {
      WhyUnbounded(ProofStep::kChange, expr.kind == ExprKind::kCall
                                           ? "a function that it calls may change its counter"
                                           : "a store through a pointer or an index may change its counter");
      return std::nullopt;
    }
    if (Cell{at->object, at->offset, TypeAt(ExprAt(expr.a).type).size} != cell) {
      WhyUnbounded(ProofStep::kChange, "its counter is changed in part");
      return std::nullopt;
    }
    if (only) {
      WhyUnbounded(ProofStep::kChange, "its counter is changed in two places");
      return std::nullopt;
    }
    only = id;
  }
  if (!only) WhyUnbounded(ProofStep::kCounter, "nothing in it changes its counter");
  return only;
}

/// Whether nothing in the loop changes what the limit reads.
bool Lowering::IsUnchanged(ExprId limit, const std::vector<ExprId>& parts) const {
  bool unchanged = true;
  ForEachExpr(unit_, limit, [&](ExprId id) {
    const Expr& expr = ExprAt(id);
    if (expr.kind == ExprKind::kCall || expr.kind == ExprKind::kAssign || expr.kind == ExprKind::kCompoundAssign ||
        expr.kind == ExprKind::kIncrement) {
      unchanged = false;
    }
    if (expr.kind != ExprKind::kLoad || !unchanged) return;
    const std::optional<StaticAddress> at = facts_.AddressOf(expr.a);
    const ObjectSet read = facts_.ObjectsOf(expr.a);
    for (const ExprId part : parts) {
      const Expr& store = ExprAt(part);
      if (at) {
        unchanged = unchanged && !facts_.MayChange(store, {at->object, at->offset, TypeAt(expr.type).size});
      } else {
        for (const ObjectId object : facts_.WritesOf(store).objects) unchanged = unchanged && !read.Has(object);
      }
    }
  });
  return unchanged;
}

std::optional<LoopProof> Lowering::ProveBy(ExprId conjunct, const LoopShape& loop, const std::vector<ExprId>& parts,
                                           const ObjectSet& declared) {
  ExprId root = conjunct;
  bool negated = !loop.holds;
  while (ExprAt(root).kind == ExprKind::kUnary && ExprAt(root).unary == UnaryOp::kNot) {
    negated = !negated;
    root = ExprAt(root).a;
  }
  const Expr& expr = ExprAt(root);
  const bool compares = expr.kind == ExprKind::kBinary && expr.binary >= BinaryOp::kLess &&
                        expr.binary <= BinaryOp::kNotEqual && IsInteger(unit_.TypeOf(expr.a));
  std::vector<Relation> candidates;
  const auto add = [&](ExprId side, ExprId limit, BinaryOp op) {
    Relation relation{.counter = {}, .limit = limit, .op = negated ? Negated(op) : op, .change = {}, .conversions = {}};
    if (FindCounter(unit_, side, relation)) candidates.push_back(relation);
  };
  if (compares) {
    add(expr.a, expr.b, expr.binary);
    add(expr.b, expr.a, Turned(expr.binary));
  } else {
    add(root, {}, BinaryOp::kNotEqual);
  }
  for (const Relation& relation : candidates) {
    const std::optional<StaticAddress> counter = facts_.AddressOf(relation.counter);
    const Type& type = TypeAt(ExprAt(relation.counter).type);
    const Expr& lvalue = ExprAt(relation.counter);
    const bool field = lvalue.kind == ExprKind::kMember &&
                       unit_.records[TypeAt(ExprAt(lvalue.a).type).record].members[lvalue.member].is_bit_field;
    if (!counter || field || !IsInteger(type)) continue;
    const Cell cell{counter->object, counter->offset, type.size};
    const std::optional<ExprId> store = OnlyStore(cell, parts);
    if (!store || declared.Has(counter->object)) continue;
    const std::optional<int64_t> step = StepOf(ExprAt(*store), *counter);
    if (!step || *step == 0) {
      WhyUnbounded(ProofStep::kChange, "its counter does not change by a constant");
      continue;
    }
    const bool in_condition = relation.change.valid();
    if (in_condition ? *store != relation.change : !IsInEveryRound(*store, loop)) {
      WhyUnbounded(ProofStep::kChange, "its counter is not changed on every path");
      continue;
    }
    if (relation.limit.valid() && !IsUnchanged(relation.limit, parts)) {
      WhyUnbounded(ProofStep::kLimit, "its limit changes in the loop");
      continue;
    }
    const Bounds all = BoundsOf(type);
    const std::optional<Bounds> known = flow_.Find(cell);
    const Bounds entered = known && known->Within(all) ? *known : all;
    const bool moved = relation.changes_before || (!loop.tests_first && !in_condition);
    Bounds start = moved ? Bounds{entered.low + *step, entered.high + *step} : entered;
    if (!start.Within(all)) start = entered.IsOne() ? Wrapped(start, all) : all;
    CountedLoop counted{.op = relation.op,
                        .start = start,
                        .limit = relation.limit.valid() ? BoundsOfExpr(relation.limit, Origin::kStored) : Bounds{0, 0},
                        .step = *step,
                        .type = all,
                        .wraps = !type.is_signed,
                        .conversions = relation.conversions};
    std::optional<LoopCount> count = Count(counted);
    if (!count) {
      WhyUnbounded(ProofStep::kRange, "its counter may step over the end of its type before the condition fails");
      continue;
    }
    LoopProof proof{.count = *count, .counter = cell, .knows_values = !in_condition};
    if (relation.limit.valid() && BoundsOfExpr(relation.limit, Origin::kTested) != counted.limit) {
      proof.rests_on_memory = true;
      const auto last = static_cast<int64_t>(count->iterations);
      const auto reached = [&](int64_t changes) {
        return Join(start, {start.low + *step * changes, start.high + *step * changes});
      };
      proof.count.at_test = reached(last);
      proof.count.in_body = last == 0 ? std::nullopt : std::optional(reached(last - 1));
      proof.knows_values = proof.knows_values && proof.count.at_test.Within(all);
    }
    if (!loop.tests_first) {  // the first iteration is not tested
      ++proof.count.iterations;
      proof.count.in_body = Join(proof.count.in_body.value_or(entered), entered);
    }
    return proof;
  }
  return std::nullopt;
}

}  // namespace plcxx::hnc
