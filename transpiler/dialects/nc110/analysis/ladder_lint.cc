#include "transpiler/dialects/nc110/analysis/ladder_lint.h"

#include <algorithm>
#include <string>
#include <vector>

#include "transpiler/dialects/nc110/source/lexer.h"

namespace plcxx::nc110 {
namespace {

constexpr uint32_t kMaxSeries = 8;
constexpr size_t kMaxInputName = 7;
constexpr size_t kMaxOutputName = 16;
constexpr size_t kMaxComment = 60;

class LadderLint {
 public:
  LadderLint(const source::SourceManager& sources, const Program& program, diag::Engine& diagnostics)
      : sources_(sources), program_(program), diagnostics_(diagnostics), facts_(program.exprs.size()) {}

  void Run() {
    for (uint32_t i = 0; i < program_.exprs.size(); ++i) {
      facts_[i] = FactsOf(program_.exprs[ExprId(i)]);  // children stand before their parents
    }
    for (const Item& item : program_.items) {
      if (!item.faulty) {
        Check(item);
      }
    }
  }

 private:
  struct Facts {
    uint32_t series = 0;            // input elements one after the other on the longest path
    const char* problem = nullptr;  // of this expression or one inside it
  };

  const Facts& Of(ExprId id) const {
    static const Facts kNothing;
    return id.valid() ? facts_[id.index] : kNothing;
  }

  static bool IsSum(ExprKind kind) { return kind == ExprKind::kAdd || kind == ExprKind::kSubtract; }

  Facts FactsOf(const Expr& expr) const {
    const Facts& left = Of(expr.left);
    const Facts& right = Of(expr.right);
    Facts facts;
    facts.problem = left.problem != nullptr ? left.problem : right.problem;
    switch (expr.kind) {
      case ExprKind::kError:
        break;
      case ExprKind::kOperand:
      case ExprKind::kConstant:
      case ExprKind::kAscii:
        facts.series = 1;
        if (expr.symbol.valid() && program_.symbols[expr.symbol].name.size() > kMaxInputName) {
          facts.problem = "the name of an input element is longer than 7 characters";
        } else if (expr.type == Type::kWord && sources_.Text(expr.range).starts_with('[')) {
          facts.problem = "arithmetic with other than two operands";
        }
        break;
      case ExprKind::kAnd:
        facts.series = left.series + right.series;
        break;
      case ExprKind::kOr:
      case ExprKind::kXor:
        facts.series = std::max(left.series, right.series);
        break;
      case ExprKind::kNot:
        facts.series = left.series;
        break;
      case ExprKind::kLess:
      case ExprKind::kEqual:
      case ExprKind::kGreater:
        facts.series = 2;
        break;
      case ExprKind::kAdd:
      case ExprKind::kSubtract:
        facts.series = 1;
        if (IsSum(program_.exprs[expr.left].kind) || IsSum(program_.exprs[expr.right].kind)) {
          facts.problem = "arithmetic with other than two operands";
        }
        break;
#define PLCXX_WORD_FUNCTION(Kind, ...) case ExprKind::k##Kind:
#include "transpiler/dialects/nc110/machine/functions.def"
      case ExprKind::kSgn:
        facts.series = 1;
        break;
    }
    return facts;
  }

  static void Join(Facts& all, const Facts& other) {
    all.series = std::max(all.series, other.series);
    all.problem = all.problem != nullptr ? all.problem : other.problem;
  }

  void Check(const Item& item) {
    Facts facts;
    if (item.kind == ItemKind::kAssignment) {
      const Assignment& assignment = program_.assignments[item.assignment()];
      const SymbolId name = assignment.target.symbol;
      if (name.valid() && program_.symbols[name].name.size() > kMaxOutputName) {
        facts.problem = "the name of an output is longer than 16 characters";
      }
      Join(facts, Of(assignment.value));
      if (assignment.mux.valid()) {
        const Mux& mux = program_.muxes[assignment.mux];
        for (uint32_t i = 0; i < mux.count; ++i) {
          Join(facts, Of(program_.mux_inputs[mux.first + i].word));
          Join(facts, Of(program_.mux_inputs[mux.first + i].selector));
        }
      }
    } else if (item.kind == ItemKind::kBlockHead) {
      Join(facts, Of(program_.blocks[item.block()].condition));
    } else {
      return;
    }
    for (uint32_t i = 0; i < item.comment_count && facts.problem == nullptr; ++i) {
      if (source::CountCodePoints(sources_.Text(program_.comments[item.first_comment + i].range)) > kMaxComment + 1) {
        facts.problem = "a comment is longer than 60 characters";
      }
    }
    if (facts.problem == nullptr && facts.series > kMaxSeries) {
      facts.problem = "more than 8 input elements stand in series";
    }
    if (facts.problem != nullptr) {
      diagnostics_.Report(item.range, diag::Nc110Ladder, facts.problem);
    }
  }

  const source::SourceManager& sources_;
  const Program& program_;
  diag::Engine& diagnostics_;
  std::vector<Facts> facts_;
};

}  // namespace

void LintLadder(const source::SourceManager& sources, const Program& program, diag::Engine& diagnostics) {
  if (diagnostics.Enabled(diag::Nc110Ladder.row)) {
    LadderLint(sources, program, diagnostics).Run();
  }
}

}  // namespace plcxx::nc110
