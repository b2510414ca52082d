// Warnings about single expressions: W3, W10 to W12, W14 to W17, W23 (specification 10.3).

#include <algorithm>
#include <set>

#include "transpiler/dialects/hnc/analysis/checks.h"
#include "transpiler/dialects/hnc/analysis/ranges.h"
#include "transpiler/dialects/hnc/analysis/stores.h"
#include "transpiler/dialects/hnc/syntax/walk.h"

namespace plcxx::hnc {
namespace {

constexpr int kBoundsDepth = 64;  // of an expression whose bounds are looked at

bool Compares(const Expr& expr) { return expr.kind == ExprKind::kBinary && IsComparison(expr.binary); }

/// Of a comparison: whether it holds for all values within these bounds, or for none.
std::optional<bool> OutcomeOf(BinaryOp op, const Bounds& a, const Bounds& b) {
  const auto outcome = [](bool always, bool never) {
    return always ? std::optional(true) : never ? std::optional(false) : std::nullopt;
  };
  const bool apart = a.high < b.low || b.high < a.low, same = a.IsOne() && a == b;
  switch (op) {
    case BinaryOp::kLess:
      return outcome(a.high < b.low, a.low >= b.high);
    case BinaryOp::kGreater:
      return outcome(a.low > b.high, a.high <= b.low);
    case BinaryOp::kLessEqual:
      return outcome(a.high <= b.low, a.low > b.high);
    case BinaryOp::kGreaterEqual:
      return outcome(a.low >= b.high, a.high < b.low);
    case BinaryOp::kEqual:
      return outcome(same, apart);
    case BinaryOp::kNotEqual:
      return outcome(apart, same);
#define HNC_COMPARISON(...)
#define HNC_BINARY(Key, ...) case BinaryOp::k##Key:
#include "transpiler/dialects/hnc/syntax/binary_operators.def"
      return std::nullopt;
  }
  return std::nullopt;
}

class ExpressionChecks {
 public:
  explicit ExpressionChecks(const CheckContext& context) : context_(context), unit_(context.unit) {}

  void Run() {
    for (const FunctionId id : unit_.definitions) {
      ForEachStatement(unit_, unit_.functions[id].body, [&](StatementId statement) { StatementRules(statement); });
      ForEachExprIn(unit_, unit_.functions[id].body, [&](ExprId expr) {
        if (IsReal(At(expr).type)) NoteReal(At(expr).range);
        ExpressionRules(expr);
      });
    }
    for (const Variable& variable : unit_.variables) {
      if (variable.storage != Storage::kGlobal && variable.storage != Storage::kStaticLocal) continue;
      for (const InitialValue& initial : variable.initial) {
        if (initial.value.valid()) ForEachExpr(unit_, initial.value, [&](ExprId expr) { ExpressionRules(expr); });
      }
    }
    FloatingPoint();
  }

 private:
  const Expr& At(ExprId id) const { return unit_.expressions[id]; }
  bool HasType(ExprId id) const { return id.valid() && At(id).type.valid(); }

  ExprId Unconverted(ExprId id) const {
    while (id.valid() && At(id).kind == ExprKind::kConvert && At(id).is_implicit) id = At(id).a;
    return id;
  }

