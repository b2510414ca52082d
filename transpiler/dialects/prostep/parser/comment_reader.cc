#include "transpiler/dialects/prostep/parser/comment_reader.h"

namespace plcxx::prostep {

void CommentReader::AddComment(source::Range range, CommentPlace place) {
  program_.comments.push_back({.range = range, .place = place, .blank_line_before = blank_line_before_});
  blank_line_before_ = false;
}

Span CommentReader::TakeComments() {
  if (!file_has_items_) AttachHeader(program_.files.back());
  file_has_items_ = true;
  const auto size = static_cast<uint32_t>(program_.comments.size());
  const Span comments{.first = first_free_comment_, .count = size - first_free_comment_};
  first_free_comment_ = size;
  blank_line_before_ = false;
  return comments;
}

/// The comments in front of the first item up to the last blank line.
void CommentReader::AttachHeader(SourceFile& file) {
  const auto size = static_cast<uint32_t>(program_.comments.size());
  uint32_t end = size;
  if (!blank_line_before_) {
    while (end > first_free_comment_ && !(end < size && program_.comments[end].blank_line_before)) --end;
  }
  file.header = {.first = first_free_comment_, .count = end - first_free_comment_};
  first_free_comment_ = end;
}

void CommentReader::AttachTrailing(Span& comments, const Token& comment) {
  if (comment.range.end <= comment.range.begin) return;
  AddComment(comment.range, CommentPlace::kTrailing);
  ++comments.count;
  first_free_comment_ = static_cast<uint32_t>(program_.comments.size());
}

/// Everything since the instruction's own line stands inside it.
void CommentReader::AttachInside(Instruction& instruction, const Token& comment) {
  Span& comments = instruction.comments;
  const auto size = static_cast<uint32_t>(program_.comments.size());
  for (uint32_t i = comments.first; i < size; ++i) {
    const bool before = i < comments.first + comments.count && program_.comments[i].place == CommentPlace::kLeading;
    if (!before) program_.comments[i].place = CommentPlace::kInside;
  }
  comments.count = size - comments.first;
  first_free_comment_ = size;
  AttachTrailing(comments, comment);
  blank_line_before_ = false;
}

}  // namespace plcxx::prostep
