#include "transpiler/dialects/hnc/analysis/request_codes.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "transpiler/dialects/hnc/analysis/stores.h"
#include "transpiler/dialects/hnc/syntax/walk.h"

namespace plcxx::hnc {
namespace {

constexpr int64_t kDone = -1;                    // the word of a request that is complete: no code
constexpr int64_t kMostDivided = 1'000'000'000;  // a quotient by more is 0 for each code

/// What a value is of the word of a request.
struct RequestWord {
  size_t kind = 0;
  int64_t divisor = 1;

  bool operator==(const RequestWord&) const = default;
};

class CodeFinder {
 public:
  CodeFinder(const Unit& unit, const Objects& objects, const Facts& facts)
      : unit_(unit), objects_(objects), facts_(facts) {}

  std::vector<RequestCode> Find(StatementId body) {
    FindVariables(body);
    ForEachStatement(unit_, body, [&](StatementId id) { NoteSwitch(unit_.statements[id]); });
    ForEachExprIn(unit_, body, [&](ExprId id) { NoteComparison(unit_.expressions[id]); });
    std::ranges::stable_sort(codes_, {}, [](const RequestCode& code) { return code.place.begin; });
    return std::move(codes_);
  }

 private:
  ExprId WithoutConversions(ExprId id) const {
    while (unit_.expressions[id].kind == ExprKind::kConvert || unit_.expressions[id].kind == ExprKind::kCast)
      id = unit_.expressions[id].a;
    return id;
  }

  /// The variable that an lvalue names as a whole.
  VariableId VariableOf(ExprId lvalue) const {
    const Expr& expr = unit_.expressions[lvalue];
    const bool automatic =
        expr.kind == ExprKind::kVariable && unit_.variables[expr.variable].storage == Storage::kAutomatic;
    return automatic ? expr.variable : VariableId();
  }

  std::optional<RequestWord> WordOf(ExprId value) const {
    const Expr& expr = unit_.expressions[WithoutConversions(value)];
    if (expr.kind == ExprKind::kBinary && expr.binary == BinaryOp::kDivide) {
      std::optional<RequestWord> word = WordOf(expr.a);
      const std::optional<Constant>& by = unit_.expressions[expr.b].constant;
      if (!word || !by || by->integer <= 0 || by->integer > kMostDivided / word->divisor) return std::nullopt;
      word->divisor *= by->integer;
      return word;
    }
    if (expr.kind != ExprKind::kLoad) return std::nullopt;
    if (const VariableId variable = VariableOf(expr.a); variable.valid()) {
      const auto known = variables_.find(variable.index);
      return known == variables_.end() ? std::nullopt : known->second;
    }
    const std::optional<ModWord> word = WordOfG(unit_, objects_, facts_, expr.a);
    if (!word || word->word < kFirstModWord) return std::nullopt;
    const int64_t kind = (word->word - kFirstModWord) % kChannelWords;
    if (kind > 3) return std::nullopt;
    return RequestWord{.kind = static_cast<size_t>(kind)};
  }

  /// A variable is a word when it takes that word alone; constants that it takes besides are no codes.
  void NoteValue(VariableId variable, ExprId value) {
    if (!variable.valid() || unit_.expressions[value].constant) return;
    const std::optional<RequestWord> word = WordOf(value);
    const auto [known, is_new] = variables_.emplace(variable.index, word);
    if (!is_new && known->second != word) known->second.reset();
  }

  void FindVariables(StatementId body) {
    ForEachStatement(unit_, body, [&](StatementId id) {
      for (const VariableId variable : unit_.statements[id].variables) {
        const Variable& declared = unit_.variables[variable];
        if (declared.storage != Storage::kAutomatic || declared.initial.size() != 1) continue;
        if (declared.initial.front().value.valid()) NoteValue(variable, declared.initial.front().value);
      }
    });
    std::vector<VariableId> changed;
    ForEachExprIn(unit_, body, [&](ExprId id) {
      const Expr& expr = unit_.expressions[id];
      if (expr.kind == ExprKind::kAssign) {
        NoteValue(VariableOf(expr.a), expr.b);
      } else if (expr.kind == ExprKind::kCompoundAssign || expr.kind == ExprKind::kIncrement ||
                 expr.kind == ExprKind::kAddress) {
        if (const VariableId variable = VariableOf(expr.a); variable.valid()) changed.push_back(variable);
      }
    });
    for (const VariableId variable : changed) variables_[variable.index].reset();
  }

  void NoteCode(const RequestWord& word, int64_t value, source::Range place) {
    if (value == kDone && word.divisor == 1) return;
    const int64_t begin = value * word.divisor, rest = word.divisor - 1;
    codes_.push_back({.kind = word.kind,
                      .first = value < 0 ? begin - rest : begin,
                      .last = value < 0 ? begin : begin + rest,
                      .place = place});
  }

  void NoteSwitch(const Statement& statement) {
    if (statement.kind != StatementKind::kSwitch || !statement.expression.valid()) return;
    const std::optional<RequestWord> word = WordOf(statement.expression);
    if (!word) return;
    std::vector<StatementId> open = {statement.then};
    while (!open.empty()) {
      const StatementId id = open.back();
      open.pop_back();
      if (!id.valid() || unit_.statements[id].kind == StatementKind::kSwitch) continue;  // its cases are its own
      const Statement& part = unit_.statements[id];
      if (part.kind == StatementKind::kCase) NoteCode(*word, part.value, part.head);
      open.push_back(part.otherwise);
      open.push_back(part.then);
      open.insert(open.end(), part.body.begin(), part.body.end());
    }
  }

  void NoteComparison(const Expr& expr) {
    const bool compares =
        expr.kind == ExprKind::kBinary && (expr.binary == BinaryOp::kEqual || expr.binary == BinaryOp::kNotEqual);
    if (!compares) return;
    for (const auto& [value, other] : {std::pair(expr.a, expr.b), std::pair(expr.b, expr.a)}) {
      const std::optional<Constant>& constant = unit_.expressions[other].constant;
      if (!constant) continue;
      if (const std::optional<RequestWord> word = WordOf(value)) NoteCode(*word, constant->integer, expr.range);
    }
  }

  const Unit& unit_;
  const Objects& objects_;
  const Facts& facts_;
  std::map<uint32_t, std::optional<RequestWord>> variables_;  // by VariableId; none: something else, too
  std::vector<RequestCode> codes_;
};

}  // namespace

std::vector<RequestCode> RequestCodes(const Unit& unit, const Objects& objects, const Facts& facts, FunctionId id) {
  return CodeFinder(unit, objects, facts).Find(unit.functions[id].body);
}

}  // namespace plcxx::hnc
