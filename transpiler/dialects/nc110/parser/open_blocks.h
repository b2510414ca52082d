// The blocks that are open: their names, their ends, and what is said where an end is missing (specification 3.4, 6.8).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/nc110/parser/item_reader.h"

namespace plcxx::nc110 {

std::string_view HeadWord(BlockKind kind);
std::string_view EndWord(BlockKind kind);

class OpenBlocks : private ItemReader {
 public:
  using ItemReader::ItemReader;

  bool empty() const { return open_.empty(); }
  size_t size() const { return open_.size(); }
  BlockId innermost() const { return open_.back().block; }
  void Open(BlockId block) { open_.push_back({block}); }
  /// The innermost one ends; a wrong kind and a wrong name are reported.
  void Close(BlockEnd& end, const Token& word);
  /// The name of a block or of its end is the token at the cursor.
  source::Range TakeName();
  /// END alone, or ENDIF: where its block is not closed otherwise, that is one fault with the missing end.
  bool IsMeantEnd(std::string_view run, source::Range range);

  /// A DOE that continues no chain, directly in the innermost open block: where that is never closed, its missing end
  /// is the one fault. False: nothing is open.
  bool KeepLoneDoe(source::Range doe);

  void ReportAtMark(source::Range mark);
  void ReportAtEnd();
  /// W304, once for each.
  void ReportAcrossFiles();

 private:
  void CheckEndName(const BlockEnd& end);
  bool SameName(source::Range a, source::Range b) const;
  std::string_view NameAt(source::Range range) const;

  struct OpenBlock {
    BlockId block;
    bool reported = false;   // its missing end, too deep nesting
    source::Range lone_end;  // an END without its letter, or ENDIF, which was meant to close it
    bool continued = false;  // W304 given
    std::vector<source::Range> lone_does;
  };
  std::vector<OpenBlock> open_;
  std::map<source::Offset, std::string> mapped_names_;  // where look-alike letters were replaced
};

}  // namespace plcxx::nc110
