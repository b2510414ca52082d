#include "transpiler/dialects/hnc/lowering/loop_bounds.h"

#include <algorithm>
#include <string>
#include <utility>

#include "transpiler/dialects/hnc/analysis/loop_counts.h"
#include "transpiler/dialects/hnc/lowering/intervals.h"
#include "transpiler/dialects/hnc/lowering/jumps.h"
#include "transpiler/dialects/hnc/lowering/loop_paths.h"
#include "transpiler/dialects/hnc/lowering/round_ways.h"
#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/support/check.h"

namespace plcxx::hnc {

/// A counter that is compared with a limit.
struct CounterRelation {
  ExprId counter;  // the lvalue
  ExprId limit;    // none: 0
  BinaryOp op = BinaryOp::kNotEqual;
  ExprId change;                    // the condition itself changes the counter: n++ < 5
  bool changes_before = false;      // ++n, --n: the value after the change is compared
  std::vector<Bounds> conversions;  // the types that it is converted to before it is compared
};

/// A side of the condition that has to hold for another iteration.
struct Conjunct {
  ExprId holds;
  std::vector<ExprId> before;  // evaluated first: the left sides of commas
};

namespace {

/// The lvalue of the counter on one side of a comparison, and how the condition changes it.
bool FindCounter(const Unit& unit, ExprId side, CounterRelation& relation) {
  ExprId id = side;
  while (id.valid() && unit.expressions[id].kind == ExprKind::kConvert) {
    const Type& from = unit.TypeOf(unit.expressions[id].a);
    const Type& to = unit.TypeOf(id);
    if (!IsInteger(to) || to.bits < from.bits) return false;
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

/// That none of `a || b` holds is what both of `!a && !b` say.
std::vector<Conjunct> ConjunctsOf(const Unit& unit, const LoopShape& loop) {
  const ExprKind joins = loop.holds ? ExprKind::kAnd : ExprKind::kOr;
  std::vector<Conjunct> conjuncts, open = {{.holds = loop.condition, .before = {}}};
  while (!open.empty()) {
    Conjunct one = std::move(open.back());
    open.pop_back();
    const Expr& expr = unit.expressions[one.holds];
    if (expr.kind == joins) {
      open.push_back({.holds = expr.a, .before = one.before});
      open.push_back({.holds = expr.b, .before = std::move(one.before)});
    } else if (expr.kind == ExprKind::kComma) {
      one.before.push_back(expr.a);
      open.push_back({.holds = expr.b, .before = std::move(one.before)});
    } else {
      conjuncts.push_back(std::move(one));
    }
  }
  return conjuncts;
}

/// A call whose result may differ though nothing changes its arguments.
bool MayDiffer(const Unit& unit, const Expr& expr) {
  if (expr.kind != ExprKind::kCall) return false;
  const std::optional<SystemFunction> system = unit.functions[expr.function].system;
  return !system || !RowOf(*system).operation.has_value();
}

/// The first function that an expression calls and that may return another value; empty: it calls none.
std::string CalledIn(const Unit& unit, ExprId expr) {
  std::string name;
  ForEachExpr(unit, expr, [&](ExprId id) {
    const Expr& call = unit.expressions[id];
    if (MayDiffer(unit, call) && name.empty()) name = unit.functions[call.function].name;
  });
  return name;
}

}  // namespace

void Refusal::Add(ProofStep step, std::string reason, source::Range in_condition) {
  if (!why.empty() && step <= failed_at) return;
  failed_at = step;
  why = std::move(reason);
  counter = in_condition;
}

/// What conversions that keep the low `bits` are made of.
ExprId LoopBounds::Unwidened(ExprId id, uint32_t bits) const {
  while (ExprAt(id).kind == ExprKind::kConvert) {
    const Type& to = unit_.TypeOf(id);
    const Type& from = unit_.TypeOf(ExprAt(id).a);
    if (!IsInteger(to) || !IsInteger(from) || to.bits < bits || from.bits < bits) break;
    id = ExprAt(id).a;
  }
  return id;
}

/// The constant by which an expression changes the cell; none: otherwise, or not at all.
std::optional<int64_t> LoopBounds::StepOf(const Expr& expr, const Cell& counter) const {
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
        if (ExprAt(read).kind != ExprKind::kLoad || facts_.IntegerCellOf(ExprAt(read).a) != counter) continue;
        if (!step.constant || !IsInteger(TypeAt(step.type))) continue;
        return minus ? -step.constant->integer : step.constant->integer;
      }
      return std::nullopt;
    }
    case ExprKind::kPoison:
    case ExprKind::kConstant:
    case ExprKind::kString:
    case ExprKind::kVariable:
    case ExprKind::kFunction:
    case ExprKind::kLoad:
    case ExprKind::kDecay:
    case ExprKind::kConvert:
    case ExprKind::kCast:
    case ExprKind::kNull:
    case ExprKind::kUnary:
    case ExprKind::kBinary:
    case ExprKind::kAnd:
    case ExprKind::kOr:
    case ExprKind::kConditional:
    case ExprKind::kComma:
    case ExprKind::kAddress:
    case ExprKind::kDereference:
    case ExprKind::kIndex:
    case ExprKind::kMember:
    case ExprKind::kCall:
      return std::nullopt;
  }
  PLCXX_UNREACHABLE();
}

