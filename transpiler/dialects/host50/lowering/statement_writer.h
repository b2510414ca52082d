// Statements: which lines each is, the comments above it, what it is about.
#pragma once

#include <string>
#include <vector>

#include "transpiler/dialects/common/statement_ids.h"
#include "transpiler/dialects/host50/lowering/context.h"

namespace plcxx::host50 {

class Names;

class StatementWriter : Context {
 public:
  StatementWriter(const Context& context, const Names& names) : Context(context), names_(names) {}

  /// The statement of a rung begins: what follows is marked with it.
  void Begin(Span rung);
  /// Marks what follows; the comments that wait are above it. Gives the statement's number.
  uint32_t Add(source::Range range, std::string subject);
  /// A comment for the next statement, without its ';', a remark without its quotes.
  void AddComment(source::Range comment);
  void AddComments(Span comments);
  /// The last one that waits, which is the statement itself then. There is one.
  source::Range TakeLastComment();
  bool has_comments() const { return !waiting_comments_.empty(); }

 private:
  source::Range TextOf(source::Range comment) const;
  source::Range LinesOf(source::Range first, source::Range last, bool is_drawing) const;
  std::string SubjectOf(Span rung) const;

  const Names& names_;
  dialects::StatementIds statement_ids_;
  std::vector<source::Range> waiting_comments_;  // printed above the next statement
};

}  // namespace plcxx::host50
