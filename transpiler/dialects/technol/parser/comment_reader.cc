#include "transpiler/dialects/technol/parser/comment_reader.h"

namespace plcxx::technol {

void CommentReader::AddComment(const Token& comment, CommentPlace place) {
  waiting_.push_back({.range = comment.range, .place = place, .blank_line_before = blank_line_before_});
  blank_line_before_ = false;
}

void CommentReader::AddComment(const Statement& statement, CommentPlace place) {
  if (statement.comment != nullptr) AddComment(*statement.comment, place);
}

void CommentReader::ReadBlankLine() {
  // Comments at the beginning of a file, a blank line after them: they are about the whole file.
  if (!file_has_items_ && !waiting_.empty()) {
    file_has_items_ = true;
    for (SourceFile& file : context_.program.files) {
      if (file.file == now_.file) file.header = TakeComments();
    }
  }
  blank_line_before_ = true;
}

Span CommentReader::TakeComments() {
  std::vector<Comment>& comments = context_.program.comments;
  const Span span = {.first = static_cast<uint32_t>(comments.size()), .count = static_cast<uint32_t>(waiting_.size())};
  comments.insert(comments.end(), waiting_.begin(), waiting_.end());
  waiting_.clear();
  return span;
}

Span CommentReader::TakeComments(const Statement& statement) {
  AddComment(statement, CommentPlace::kTrailing);
  blank_line_before_ = false;
  return TakeComments();
}

}  // namespace plcxx::technol