LoopBounds::Iteration LoopBounds::IterationOf(const LoopShape& loop) const {
  Iteration iteration{.loop = loop, .parts = {}, .declared = {}};
  const auto collect = [&](ExprId id) { iteration.parts.push_back(id); };
  if (loop.tests.empty()) ForEachExpr(unit_, loop.condition, collect);
  for (const StatementId test : loop.tests) ForEachExpr(unit_, unit_.statements[test].expression, collect);
  if (loop.step.valid()) ForEachExpr(unit_, loop.step, collect);
  for (const StatementId id : loop.body) ForEachExprIn(unit_, id, collect);
  for (const StatementId id : loop.body) {
    ForEachStatement(unit_, id, [&](StatementId part) {
      for (const VariableId variable : unit_.statements[part].variables) {
        if (unit_.variables[variable].initialised && objects_.OfVariable(variable).valid()) {
          iteration.declared.Add(objects_.OfVariable(variable));
        }
      }
    });
  }
  return iteration;
}

std::optional<LoopProof> LoopBounds::Prove(const LoopShape& loop, Refusal& refusal) {
  if (!loop.condition.valid()) {
    refusal.Add(ProofStep::kNothing, "it has no condition");
    return std::nullopt;
  }
  refusal.Add(ProofStep::kNothing, "its condition does not compare a counter with a limit");
  const Iteration iteration = IterationOf(loop);
  std::vector<Conjunct> conjuncts = ConjunctsOf(unit_, loop);
  std::optional<LoopProof> best;
  for (size_t i = conjuncts.size(); i-- > 0;) {
    const std::optional<LoopProof> proof = ProveBy(conjuncts[i], iteration, refusal);
    if (proof && (!best || proof->count.iterations < best->count.iterations)) best = proof;
  }
  return best;
}

/// The stores into the cell; one that is not plain: none.
std::optional<std::vector<ExprId>> LoopBounds::StoresInto(const Cell& cell, const std::vector<ExprId>& parts,
                                                          Refusal& refusal) const {
  std::vector<ExprId> found;
  for (const ExprId id : parts) {
    const Expr& expr = ExprAt(id);
    if (!facts_.MayChange(expr, cell)) continue;
    const bool stores =
        expr.kind == ExprKind::kAssign || expr.kind == ExprKind::kCompoundAssign || expr.kind == ExprKind::kIncrement;
    const std::optional<StaticAddress> at = stores ? facts_.AddressOf(expr.a) : std::nullopt;
    if (!at) {
      refusal.Add(ProofStep::kChange, expr.kind == ExprKind::kCall
                                          ? "a function that it calls may change its counter"
                                          : "a store through a pointer or an index may change its counter");
      return std::nullopt;
    }
    if (facts_.IntegerCellOf(expr.a) != cell) {
      refusal.Add(ProofStep::kChange, "its counter is changed in part");
      return std::nullopt;
    }
    found.push_back(id);
  }
  if (found.empty()) {
    refusal.Add(ProofStep::kCounter, "nothing in it changes its counter");
    return std::nullopt;
  }
  return found;
}

