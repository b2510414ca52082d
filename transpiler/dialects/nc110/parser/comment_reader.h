// Which item a comment belongs to, or that it is the file's.
#pragma once

#include "transpiler/dialects/nc110/parser/item_reader.h"

namespace plcxx::nc110 {

class CommentReader : private ItemReader {
 public:
  using ItemReader::ItemReader;

  void SplitOffHeader(SourceFile& file);
  void AttachComments(Item& item, source::Offset next_token);
  /// Those behind the last item.
  void TakeRest(SourceFile& file);
};

}  // namespace plcxx::nc110