  void StatementRules(StatementId id) {
    const Statement& statement = unit_.statements[id];
    // What a statement stores at its top comes after all that it reads.
    const auto order = [&](ExprId expr) {
      if (context_.facts.effects().HasInnerStores(id)) Order(expr);
    };
    switch (statement.kind) {
      case StatementKind::kExpression:
        NoEffect(statement.expression);
        order(statement.expression);
        break;
      case StatementKind::kCompound:
        for (size_t i = 0; i + 1 < statement.body.size(); ++i) {
          EmptyLoop(unit_.statements[statement.body[i]], unit_.statements[statement.body[i + 1]]);
        }
        break;
      case StatementKind::kIf:
        EmptyBody(statement);
        EmptyElse(statement);
        [[fallthrough]];
      case StatementKind::kWhile:
      case StatementKind::kDo:
        Condition(statement.expression);
        order(statement.expression);
        break;
      case StatementKind::kFor:
        Condition(statement.expression);
        for (const ExprId expr : {statement.first, statement.expression, statement.step}) order(expr);
        if (statement.first.valid()) NoEffect(statement.first);
        if (statement.step.valid()) NoEffect(statement.step);
        break;
      case StatementKind::kSwitch:
        Cases(statement);
        order(statement.expression);
        break;
      case StatementKind::kReturn:
        order(statement.expression);
        break;
      case StatementKind::kDeclaration:
      case StatementKind::kEmpty:
      case StatementKind::kGoto:
      case StatementKind::kContinue:
      case StatementKind::kBreak:
      case StatementKind::kLabel:
      case StatementKind::kCase:
      case StatementKind::kDefault:
      case StatementKind::kCriticalEnter:
      case StatementKind::kCriticalLeave:
        break;
    }
  }

  /// W29 of an else, or of a loop with a block after it.
  void EmptyElse(const Statement& statement) {
    if (!statement.otherwise.valid() || statement.macro.valid()) return;
    const Statement& otherwise = unit_.statements[statement.otherwise];
    if (otherwise.kind != StatementKind::kEmpty || otherwise.macro.valid()) return;
    if (!OnlyBlanksBetween(statement.otherwise_keyword, otherwise.range)) return;
    context_.diagnostics.Report(otherwise.range, diag::HncEmptyElse);
  }

  void EmptyLoop(const Statement& loop, const Statement& next) {
    const bool is_loop = loop.kind == StatementKind::kFor || loop.kind == StatementKind::kWhile;
    if (!is_loop || !loop.then.valid() || loop.macro.valid() || next.kind != StatementKind::kCompound) return;
    const Statement& then = unit_.statements[loop.then];
    if (then.kind != StatementKind::kEmpty || then.macro.valid()) return;
    if (OnlyBlanksBetween(loop.head, then.range)) context_.diagnostics.Report(then.range, diag::HncEmptyLoop);
  }

  /// Is the second a ';' on the line on which the first ends, with nothing in between?
  bool OnlyBlanksBetween(source::Range first, source::Range second) const {
    if (second.begin < first.end) return false;
    const std::string_view between = context_.sources.Text({first.end, second.begin});
    return between.find_first_not_of(" \t") == std::string_view::npos &&
           context_.sources.Text({second.begin, second.begin + 1}) == ";";
  }

  /// W29: nothing but blanks in front of the ';', in the same line. A macro that is empty may be there on purpose.
  void EmptyBody(const Statement& statement) {
    const Statement& then = unit_.statements[statement.then];
    if (then.kind != StatementKind::kEmpty || then.macro.valid() || statement.macro.valid()) return;
    if (statement.otherwise.valid() || !OnlyBlanksBetween(statement.head, then.range)) return;
    context_.diagnostics.Report(then.range, diag::HncEmptyBody);
  }

  /// W3
  void NoEffect(ExprId id) {
    if (unit_.faulty || !HasType(id) || At(id).kind == ExprKind::kPoison) return;
    const Type& type = unit_.TypeOf(id);
    if (type.kind == TypeKind::kVoid) return;
    if (IsStore(At(id)) || At(id).kind == ExprKind::kCall) return;
    bool effect = false;
    ForEachExpr(unit_, id, [&](ExprId part) {
      const ExprKind kind = At(part).kind;
      effect = effect || IsStore(At(part)) || kind == ExprKind::kCall || kind == ExprKind::kPoison;
    });
    if (!effect) {
      context_.diagnostics.Report(At(id).range, diag::HncNoEffect, context_.sources.Text(At(id).range));
    }
  }

