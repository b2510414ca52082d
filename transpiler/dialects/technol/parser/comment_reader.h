// Comments, which wait for the statement that they are about.
#pragma once

#include <vector>

#include "transpiler/dialects/technol/parser/statement_reader.h"

namespace plcxx::technol {

class CommentReader : private StatementReader {
 public:
  using StatementReader::StatementReader;

  /// Comments in front of the first statement of a source may be about the whole file.
  void BeginSource() { file_has_items_ = false; }
  void BeginStatement() { file_has_items_ = true; }
  void AddComment(const Token& comment, CommentPlace place);
  /// The statement's own comment, if it has one.
  void AddComment(const Statement& statement, CommentPlace place);
  void ReadBlankLine();
  bool IsWaiting() const { return !waiting_.empty(); }
  void Forget() { waiting_.clear(); }
  Span TakeComments();
  /// Those above the statement and its own.
  Span TakeComments(const Statement& statement);

 private:
  std::vector<Comment> waiting_;
  bool blank_line_before_ = false;
  bool file_has_items_ = false;
};

}  // namespace plcxx::technol