/// The constant by which each way through an iteration changes the counter once. `in_comparison` is the n++ of `n++ <
/// 5`, `before` what the condition has evaluated in front of the comparison.
std::optional<LoopBounds::Change> LoopBounds::ChangeOf(const Cell& counter, ExprId in_comparison,
                                                       const std::vector<ExprId>& before, const Iteration& iteration,
                                                       Refusal& refusal) const {
  const LoopShape& loop = iteration.loop;
  const auto refuse = [&](const char* why) {
    refusal.Add(ProofStep::kChange, why);
    return std::nullopt;
  };
  const std::optional<std::vector<ExprId>> stores = StoresInto(counter, iteration.parts, refusal);
  if (!stores) return std::nullopt;
  const auto count_in = [&](ExprId root) {
    size_t count = 0;
    ForEachExpr(unit_, root, [&](ExprId id) { count += std::ranges::count(*stores, id); });
    return count;
  };
  size_t moved = 0;
  for (const ExprId id : before) moved += count_in(id);
  Ways ways{.once = true};
  if (in_comparison.valid()) {
    if (stores->size() > 1) ways = {.more = true};
  } else if (loop.is_statement) {
    ways = RoundWays(unit_, *stores).Of(loop);
    if (count_in(loop.condition) != moved || (moved != 0 && moved != stores->size())) ways.never = true;
  } else if (stores->size() > 1) {
    ways = {.more = true};
  } else if (!paths_.IsInEveryIteration(stores->front(), loop)) {
    ways = {.never = true};
  }
  if (ways.more && stores->size() > 1) return refuse("its counter is changed in two places");
  const std::optional<int64_t> step = StepOf(ExprAt(stores->front()), counter);
  const auto is_same = [&](ExprId id) { return StepOf(ExprAt(id), counter) == step; };
  if (!step || *step == 0 || !std::ranges::all_of(*stores, is_same)) {
    return refuse("its counter does not change by a constant");
  }
  if (ways.never || ways.more) return refuse("its counter is not changed on every path");
  return Change{.step = *step, .in_condition = in_comparison.valid() || moved != 0, .is_before = moved != 0};
}