  /// W11
  void AssignmentInstead(ExprId id) {
    id = Unconverted(id);
    if (!HasType(id)) return;
    if (At(id).kind == ExprKind::kAssign && !At(id).parenthesized) {
      context_.diagnostics.Report(At(id).range, diag::HncAssignmentAsCondition);
    }
  }

  /// W30: `Y[0] && 0x0F`. Not 0 and 1, which switch a part of a condition on or off, nor what a macro says.
  void LogicalConstant(const Expr& expr, ExprId side) {
    const ExprId operand = Unconverted(side);
    if (!HasType(operand) || !At(operand).constant || At(operand).macro.valid()) return;
    const std::string_view text = context_.sources.Text(At(operand).range);
    if (text.empty() || text.front() < '0' || text.front() > '9') return;
    const int64_t value = At(operand).constant->integer;
    if (value == 0 || value == 1) return;
    const bool conjunction = expr.kind == ExprKind::kAnd;
    context_.diagnostics.Report(At(operand).range, diag::HncLogicalConstant, conjunction ? "&&" : "||", text,
                                conjunction ? "&" : "|");
  }

  void ExpressionRules(ExprId id) {
    const Expr& expr = At(id);
    if (!expr.type.valid()) return;
    switch (expr.kind) {
      case ExprKind::kBinary:
        Precedence(expr);
        AlwaysTheSame(expr);
        break;
      case ExprKind::kAnd:
      case ExprKind::kOr:
        Condition(expr.a);
        Condition(expr.b);
        LogicalConstant(expr, expr.a);
        LogicalConstant(expr, expr.b);
        break;
      case ExprKind::kConditional:
        Condition(expr.a);
        break;
      case ExprKind::kUnary:
        if (expr.unary == UnaryOp::kNot) TruthAlwaysTheSame(expr.a);
        break;
      case ExprKind::kConvert:
        LosesDigits(expr);
        break;
      case ExprKind::kCall:
        AbsOfLong(expr);
        break;
      case ExprKind::kLoad:
        OutsideTable(expr);
        break;
      case ExprKind::kPoison:
      case ExprKind::kConstant:
      case ExprKind::kString:
      case ExprKind::kVariable:
      case ExprKind::kFunction:
      case ExprKind::kDecay:
      case ExprKind::kCast:
      case ExprKind::kNull:
      case ExprKind::kComma:
      case ExprKind::kAssign:
      case ExprKind::kCompoundAssign:
      case ExprKind::kIncrement:
      case ExprKind::kAddress:
      case ExprKind::kDereference:
      case ExprKind::kIndex:
      case ExprKind::kMember:
        break;
    }
  }

  /// W12
  void Precedence(const Expr& expr) {
    if (expr.binary != BinaryOp::kBitAnd && expr.binary != BinaryOp::kBitOr && expr.binary != BinaryOp::kBitXor) return;
    for (const ExprId side : {expr.a, expr.b}) {
      const ExprId operand = Unconverted(side);
      if (!HasType(operand) || !Compares(At(operand)) || At(operand).parenthesized) continue;
      context_.diagnostics.Report(expr.op.begin != 0 ? expr.op : expr.range, diag::HncPrecedence,
                                  Info(expr.binary).sign, Info(At(operand).binary).sign);
      return;
    }
  }

  /// What the types and constants of an expression allow, whatever the program does.
  Bounds PossibleBounds(ExprId id, int depth = 0) const {
    const Expr& expr = At(id);
    const Type& type = unit_.types[expr.type];
    const Bounds all = BoundsOf(type);
    if (expr.constant) return {expr.constant->integer, expr.constant->integer};
    if (depth > kBoundsDepth) return all;
    if (expr.kind == ExprKind::kConvert && IsInteger(unit_.TypeOf(expr.a))) {
      const Bounds from = PossibleBounds(expr.a, depth + 1);
      return from.Within(all) ? from : all;
    }
    if (expr.kind == ExprKind::kBinary && HasType(expr.a) && IsInteger(unit_.TypeOf(expr.a)) && HasType(expr.b) &&
        IsInteger(unit_.TypeOf(expr.b))) {
      const auto result =
          Apply(expr.binary, PossibleBounds(expr.a, depth + 1), PossibleBounds(expr.b, depth + 1), type);
      if (result && result->Within(all)) return *result;
    }
    if (expr.kind == ExprKind::kAnd || expr.kind == ExprKind::kOr) return {0, 1};
    if (expr.kind == ExprKind::kUnary && expr.unary == UnaryOp::kNot) return {0, 1};
    return all;
  }

