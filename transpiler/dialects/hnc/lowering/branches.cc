#include "transpiler/dialects/hnc/lowering/branches.h"

#include "transpiler/dialects/hnc/lowering/expressions.h"
#include "transpiler/dialects/hnc/lowering/intervals.h"
#include "transpiler/dialects/hnc/lowering/jumps.h"
#include "transpiler/dialects/hnc/lowering/live_path.h"
#include "transpiler/dialects/hnc/lowering/statement_writer.h"
#include "transpiler/dialects/hnc/lowering/statements.h"

namespace plcxx::hnc {

using ir::OpKind;
using ir::ValueId;

void Branches::Lower(StatementId id, const Statement& statement, Tail tail) {
  writer_.Mark(id, statement.head, true);
  if (jumps_.IsFlat(id)) {
    LowerFlat(statement);
    return;
  }
  const ValueId condition = expressions_.Condition(statement.expression);
  const Flow before = flow_;
  Flow then;
  const auto lower_then = [&] {
    intervals_.Refine(statement.expression, true);
    statements_.Lower(statement.then, tail);
    then = flow_;
  };
  if (statement.otherwise.valid()) {
    builder_.Choose(condition, lower_then, [&] {
      flow_ = before;
      intervals_.Refine(statement.expression, false);
      statements_.Lower(statement.otherwise, tail);
    });
  } else {
    builder_.When(condition, lower_then);
    flow_ = before;
    intervals_.Refine(statement.expression, false);
  }
  flow_.JoinWith(then);
}

/// A goto or a case leads into one of its arms: both lie in the list of the if itself.
void Branches::LowerFlat(const Statement& statement) {
  const uint32_t otherwise = path_.NewLabel(), end = path_.NewLabel();
  const bool entered = flow_.reachable;
  if (entered) {
    const ValueId condition = expressions_.Condition(statement.expression);
    const Flow before = flow_;
    intervals_.Refine(statement.expression, false);
    path_.JumpWhen(Pure(OpKind::kBitNot, {condition}), otherwise);
    flow_ = before;
    intervals_.Refine(statement.expression, true);
  }
  statements_.Lower(statement.then, Tail::kNone);
  if (statement.otherwise.valid()) {
    path_.JumpTo(end);
    path_.PlaceLabel(otherwise);
    statements_.Lower(statement.otherwise, Tail::kNone);
    path_.PlaceLabel(end);
  } else {
    path_.PlaceLabel(otherwise);
  }
}

}  // namespace plcxx::hnc