/// Whether nothing in the loop changes what the limit reads.
bool LoopBounds::IsUnchanged(ExprId limit, const std::vector<ExprId>& parts) const {
  bool unchanged = true;
  ForEachExpr(unit_, limit, [&](ExprId id) {
    const Expr& expr = ExprAt(id);
    if (MayDiffer(unit_, expr) || expr.kind == ExprKind::kAssign || expr.kind == ExprKind::kCompoundAssign ||
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

/// Whether a side of a comparison is the result of an operator, and no cast alone.
bool LoopBounds::IsComputed(ExprId side) const {
  while (ExprAt(side).kind == ExprKind::kConvert) side = ExprAt(side).a;
  return ExprAt(side).kind == ExprKind::kBinary;
}

/// Where a side of a comparison that is more than a counter reads a variable that the loop changes: the i of `i + 1 <
/// n`. Empty: nowhere.
source::Range LoopBounds::CounterInside(ExprId side, const std::vector<ExprId>& parts) const {
  source::Range found;
  CounterRelation alone;
  if (FindCounter(unit_, side, alone)) return found;
  ForEachExpr(unit_, side, [&](ExprId id) {
    const Expr& read = ExprAt(id);
    if (read.kind != ExprKind::kLoad || found.begin != found.end) return;
    const std::optional<Cell> cell = facts_.IntegerCellOf(read.a);
    const auto changes = [&](ExprId part) {
      const Expr& store = ExprAt(part);
      const bool stores = store.kind == ExprKind::kAssign || store.kind == ExprKind::kCompoundAssign ||
                          store.kind == ExprKind::kIncrement;
      return stores && facts_.IntegerCellOf(store.a) == cell;
    };
    if (cell && std::ranges::any_of(parts, changes)) found = read.range;
  });
  return found;
}

/// A comparison says that a counter is compared; else the condition itself is one, compared with 0.
std::vector<CounterRelation> LoopBounds::RelationsOf(const Expr& expr, ExprId id, bool negated) const {
  std::vector<CounterRelation> relations;
  const auto add = [&](ExprId side, ExprId limit, BinaryOp op) {
    CounterRelation relation{
        .counter = {}, .limit = limit, .op = negated ? Negated(op) : op, .change = {}, .conversions = {}};
    if (FindCounter(unit_, side, relation)) relations.push_back(relation);
  };
  if (IsIntegerComparison(expr)) {
    add(expr.a, expr.b, expr.binary);
    add(expr.b, expr.a, Turned(expr.binary));
  } else {
    add(id, {}, BinaryOp::kNotEqual);
  }
  return relations;
}

bool LoopBounds::IsIntegerComparison(const Expr& expr) const {
  return expr.kind == ExprKind::kBinary && IsComparison(expr.binary) && IsInteger(unit_.TypeOf(expr.a));
}

/// Of a comparison whose sides are more than a counter.
void LoopBounds::RefuseCountersInside(const Expr& comparison, const Iteration& iteration, Refusal& refusal) const {
  for (const ExprId side : {comparison.a, comparison.b}) {
    const source::Range read = CounterInside(side, iteration.parts);
    if (read.begin == read.end) continue;
    refusal.Add(ProofStep::kSide,
                "it compares '" + std::string(sources_.Text(ExprAt(side).range)) + "' and not '" +
                    std::string(sources_.Text(read)) + "' alone" +
                    (IsComputed(side) ? ": write the rest on the other side" : ""),
                read);
  }
}

std::optional<LoopProof> LoopBounds::ProveBy(const Conjunct& conjunct, const Iteration& iteration, Refusal& refusal) {
  ExprId root = conjunct.holds;
  bool negated = !iteration.loop.holds;
  while (ExprAt(root).kind == ExprKind::kUnary && ExprAt(root).unary == UnaryOp::kNot) {
    negated = !negated;
    root = ExprAt(root).a;
  }
  const Expr& expr = ExprAt(root);
  const bool compares = IsIntegerComparison(expr);
  const std::vector<CounterRelation> relations = RelationsOf(expr, root, negated);
  if (compares) RefuseCountersInside(expr, iteration, refusal);
  for (const CounterRelation& relation : relations) {
    const std::optional<Cell> counter = facts_.IntegerCellOf(relation.counter);
    if (!counter) continue;
    Refusal own;
    const std::optional<Change> change = ChangeOf(*counter, relation.change, conjunct.before, iteration, own);
    if (!change) {
      // A flag beside a comparison is no counter that somebody has in mind.
      const bool is_flag = !compares && !relation.change.valid();
      refusal.Add(is_flag ? ProofStep::kCounter : own.failed_at, own.why, ExprAt(relation.counter).range);
    }
    // Declarations with initialisers are stores, too.
    if (!change || iteration.declared.Has(counter->object)) continue;
    if (!CheckLimit(relation, iteration, refusal)) continue;
    std::optional<LoopProof> proof = ProveWith(relation, *counter, *change, iteration.loop, refusal);
    if (!proof) continue;
    proof->is_entered = proof->is_entered && conjunct.holds == iteration.loop.condition;
    return proof;
  }
  return std::nullopt;
}

bool LoopBounds::CheckLimit(const CounterRelation& relation, const Iteration& iteration, Refusal& refusal) const {
  if (!relation.limit.valid() || IsUnchanged(relation.limit, iteration.parts)) return true;
  const std::string called = CalledIn(unit_, relation.limit);
  refusal.Add(ProofStep::kLimit,
              called.empty() ? "its limit changes in the loop"
                             : "its limit calls '" + called +
                                   "' in each round: keep the result in a variable in front of the loop",
              ExprAt(relation.counter).range);
  return false;
}

/// The values that the counter has where it is compared for the first time. `entered`: in front of the loop.
Bounds LoopBounds::StartOf(const CounterRelation& relation, const Change& change, const Bounds& entered,
                           const LoopShape& loop) const {
  const Bounds all = BoundsOf(TypeAt(ExprAt(relation.counter).type));
  const bool moved = relation.changes_before || change.is_before || (!loop.tests_first && !change.in_condition);
  const Bounds start = moved ? Bounds{entered.low + change.step, entered.high + change.step} : entered;
  if (start.Within(all)) return start;
  return entered.IsOne() ? Wrapped(start, all) : all;
}

std::optional<LoopProof> LoopBounds::ProveWith(const CounterRelation& relation, const Cell& counter,
                                               const Change& change, const LoopShape& loop, Refusal& refusal) {
  const Type& type = TypeAt(ExprAt(relation.counter).type);
  const Bounds all = BoundsOf(type);
  const std::optional<Bounds> known = flow_.Find(counter);
  const Bounds entered = known && known->Within(all) ? *known : all;
  const int64_t step = change.step;
  const Bounds start = StartOf(relation, change, entered, loop);
  const CountedLoop counted{
      .op = relation.op,
      .start = start,
      .limit = relation.limit.valid() ? intervals_.BoundsOfExpr(relation.limit, Origin::kDeclared) : Bounds{0, 0},
      .step = step,
      .type = all,
      .wraps = !type.is_signed,
      .conversions = relation.conversions};
  const std::optional<LoopCount> count = Count(counted);
  if (!count) {
    refusal.Add(ProofStep::kRange, "its counter may step over the end of its type before the condition fails",
                ExprAt(relation.counter).range);
    return std::nullopt;
  }
  LoopProof proof{.count = *count, .counter = counter, .knows_values = !change.in_condition};
  proof.is_entered = IsEntered(counted);
  if (relation.limit.valid() && intervals_.BoundsOfExpr(relation.limit, Origin::kTested) != counted.limit) {
    proof.rests_on_memory = true;
    const auto last = static_cast<int64_t>(count->iterations);
    const auto reached = [&](int64_t changes) {
      return Join(start, {start.low + step * changes, start.high + step * changes});
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

std::optional<uint64_t> LoopBounds::IterationsOfGoto(StatementId label, StatementId jump) {
  std::vector<StatementId> body, heads;
  std::vector<RoundTest> tests;
  if (!paths_.PathBack(label, jump, body, tests)) return std::nullopt;
  for (const RoundTest& test : tests) heads.push_back(test.test);
  std::optional<uint64_t> best;
  Refusal refusal;  // the message of a goto gives no reason
  for (size_t i = 0; i < tests.size(); ++i) {
    const bool is_first = i == 0 && tests[i].in_front == 0;
    const bool is_last = i + 1 == tests.size() && tests[i].in_front == body.size();
    const LoopShape loop{.condition = unit_.statements[tests[i].test].expression,
                         .step = {},
                         .body = body,
                         .tests_first = is_first,
                         .holds = tests[i].holds,
                         .is_statement = false,
                         .region = {jumps_.OrderOf(label), jumps_.OrderOf(jump)},
                         .tests = heads};
    const std::optional<LoopProof> proof = paths_.IsPassedBy(tests[i].test, loop) ? std::nullopt : Prove(loop, refusal);
    if (!proof) continue;
    // The test may come before the first change: one iteration more at most.
    const uint64_t rounds = proof->count.iterations + (is_first || !is_last ? 1 : 0);
    if (!best || rounds < *best) best = rounds;
  }
  return best;
}

}  // namespace plcxx::hnc