  /// W16
  void AlwaysTheSame(const Expr& expr) {
    if (!Compares(expr) || expr.constant || !HasType(expr.a) || !HasType(expr.b)) return;
    if (!IsInteger(unit_.TypeOf(expr.a)) || !IsInteger(unit_.TypeOf(expr.b))) return;
    const Bounds a = PossibleBounds(expr.a), b = PossibleBounds(expr.b);
    const std::optional<bool> outcome = OutcomeOf(expr.binary, a, b);
    if (outcome) context_.diagnostics.Report(expr.range, diag::HncConditionConstant, *outcome ? "true" : "false");
  }

  /// W16 of what is a condition without a comparison, such as a mask that the operand's type has no bit of.
  void TruthAlwaysTheSame(ExprId id) {
    id = Unconverted(id);
    if (!HasType(id) || !IsInteger(unit_.TypeOf(id))) return;
    const Expr& expr = At(id);
    if (expr.kind != ExprKind::kBinary || Compares(expr) || expr.constant) return;
    const Bounds bounds = PossibleBounds(id);
    const std::optional<bool> outcome = OutcomeOf(BinaryOp::kNotEqual, bounds, {0, 0});
    if (outcome) context_.diagnostics.Report(expr.range, diag::HncConditionConstant, *outcome ? "true" : "false");
  }

  /// Where only zero or not zero counts.
  void Condition(ExprId id) {
    AssignmentInstead(id);
    TruthAlwaysTheSame(id);
  }

  /// W16 of cases that the selector's own type never has.
  void Cases(const Statement& statement) {
    if (!HasType(statement.expression) || !IsInteger(unit_.TypeOf(statement.expression))) return;
    const Bounds bounds = PossibleBounds(statement.expression);
    std::vector<StatementId> open = {statement.then};
    while (!open.empty()) {
      const StatementId id = open.back();
      open.pop_back();
      if (!id.valid()) continue;
      const Statement& part = unit_.statements[id];
      if (part.kind == StatementKind::kSwitch) continue;
      if (part.kind == StatementKind::kCase && !bounds.Holds(part.value)) {
        context_.diagnostics.Report(part.head, diag::HncConditionConstant, "false");
      }
      open.push_back(part.then);
      open.push_back(part.otherwise);
      open.insert(open.end(), part.body.begin(), part.body.end());
    }
  }

  /// W17
  void LosesDigits(const Expr& expr) {
    if (!expr.is_implicit || !HasType(expr.a)) return;
    const Type& from = unit_.TypeOf(expr.a);
    const Type& to = unit_.types[expr.type];
    if (!IsInteger(from) || !IsInteger(to) || to.bits >= from.bits) return;
    const std::string_view text = context_.sources.Text(expr.range);
    if (const std::optional<Constant>& constant = At(expr.a).constant) {
      const Bounds fits{-(int64_t{1} << (to.bits - 1)), (int64_t{1} << to.bits) - 1};
      if (!fits.Holds(constant->integer)) context_.diagnostics.Report(expr.range, diag::HncLosesDigits, text);
      return;
    }
    if (from.bits == 32) context_.diagnostics.Report(expr.range, diag::HncLongToInt, text);
  }

  /// W10
  void AbsOfLong(const Expr& expr) {
    if (!expr.function.valid() || unit_.functions[expr.function].system != SystemFunction::kAbs) return;
    if (expr.arguments.size() != 1) return;
    const ExprId argument = Unconverted(expr.arguments[0]);
    if (HasType(argument) && IsInteger(unit_.TypeOf(argument)) && unit_.TypeOf(argument).bits == 32) {
      context_.diagnostics.Report(expr.range, diag::HncAbsOfLong);
    }
  }

