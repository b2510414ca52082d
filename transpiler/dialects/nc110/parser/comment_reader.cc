#include "transpiler/dialects/nc110/parser/comment_reader.h"

namespace plcxx::nc110 {

void CommentReader::AttachComments(Item& item, source::Offset next_token) {
  item.first_comment = static_cast<uint32_t>(program_.comments.size());
  for (; now_.next_comment < now_.lexed.comments.size(); ++now_.next_comment) {
    Comment comment = now_.lexed.comments[now_.next_comment];
    if (comment.range.begin < item.range.begin) {
      comment.place = CommentPlace::kLeading;
    } else if (comment.range.begin < item.range.end) {
      comment.place = CommentPlace::kInside;
    } else if (comment.place != CommentPlace::kTrailing || comment.range.begin >= next_token) {
      break;
    }
    program_.comments.push_back(comment);
  }
  item.comment_count = static_cast<uint32_t>(program_.comments.size()) - item.first_comment;
}

/// The first group of comments belongs to the file if a blank line separates it from what follows.
void CommentReader::SplitOffHeader(SourceFile& file) {
  file.header.first = static_cast<uint32_t>(program_.comments.size());
  const Token& first = now_.lexed.tokens.front();
  size_t count = 0;
  while (count < now_.lexed.comments.size() && now_.lexed.comments[count].range.begin < first.range.begin &&
         (count == 0 || !now_.lexed.comments[count].blank_line_before)) {
    ++count;
  }
  if (count == 0) {
    return;
  }
  const bool more_comments =
      count < now_.lexed.comments.size() && now_.lexed.comments[count].range.begin < first.range.begin;
  const uint32_t last_line = sources_.Locate(now_.lexed.comments[count - 1].range.begin).line;
  if (!more_comments && sources_.Locate(first.range.begin).line < last_line + 2) {
    return;
  }
  for (; now_.next_comment < count; ++now_.next_comment) {
    program_.comments.push_back(now_.lexed.comments[now_.next_comment]);
    program_.comments.back().place = CommentPlace::kHeader;
  }
  file.header.count = static_cast<uint32_t>(count);
}

void CommentReader::TakeRest(SourceFile& file) {
  file.rest.first = static_cast<uint32_t>(program_.comments.size());
  for (; now_.next_comment < now_.lexed.comments.size(); ++now_.next_comment) {
    program_.comments.push_back(now_.lexed.comments[now_.next_comment]);
    program_.comments.back().place = CommentPlace::kRest;
  }
  file.rest.count = static_cast<uint32_t>(program_.comments.size()) - file.rest.first;
}

}  // namespace plcxx::nc110
