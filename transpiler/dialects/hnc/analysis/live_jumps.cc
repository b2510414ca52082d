#include "transpiler/dialects/hnc/analysis/live_jumps.h"

#include <utility>

namespace plcxx::hnc {

std::optional<bool> ConstantCondition(const Unit& unit, ExprId id) {
  if (!id.valid()) return std::nullopt;
  const Expr& expr = unit.expressions[id];
  if (!expr.constant) return std::nullopt;
  const TypeKind kind = unit.types[expr.type].kind;
  if (kind == TypeKind::kReal) return expr.constant->real != 0;
  if (kind != TypeKind::kInteger) return std::nullopt;
  return expr.constant->integer != 0;
}

bool MayBeRefused(const Unit& unit, const Statement& jump) {
  if (!jump.label.valid()) return false;
  const StatementId label = unit.labels[jump.label].statement;
  return label.valid() && unit.statements[label].loop_bound;
}

namespace {

class LiveGotos {
 public:
  explicit LiveGotos(const Unit& unit) : unit_(unit) {}

  std::unordered_set<uint32_t> Run(StatementId body) {
    for (size_t known = labels_.size() + 1; known != labels_.size();) {
      known = labels_.size();
      Visit(body, true);
    }
    return std::move(gotos_);
  }

 private:
  struct Around {
    bool is_loop = false;
    bool entered = false;    // of a switch: its selector is evaluated
    bool defaults = false;   // of a switch: it has a default
    bool breaks = false;     // a live break leaves it
    bool continues = false;  // a live continue belongs to it
  };

  /// Whether control gets to the end of the statement, if it gets to its beginning or to a live label in it.
  bool Visit(StatementId id, bool live) {
    if (!id.valid()) return live;
    const Statement& statement = unit_.statements[id];
    switch (statement.kind) {
      case StatementKind::kCompound:
        for (const StatementId part : statement.body) live = Visit(part, live);
        return live;
      case StatementKind::kIf: {
        const bool then = Visit(statement.then, live);
        const bool otherwise = Visit(statement.otherwise, live);
        return then || otherwise;
      }
      case StatementKind::kWhile:
      case StatementKind::kDo:
      case StatementKind::kFor:
        return VisitLoop(statement, live);
      case StatementKind::kSwitch: {
        around_.push_back({.is_loop = false, .entered = live});
        const bool end = Visit(statement.then, false);
        const Around around = around_.back();
        around_.pop_back();
        return end || around.breaks || (live && !around.defaults);
      }
      case StatementKind::kCase:
      case StatementKind::kDefault:
        return Visit(statement.then, PassCase(statement) || live);
      case StatementKind::kLabel:
        return Visit(statement.then, live || labels_.contains(statement.label.index));
      case StatementKind::kGoto:
        if (!live || !statement.label.valid()) return false;
        gotos_.insert(id.index);
        labels_.insert(statement.label.index);
        return MayBeRefused(unit_, statement);
      case StatementKind::kBreak:
        if (live && !around_.empty()) around_.back().breaks = true;
        return false;
      case StatementKind::kContinue:
        for (size_t i = around_.size(); live && i-- > 0;) {
          if (!around_[i].is_loop) continue;
          around_[i].continues = true;
          break;
        }
        return false;
      case StatementKind::kReturn:
        return false;
      case StatementKind::kDeclaration:
      case StatementKind::kExpression:
      case StatementKind::kEmpty:
      case StatementKind::kCriticalEnter:
      case StatementKind::kCriticalLeave:
        return live;
    }
    return live;
  }

  bool VisitLoop(const Statement& loop, bool live) {
    const std::optional<bool> always = ConstantCondition(unit_, loop.expression);
    const bool is_do = loop.kind == StatementKind::kDo;
    around_.push_back({.is_loop = true});
    const bool end = Visit(loop.then, live && (is_do || always != false));
    const Around around = around_.back();
    around_.pop_back();
    const bool tested = !is_do && loop.expression.valid();
    return end || around.breaks || around.continues || (live && (tested || loop.loop_bound));
  }

  /// Whether the switch leads to this label of it.
  bool PassCase(const Statement& label) {
    for (size_t i = around_.size(); i-- > 0;) {
      if (around_[i].is_loop) continue;
      around_[i].defaults = around_[i].defaults || label.kind == StatementKind::kDefault;
      return around_[i].entered;
    }
    return false;
  }

  const Unit& unit_;
  std::vector<Around> around_;
  std::unordered_set<uint32_t> gotos_, labels_;  // by StatementId, by LabelId
};

}  // namespace

std::unordered_set<uint32_t> FindLiveGotos(const Unit& unit, StatementId body) { return LiveGotos(unit).Run(body); }

}  // namespace plcxx::hnc