  /// W14
  void OutsideTable(const Expr& expr) {
    if (!expr.macro.valid() || At(expr.a).kind != ExprKind::kIndex) return;
    const Expr& element = At(expr.a);
    if (At(element.a).kind != ExprKind::kVariable) return;
    const Variable& table = unit_.variables[At(element.a).variable];
    if (!table.view || !table.view->table || !At(element.b).constant) return;
    const std::string& name = unit_.macros[unit_.macro_uses[expr.macro].macro].name;
    if (!unit_.macros[unit_.macro_uses[expr.macro].macro].is_system) return;
    const int64_t word = At(element.b).constant->integer;
    constexpr int64_t kAxes = 16, kChannels = 4, kFirstChannelWord = 160;
    if (name.starts_with("axis_")) {
      const int64_t axis = word < 0 ? -1 : word / 10;
      if (axis < 0 || axis >= kAxes)
        context_.diagnostics.Report(expr.range, diag::HncOutsideTable, name, axis, kAxes - 1);
    } else if (name.starts_with("ch_") || name.starts_with("mod_") || name.starts_with("msthold")) {
      const int64_t channel = word < kFirstChannelWord ? -1 : (word - kFirstChannelWord) / 20;
      if (channel < 0 || channel >= kChannels) {
        context_.diagnostics.Report(expr.range, diag::HncOutsideTable, name, channel, kChannels - 1);
      }
    }
  }

  /// A cell, or of its bits those of a bit-field: two fields of one unit are two objects.
  struct Part {
    Cell cell;
    uint8_t bit_offset = 0, bit_width = 0;  // of a bit-field
    auto operator<=>(const Part&) const = default;
    bool Overlaps(const Part& other) const {
      if (!cell.Overlaps(other.cell)) return false;
      if (bit_width == 0 || other.bit_width == 0 || cell != other.cell) return true;
      return bit_offset < other.bit_offset + other.bit_width && other.bit_offset < bit_offset + bit_width;
    }
  };
  /// What an expression reads and changes, by place.
  struct Accesses {
    std::set<Part> reads, writes;
    void Add(const Accesses& other) {
      reads.insert(other.reads.begin(), other.reads.end());
      writes.insert(other.writes.begin(), other.writes.end());
    }
  };

  std::optional<Part> PartOf(ExprId lvalue) const {
    const std::optional<StaticAddress> at = context_.facts.AddressOf(lvalue);
    if (!at || !HasType(lvalue)) return std::nullopt;
    Part part{.cell = {at->object, at->offset, std::max(1u, unit_.TypeOf(lvalue).size)}};
    const Expr& expr = At(lvalue);
    if (expr.kind == ExprKind::kMember) {
      const Member& member = unit_.records[unit_.TypeOf(expr.a).record].members[expr.member];
      part.bit_offset = member.bit_offset;
      part.bit_width = member.bit_width;
    }
    return part;
  }

  /// W15: only where something is changed inside an expression.
  void Order(ExprId id) {
    if (!HasType(id)) return;
    uint32_t stores = 0;
    uint32_t parts = 0;
    ForEachExpr(unit_, id, [&](ExprId part) {
      ++parts;
      if (IsStore(At(part)) && (part != id || At(part).kind == ExprKind::kAssign)) ++stores;
    });
    if (stores == 0 || parts > 4000) return;
    reported_order_ = false;
    Visit(id);
  }

