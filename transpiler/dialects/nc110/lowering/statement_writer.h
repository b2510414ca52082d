// Statements: the comments above each, and what it is about.
#pragma once

#include <vector>

#include "transpiler/dialects/common/statement_ids.h"
#include "transpiler/dialects/nc110/lowering/context.h"

namespace plcxx::nc110 {

class StatementWriter : Context {
 public:
  explicit StatementWriter(const Context& context) : Context(context) {}

  /// Opens the source's next statement: everything up to the next call is its.
  ir::StatementId Begin(ItemId id);
  /// Comments of the files that end and begin in front of the item.
  void AddFileComments(ItemId next);
  void AddComments(const Item& item);

 private:
  source::Range TextOf(const Comment& comment) const;

  std::vector<source::Range> waiting_comments_;  // of the file and of '$': printed above the next statement
  size_t next_file_ = 0;
  dialects::StatementIds statement_ids_;
};

}  // namespace plcxx::nc110
