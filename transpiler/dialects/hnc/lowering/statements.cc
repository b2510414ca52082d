#include "transpiler/dialects/hnc/lowering/statements.h"

#include "transpiler/dialects/hnc/lowering/branches.h"
#include "transpiler/dialects/hnc/lowering/critical_sections.h"
#include "transpiler/dialects/hnc/lowering/expressions.h"
#include "transpiler/dialects/hnc/lowering/gotos.h"
#include "transpiler/dialects/hnc/lowering/initialisers.h"
#include "transpiler/dialects/hnc/lowering/jumps.h"
#include "transpiler/dialects/hnc/lowering/live_path.h"
#include "transpiler/dialects/hnc/lowering/loops.h"
#include "transpiler/dialects/hnc/lowering/returns.h"
#include "transpiler/dialects/hnc/lowering/statement_writer.h"
#include "transpiler/dialects/hnc/lowering/switches.h"

namespace plcxx::hnc {

void Statements::Lower(StatementId id, Tail tail) {
  if (!id.valid()) return;
  const Statement& statement = unit_.statements[id];
  if (!flow_.reachable && !jumps_.IsEntered(id)) {
    const bool says_nothing = statement.kind == StatementKind::kEmpty ||
                              statement.kind == StatementKind::kDeclaration ||
                              (statement.kind == StatementKind::kCompound && statement.body.empty());
    if (!says_nothing && !unreachable_reported_) {
      unreachable_reported_ = true;
      const bool compound = statement.kind == StatementKind::kCompound;
      diagnostics_.Report(compound ? unit_.statements[statement.body.front()].range : statement.head,
                          diag::HncUnreachable);
    }
    return;
  }
  // One warning for what is unreachable in a row: a statement that is reached ends the row.
  unreachable_reported_ = false;
  LowerReached(id, statement, tail);
  unreachable_reported_ = false;
}

void Statements::LowerReached(StatementId id, const Statement& statement, Tail tail) {
  switch (statement.kind) {
    case StatementKind::kCompound:
      Compound(statement, tail);
      return;
    case StatementKind::kDeclaration:
      initialisers_.Lower(statement);
      return;
    case StatementKind::kExpression:
      writer_.Mark(id, statement.range, false);
      expressions_.Execute(statement.expression);
      return;
    case StatementKind::kEmpty:
      return;
    case StatementKind::kIf:
      branches_.Lower(id, statement, tail == Tail::kFunction ? tail : Tail::kNone);
      return;
    case StatementKind::kSwitch:
      writer_.Mark(id, statement.head, false);
      switches_.Lower(statement);
      return;
    case StatementKind::kWhile:
    case StatementKind::kDo:
    case StatementKind::kFor:
      writer_.Mark(id, statement.head, true);
      loops_.Lower(statement);
      return;
    case StatementKind::kGoto:
      writer_.Mark(id, statement.range, false);
      gotos_.Lower(statement);
      return;
    case StatementKind::kContinue:
      path_.Continue();
      return;
    case StatementKind::kBreak:
      if (tail == Tail::kCase) {
        path_.EndCase();
      } else {
        path_.Break();
      }
      return;
    case StatementKind::kReturn:
      writer_.Mark(id, statement.range, false);
      returns_.Lower(statement, tail);
      return;
    case StatementKind::kLabel:
      gotos_.LowerLabel(statement, tail);
      return;
    case StatementKind::kCase:
    case StatementKind::kDefault: {
      // Of a switch whose labels lie deeper than its body: see FlatSwitch.
      switches_.PlaceCase(id);
      Lower(statement.then, tail);
      return;
    }
    case StatementKind::kCriticalEnter:
    case StatementKind::kCriticalLeave: {
      writer_.Mark(id, statement.range, false);
      const bool enters = statement.kind == StatementKind::kCriticalEnter;
      flow_.critical = enters ? std::optional(statement.range) : std::nullopt;
      const ir::ValueId inside = builder_.Bit(enters ? 1 : 0);
      const ir::PlaceId flag = critical_.Flag();
      builder_.Store(flag, inside);
      critical_.Call(enters ? "critical_enter" : "critical_leave");
      return;
    }
  }
}

void Statements::LowerBody(const std::vector<StatementId>& body, Tail tail) {
  for (size_t i = 0; i < body.size(); ++i) Lower(body[i], i + 1 == body.size() ? tail : Tail::kNone);
}

/// The automatic variables of a block that is entered at its beginning alone have no value there, and are forgotten at
/// its end: each branch copies and joins what has no value yet.
void Statements::Compound(const Statement& statement, Tail tail) {
  const auto for_each_own = [&](auto visit) {
    for (const StatementId part : statement.body) {
      for (const VariableId id : unit_.statements[part].variables) {
        if (frame_.block_locals.contains(id.index)) visit(id);
      }
    }
  };
  for_each_own([&](VariableId id) { flow_.unassigned.insert(id); });
  LowerBody(statement.body, tail);
  for_each_own([&](VariableId id) { flow_.unassigned.erase(id); });
  writer_.CommentsAtEnd(statement.close);
}

}  // namespace plcxx::hnc
