// Proofs that loops end (specification 6.6): a conjunct of the condition compares a counter with a limit, the counter
// changes by a constant exactly once in each round, and cannot step over the end of its type before the relation fails.

#include <algorithm>
#include <utility>

#include "transpiler/dialects/hnc/lowering_internal.h"

namespace plcxx::hnc {

namespace {

constexpr int64_t kMostCounted = 10'000'001;  // rounds that are counted out; more are refused anyway

struct Relation {
  ExprId counter;  // the lvalue
  ExprId limit;    // none: 0
  BinaryOp op = BinaryOp::kNotEqual;
  ExprId change;                // the condition itself changes the counter
  bool changes_before = false;  // ++n, --n: the value after the change is compared
  bool loses_sign = false;      // the counter is converted to an unsigned type of its width
};

BinaryOp Turned(BinaryOp op) {
  switch (op) {
    case BinaryOp::kLess:
      return BinaryOp::kGreater;
    case BinaryOp::kGreater:
      return BinaryOp::kLess;
    case BinaryOp::kLessEqual:
      return BinaryOp::kGreaterEqual;
    case BinaryOp::kGreaterEqual:
      return BinaryOp::kLessEqual;
    default:
      return op;
  }
}

bool Holds(BinaryOp op, int64_t a, int64_t b) {
  switch (op) {
    case BinaryOp::kLess:
      return a < b;
    case BinaryOp::kGreater:
      return a > b;
    case BinaryOp::kLessEqual:
      return a <= b;
    case BinaryOp::kGreaterEqual:
      return a >= b;
    case BinaryOp::kEqual:
      return a == b;
    default:
      return a != b;
  }
}

int64_t Wrap(int64_t value, const Bounds& type) {
  const int64_t count = type.high - type.low + 1;
  int64_t rest = (value - type.low) % count;
  if (rest < 0) rest += count;
  return type.low + rest;
}

int64_t CeilDivide(int64_t a, int64_t b) { return a <= 0 ? 0 : (a + b - 1) / b; }

/// Rounds of a counter that begins with `start` and is tested before each round; none: not shown to end.
std::optional<int64_t> CountRounds(BinaryOp op, const Bounds& start, const Bounds& limit, int64_t step,
                                   const Bounds& type, bool wraps) {
  switch (op) {
    case BinaryOp::kLess:
      if (step > 0 && limit.high - 1 + step <= type.high) return CeilDivide(limit.high - start.low, step);
      break;
    case BinaryOp::kLessEqual:
      if (step > 0 && limit.high + step <= type.high) return CeilDivide(limit.high - start.low + 1, step);
      break;
    case BinaryOp::kGreater:
      if (step < 0 && limit.low + 1 + step >= type.low) return CeilDivide(start.high - limit.low, -step);
      break;
    case BinaryOp::kGreaterEqual:
      if (step < 0 && limit.low + step >= type.low) return CeilDivide(start.high - limit.low + 1, -step);
      break;
    default:
      break;
  }
  if (start.IsOne() && limit.IsOne()) {
    int64_t value = start.low;
    for (int64_t rounds = 0; rounds < kMostCounted; ++rounds) {
      if (!Holds(op, value, limit.low)) return rounds;
      if (!wraps && !type.Holds(value + step)) return std::nullopt;
      value = Wrap(value + step, type);
    }
    return std::nullopt;
  }
  if (op == BinaryOp::kNotEqual && (step == 1 || step == -1)) {
    if (step > 0 && start.high <= limit.low) return limit.high - start.low;
    if (step < 0 && start.low >= limit.high) return start.high - limit.low;
    return type.high - type.low + 1;
  }
  return std::nullopt;
}

}  // namespace

/// The lvalue of the counter on one side of a comparison, and how the condition changes it.
static bool FindCounter(const Unit& unit, ExprId side, Relation& relation) {
  ExprId id = side;
  while (id.valid() && unit.expressions[id].kind == ExprKind::kConvert) {
    const Type& from = unit.TypeOf(unit.expressions[id].a);
    const Type& to = unit.TypeOf(id);
    if (!IsInteger(from) || !IsInteger(to) || to.bits < from.bits) return false;
    if (from.is_signed && !to.is_signed) relation.loses_sign = true;
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

Bounds Lowering::BoundsOfExpr(ExprId id) {
  const Expr& expr = ExprAt(id);
  if (!expr.type.valid() || !IsInteger(TypeAt(expr.type))) return {0, 0};
  const Type& type = TypeAt(expr.type);
  const Bounds all = BoundsOf(type);
  if (expr.constant) return {expr.constant->integer, expr.constant->integer};
  switch (expr.kind) {
    case ExprKind::kLoad: {
      const std::optional<StaticAddress> at = facts_.AddressOf(expr.a);
      if (!at) return all;
      const std::optional<Bounds> known = flow_.Find(Cell{at->object, at->offset, type.size});
      return known ? Meet(*known, all).value_or(all) : all;
    }
    case ExprKind::kConvert: {
      if (!IsInteger(unit_.TypeOf(expr.a))) return all;
      const Bounds from = BoundsOfExpr(expr.a);
      return from.Within(all) ? from : all;
    }
    case ExprKind::kBinary: {
      if (!IsInteger(unit_.TypeOf(expr.a))) return all;
      const Bounds a = BoundsOfExpr(expr.a), b = BoundsOfExpr(expr.b);
      const std::optional<Bounds> result = Apply(expr.binary, a, b, type);
      return result && result->Within(all) ? *result : all;
    }
    case ExprKind::kUnary: {
      if (expr.unary == UnaryOp::kNot) return {0, 1};
      const Bounds a = BoundsOfExpr(expr.a);
      const Bounds result = expr.unary == UnaryOp::kMinus        ? Bounds{-a.high, -a.low}
                            : expr.unary == UnaryOp::kComplement ? Bounds{~a.high, ~a.low}
                                                                 : a;
      return result.Within(all) ? result : all;
    }
    case ExprKind::kConditional: {
      const Flow before = flow_;
      Refine(expr.a, true);
      const Bounds then = BoundsOfExpr(expr.b);
      flow_ = before;
      Refine(expr.a, false);
      const Bounds otherwise = BoundsOfExpr(expr.c);
      flow_ = before;
      return Join(then, otherwise);
    }
    case ExprKind::kAnd:
    case ExprKind::kOr:
      return {0, 1};
    case ExprKind::kComma:
      return BoundsOfExpr(expr.b);
    case ExprKind::kAssign:
      return BoundsOfExpr(expr.b);
    case ExprKind::kCall: {
      const auto known = bounds_of_results_.find(expr.function.index);
      return known == bounds_of_results_.end() ? all : known->second;
    }
    default:
      return all;
  }
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
      ExprId id = expr.b;
      while (ExprAt(id).kind == ExprKind::kConvert) id = ExprAt(id).a;
      const Expr& sum = ExprAt(id);
      const bool minus = sum.kind == ExprKind::kBinary && sum.binary == BinaryOp::kSubtract;
      if (!minus && (sum.kind != ExprKind::kBinary || sum.binary != BinaryOp::kAdd)) return std::nullopt;
      for (const bool turned : {false, true}) {
        if (minus && turned) break;
        ExprId read = turned ? sum.b : sum.a;
        const Expr& step = ExprAt(turned ? sum.a : sum.b);
        while (ExprAt(read).kind == ExprKind::kConvert) read = ExprAt(read).a;
        if (ExprAt(read).kind != ExprKind::kLoad || facts_.AddressOf(ExprAt(read).a) != counter) continue;
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

/// Whether the change is executed in every round that comes to the next test.
bool Lowering::IsInEveryRound(ExprId change, const LoopShape& loop) const {
  if (loop.step.valid() && IsUnconditional(change, loop.step)) return true;
  // Statements one after the other, before anything that could go on with the next round.
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
    bool found = false, continues = false;
    ForEachStatement(unit_, id, [&](StatementId part) {
      const StatementKind kind = unit_.statements[part].kind;
      if (kind == StatementKind::kContinue || kind == StatementKind::kGoto) continues = true;
      if (kind == StatementKind::kLabel) found = true;
    });
    if (found) return false;  // jumped over
    const bool plain = statement.kind == StatementKind::kExpression;
    const bool head = statement.kind == StatementKind::kIf || statement.kind == StatementKind::kSwitch;
    if (plain || head) found = IsUnconditional(change, statement.expression);
    if (statement.kind == StatementKind::kFor)
      found = statement.first.valid() && IsUnconditional(change, statement.first);
    if (found) return true;
    if (continues) return false;
  }
  return false;
}

std::optional<LoopProof> Lowering::Prove(const LoopShape& loop) {
  why_unbounded_ = "its condition does not compare a counter with a limit";
  if (!loop.condition.valid()) {
    why_unbounded_ = "it has no condition";
    return std::nullopt;
  }
  // Everything that is executed in a round.
  std::vector<ExprId> parts;
  const auto collect = [&](ExprId id) { parts.push_back(id); };
  ForEachExpr(unit_, loop.condition, collect);
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
  std::vector<ExprId> conjuncts;
  ExprId left = loop.condition;
  for (; ExprAt(left).kind == ExprKind::kAnd; left = ExprAt(left).a) conjuncts.push_back(ExprAt(left).b);
  conjuncts.push_back(left);
  std::optional<LoopProof> best;
  for (size_t i = conjuncts.size(); i-- > 0;) {
    const std::optional<LoopProof> proof = ProveBy(conjuncts[i], loop, parts, declared);
    if (proof && (!best || proof->rounds < best->rounds)) best = proof;
  }
  return best;
}

/// How often the cell is stored into, and the only store; more than one, or one that is not plain: none.
std::optional<ExprId> Lowering::OnlyStore(const StaticAddress& counter, uint32_t size,
                                          const std::vector<ExprId>& parts) {
  std::optional<ExprId> only;
  const Cell cell{counter.object, counter.offset, size};
  for (const ExprId id : parts) {
    const Expr& expr = ExprAt(id);
    const bool stores =
        expr.kind == ExprKind::kAssign || expr.kind == ExprKind::kCompoundAssign || expr.kind == ExprKind::kIncrement;
    if (stores) {
      const std::optional<StaticAddress> at = facts_.AddressOf(expr.a);
      if (at && at->object != counter.object) continue;
      if (at) {
        const Cell other{at->object, at->offset, std::max(1u, TypeAt(ExprAt(expr.a).type).size)};
        if (!cell.Overlaps(other)) continue;
        if (*at != counter || TypeAt(ExprAt(expr.a).type).size != size) {
          why_unbounded_ = "its counter is changed in part";
          return std::nullopt;
        }
        if (only) {
          why_unbounded_ = "its counter is changed in two places";
          return std::nullopt;
        }
        only = id;
        continue;
      }
    }
    if (facts_.WritesOf(expr).Has(counter.object)) {
      why_unbounded_ = expr.kind == ExprKind::kCall ? "a function that it calls may change its counter"
                                                    : "a store through a pointer or an index may change its counter";
      return std::nullopt;
    }
  }
  if (!only) why_unbounded_ = "nothing in it changes its counter";
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
      const bool stores = store.kind == ExprKind::kAssign || store.kind == ExprKind::kCompoundAssign ||
                          store.kind == ExprKind::kIncrement;
      const std::optional<StaticAddress> to = stores ? facts_.AddressOf(store.a) : std::nullopt;
      if (at && to) {
        const Cell a{at->object, at->offset, std::max(1u, TypeAt(expr.type).size)};
        const Cell b{to->object, to->offset, std::max(1u, TypeAt(ExprAt(store.a).type).size)};
        unchanged = unchanged && !a.Overlaps(b);
        continue;
      }
      for (const ObjectId object : facts_.WritesOf(store).objects) unchanged = unchanged && !read.Has(object);
    }
  });
  return unchanged;
}

std::optional<LoopProof> Lowering::ProveBy(ExprId conjunct, const LoopShape& loop, const std::vector<ExprId>& parts,
                                           const ObjectSet& declared) {
  std::vector<Relation> candidates;
  ExprId root = conjunct;
  const Expr& expr = ExprAt(root);
  const bool compares = expr.kind == ExprKind::kBinary && expr.binary >= BinaryOp::kLess &&
                        expr.binary <= BinaryOp::kNotEqual && IsInteger(unit_.TypeOf(expr.a));
  if (compares) {
    for (const bool turned : {false, true}) {
      Relation relation{.counter = {},
                        .limit = turned ? expr.a : expr.b,
                        .op = turned ? Turned(expr.binary) : expr.binary,
                        .change = {}};
      if (FindCounter(unit_, turned ? expr.b : expr.a, relation)) candidates.push_back(relation);
    }
  } else {
    Relation relation;
    if (FindCounter(unit_, root, relation)) candidates.push_back(relation);
  }
  for (const Relation& relation : candidates) {
    const std::optional<StaticAddress> counter = facts_.AddressOf(relation.counter);
    const Type& type = TypeAt(ExprAt(relation.counter).type);
    const Expr& lvalue = ExprAt(relation.counter);
    const bool field = lvalue.kind == ExprKind::kMember &&
                       unit_.records[TypeAt(ExprAt(lvalue.a).type).record].members[lvalue.member].is_bit_field;
    if (!counter || field || !IsInteger(type)) continue;
    const std::optional<ExprId> store = OnlyStore(*counter, type.size, parts);
    if (!store || declared.Has(counter->object)) continue;
    const std::optional<int64_t> step = StepOf(ExprAt(*store), *counter);
    if (!step || *step == 0) {
      why_unbounded_ = "its counter does not change by a constant";
      continue;
    }
    const bool in_condition = relation.change.valid();
    if (in_condition ? *store != relation.change : !IsInEveryRound(*store, loop)) {
      why_unbounded_ = "its counter is not changed on every path";
      continue;
    }
    if (relation.limit.valid() && !IsUnchanged(relation.limit, parts)) {
      why_unbounded_ = "its limit changes in the loop";
      continue;
    }
    const Bounds all = BoundsOf(type);
    Bounds start = flow_.Find(Cell{counter->object, counter->offset, type.size}).value_or(all);
    if (relation.loses_sign && start.low < 0) {
      why_unbounded_ = "its counter may be negative and is compared without a sign";
      continue;
    }
    const bool moved = relation.changes_before || (!loop.tests_first && !in_condition);
    if (moved) {
      start = {start.low + *step, start.high + *step};
      if (!start.Within(all)) start = all;
    }
    const Bounds limit = relation.limit.valid() ? BoundsOfExpr(relation.limit) : Bounds{0, 0};
    std::optional<int64_t> rounds = CountRounds(relation.op, start, limit, *step, all, !type.is_signed);
    if (!rounds) {
      why_unbounded_ = "its counter may step over the end of its type before the condition fails";
      continue;
    }
    if (!loop.tests_first) ++*rounds;  // the first round is not tested
    LoopProof proof{.rounds = static_cast<uint64_t>(*rounds), .counter = {}, .in_body = {}};
    proof.counter = Cell{counter->object, counter->offset, type.size};
    if (!in_condition) {
      const bool up = relation.op == BinaryOp::kLess || relation.op == BinaryOp::kLessEqual;
      const bool down = relation.op == BinaryOp::kGreater || relation.op == BinaryOp::kGreaterEqual;
      if (loop.tests_first && up) proof.in_body = Bounds{start.low, std::max(start.high, limit.high)};
      if (loop.tests_first && down) proof.in_body = Bounds{std::min(start.low, limit.low), start.high};
      const bool counts_up = relation.op == BinaryOp::kNotEqual && *step > 0 && start.high <= limit.low;
      const bool counts_down = relation.op == BinaryOp::kNotEqual && *step < 0 && start.low >= limit.high;
      if (loop.tests_first && counts_up) proof.in_body = Bounds{start.low, limit.high};
      if (loop.tests_first && counts_down) proof.in_body = Bounds{limit.low, start.high};
    }
    return proof;
  }
  return std::nullopt;
}

}  // namespace plcxx::hnc
