#include "tests/mutants/mutate/needless_jumps.h"

#include <ranges>

namespace plcxx::mutants {
namespace {

using namespace clang;  // the tree's names, throughout

/// Which jumps lead to the end of the statement that is looked at.
struct Ends {
  bool returns = false, continues = false, breaks = false;
};

bool IsOneOf(const Stmt& statement, Ends ends) {
  if (const auto* result = dyn_cast<ReturnStmt>(&statement)) return ends.returns && result->getRetValue() == nullptr;
  return (ends.continues && isa<ContinueStmt>(statement)) || (ends.breaks && isa<BreakStmt>(statement));
}

/// Whether it is nothing but such a jump: then what is in front of it is at the end as well.
bool Add(const Stmt* statement, Ends ends, Jumps& needless) {
  if (statement == nullptr) return false;
  if (IsOneOf(*statement, ends)) {
    needless.insert(statement);
    return true;
  }
  if (const auto* labelled = dyn_cast<SwitchCase>(statement)) return Add(labelled->getSubStmt(), ends, needless);
  if (const auto* list = dyn_cast<CompoundStmt>(statement)) {
    for (const Stmt* const last : std::views::reverse(list->body())) {
      if (!Add(last, ends, needless)) return false;
    }
    return true;
  }
  if (const auto* choice = dyn_cast<IfStmt>(statement)) {
    Add(choice->getThen(), ends, needless);
    Add(choice->getElse(), ends, needless);
  } else if (const auto* inner = dyn_cast<SwitchStmt>(statement)) {
    ends.breaks = true;  // of the inner switch, at whose end the outer statement ends
    Add(inner->getBody(), ends, needless);
  }
  return false;
}

}  // namespace

void AddNeedlessReturns(const Stmt* body, Jumps& needless) { Add(body, {.returns = true}, needless); }
void AddNeedlessContinues(const Stmt* loop_body, Jumps& needless) { Add(loop_body, {.continues = true}, needless); }
void AddNeedlessBreaks(const Stmt* switch_body, Jumps& needless) { Add(switch_body, {.breaks = true}, needless); }

}  // namespace plcxx::mutants
