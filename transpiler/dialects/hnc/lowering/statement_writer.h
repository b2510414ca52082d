// Marks where statements begin, with their texts and comments.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/common/statement_ids.h"
#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

/// The lines of a comment, which begins at `begin`, without its marks and the decoration of its left edge.
void AddCommentLines(std::string_view text, source::Offset begin, std::vector<source::Range>& to);

class StatementWriter : Context {
 public:
  explicit StatementWriter(const Context& context) : Context(context) {}

  std::string SubjectOf(const Statement& statement) const;
  void MarkText(source::Range range, const std::string& subject, bool opens_block);
  void Mark(StatementId id, source::Range range, bool opens_block);
  /// What stands before a closing brace belongs to no statement.
  void CommentsAtEnd(source::Range close);
  void BeginFunction(const Function& function);

 private:
  void TakeComments(source::Offset until, std::vector<source::Range>& to);

  MacroUseId marked_macro_;  // whose text the last mark shows
  size_t next_comment_ = 0;
  dialects::StatementIds statement_ids_;
};

}  // namespace plcxx::hnc
