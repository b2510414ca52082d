// Heads and ends of blocks, and chains of DOF and DOE (specification 3.4, 6.8).
#pragma once

#include "transpiler/dialects/nc110/parser/expression_reader.h"
#include "transpiler/dialects/nc110/parser/item_reader.h"
#include "transpiler/dialects/nc110/parser/open_blocks.h"

namespace plcxx::nc110 {

class BlockReader : private ItemReader {
 public:
  BlockReader(Parsing& parsing, OpenBlocks& open_blocks, ExpressionReader& expressions)
      : ItemReader(parsing), open_blocks_(open_blocks), expressions_(expressions) {}

  void ParseBlockHead(Item& item);
  /// A word that is none of the language, and a colon where that of a head would be.
  bool IsMisspeltHead() const;
  /// `word` is reported and read: what follows is a block.
  void ParseMisspeltHead(Item& item, const Token& word);
  void ParseBlockEnd(Item& item);
  /// An item that is neither: a DOE after it continues nothing.
  void PassItem(const Item& item);
  /// No statement at all: a DOE after it may continue what is before it.
  void PassStray() { chain_unsure_ = true; }

 private:
  /// After its word.
  void ParseHead(Item& item, source::Range word, BlockKind kind);
  void ParseCondition(Block& block, source::Range colon);
  /// Is nothing on the rest of the line that could be the condition?
  void PassSecondHeadWord();
  bool NoConditionHere() const;
  void LinkChain(BlockId id, Block& block);

  OpenBlocks& open_blocks_;
  ExpressionReader& expressions_;
  BlockId chain_;              // of what a DOE right here would follow, the last member; not valid: nothing
  bool chain_unsure_ = false;  // the item before was faulty: no error 45
};

}  // namespace plcxx::nc110
