#include <utility>

#include "transpiler/dialects/technol/parser/internal.h"

namespace plcxx::technol {

void Parser::AddComment(const Token& comment, CommentPlace place) {
  waiting_comments_.push_back({.range = comment.range, .place = place, .blank_line_before = blank_line_before_});
  blank_line_before_ = false;
}

void Parser::TakeBlankLine() {
  // Comments at the beginning of a file, a blank line after them: they are about the whole file.
  if (!file_has_items_ && !waiting_comments_.empty()) {
    file_has_items_ = true;
    for (SourceFile& file : context_.program.files) {
      if (file.file == file_) file.header = TakeComments();
    }
  }
  blank_line_before_ = true;
}

Span Parser::TakeComments() {
  std::vector<Comment>& comments = context_.program.comments;
  const Span span = {.first = static_cast<uint32_t>(comments.size()),
                     .count = static_cast<uint32_t>(waiting_comments_.size())};
  comments.insert(comments.end(), waiting_comments_.begin(), waiting_comments_.end());
  waiting_comments_.clear();
  return span;
}

/// Those above the statement and its own.
Span Parser::TakeComments(const Statement& statement) {
  if (statement.comment != nullptr) AddComment(*statement.comment, CommentPlace::kTrailing);
  blank_line_before_ = false;
  return TakeComments();
}

}  // namespace plcxx::technol
