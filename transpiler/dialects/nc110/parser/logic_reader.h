// Files with statements: one item after the other (specification 3, 3.1).
#pragma once

#include "transpiler/dialects/nc110/parser/assignment_reader.h"
#include "transpiler/dialects/nc110/parser/block_reader.h"
#include "transpiler/dialects/nc110/parser/comment_reader.h"
#include "transpiler/dialects/nc110/parser/expression_reader.h"
#include "transpiler/dialects/nc110/parser/item_reader.h"
#include "transpiler/dialects/nc110/parser/message_reader.h"
#include "transpiler/dialects/nc110/parser/open_blocks.h"
#include "transpiler/dialects/nc110/parser/operand_reader.h"

namespace plcxx::nc110 {

class LogicReader : private ItemReader {
 public:
  LogicReader(Parsing& parsing, OpenBlocks& open_blocks, OperandReader& operands)
      : ItemReader(parsing),
        open_blocks_(open_blocks),
        expressions_(parsing, operands),
        assignments_(parsing, operands, expressions_),
        blocks_(parsing, open_blocks, expressions_),
        messages_(parsing, operands),
        comments_(parsing) {}
  LogicReader(const LogicReader&) = delete;
  LogicReader& operator=(const LogicReader&) = delete;

  void ParseLogicFile(source::FileId file, SourceFile& entry);

 private:
  void ParseItem();
  void ParseCycleMark(Item& item);
  /// After a fault.
  void SkipToNextItem(size_t item_begin);

  OpenBlocks& open_blocks_;
  ExpressionReader expressions_;
  AssignmentReader assignments_;
  BlockReader blocks_;
  MessageReader messages_;
  CommentReader comments_;
};

}  // namespace plcxx::nc110