  void Conflict(const Accesses& a, const Accesses& b, ExprId at) {
    if (reported_order_) return;
    for (const auto& [first, second] : {std::pair(&a, &b), std::pair(&b, &a)}) {
      for (const Part& write : first->writes) {
        const auto overlaps = [&](const Part& other) { return write.Overlaps(other); };
        if (std::ranges::any_of(second->writes, overlaps) || std::ranges::any_of(second->reads, overlaps)) {
          reported_order_ = true;
          context_.diagnostics.Report(At(at).range, diag::HncEvaluationOrder, context_.objects[write.cell.object].name);
          return;
        }
      }
    }
  }

  Accesses Visit(ExprId id) {
    Accesses all;
    if (!id.valid()) return all;
    const Expr& expr = At(id);
    switch (expr.kind) {
      case ExprKind::kLoad: {
        all = Visit(expr.a);
        if (const std::optional<Part> part = PartOf(expr.a)) all.reads.insert(*part);
        return all;
      }
      case ExprKind::kAssign: {
        const Accesses left = Visit(expr.a), right = Visit(expr.b);
        Conflict(left, right, id);
        Accesses store;
        if (const std::optional<Part> part = PartOf(expr.a)) store.writes.insert(*part);
        Accesses changes;  // of the right side: its reads come before the store
        changes.writes = right.writes;
        Conflict(store, changes, id);
        all.Add(left);
        all.Add(right);
        all.Add(store);
        return all;
      }
      case ExprKind::kCompoundAssign: {
        const Accesses left = Visit(expr.a), right = Visit(expr.b);
        Conflict(left, right, id);
        Accesses store;
        if (const std::optional<Part> part = PartOf(expr.a)) store.writes.insert(*part);
        Accesses changes;
        changes.writes = right.writes;
        Conflict(store, changes, id);
        all.Add(left);
        all.Add(right);
        all.Add(store);
        return all;
      }
      case ExprKind::kIncrement: {
        all = Visit(expr.a);
        if (const std::optional<Part> part = PartOf(expr.a)) all.writes.insert(*part);
        return all;
      }
      case ExprKind::kBinary:
      case ExprKind::kIndex: {
        const Accesses left = Visit(expr.a), right = Visit(expr.b);
        Conflict(left, right, id);
        all.Add(left);
        all.Add(right);
        return all;
      }
      case ExprKind::kCall: {
        for (const ExprId argument : expr.arguments) {
          const Accesses next = Visit(argument);
          Conflict(all, next, id);
          all.Add(next);
        }
        return all;
      }
      case ExprKind::kAnd:  // its operands are in order, or it has one
      case ExprKind::kOr:
      case ExprKind::kComma:
      case ExprKind::kConditional:
      case ExprKind::kPoison:
      case ExprKind::kConstant:
      case ExprKind::kString:
      case ExprKind::kVariable:
      case ExprKind::kFunction:
      case ExprKind::kDecay:
      case ExprKind::kConvert:
      case ExprKind::kCast:
      case ExprKind::kNull:
      case ExprKind::kUnary:
      case ExprKind::kAddress:
      case ExprKind::kDereference:
      case ExprKind::kMember:
        break;
    }
    all.Add(Visit(expr.a));
    all.Add(Visit(expr.b));
    all.Add(Visit(expr.c));
    return all;
  }

  /// W23, once in a program.
  void FloatingPoint() {
    for (const Variable& variable : unit_.variables) {
      if (variable.storage != Storage::kSystem && IsReal(variable.type)) NoteReal(variable.range);
    }
    if (first_real_.begin != 0) context_.diagnostics.Report(first_real_, diag::HncFloatingPoint);
  }
  bool IsReal(TypeId type) const { return type.valid() && unit_.types[type].kind == TypeKind::kReal; }
  void NoteReal(source::Range range) {
    if (range.begin != 0 && (first_real_.begin == 0 || range.begin < first_real_.begin)) first_real_ = range;
  }

  const CheckContext& context_;
  const Unit& unit_;
  bool reported_order_ = false;
  source::Range first_real_;  // in the order of the source
};

}  // namespace

void CheckExpressions(const CheckContext& context) { ExpressionChecks(context).Run(); }

}  // namespace plcxx::hnc
