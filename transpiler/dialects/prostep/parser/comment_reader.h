// Which comment belongs to what: everything up to an item is its own, as is what stands after it on its last line.
#pragma once

#include "transpiler/dialects/prostep/parser/line_reader.h"

namespace plcxx::prostep {

class CommentReader : private LineReader {
 public:
  using LineReader::LineReader;

  void BeginFile() { file_has_items_ = blank_line_before_ = false; }
  void SetBlankLineBefore(bool is_before) { blank_line_before_ = is_before; }
  void AddComment(source::Range range, CommentPlace place);
  /// What has not been attached yet.
  Span TakeComments();
  void AttachTrailing(Span& comments, const Token& comment);
  void AttachInside(Instruction& instruction, const Token& comment);

 private:
  void AttachHeader(SourceFile& file);

  uint32_t first_free_comment_ = 0;
  bool blank_line_before_ = false;
  bool file_has_items_ = false;
};

}  // namespace plcxx::prostep
