// MUX(words),(signals): the whole right-hand side of a word assignment (specification 6.7).
#pragma once

#include <vector>

#include "transpiler/dialects/nc110/parser/expression_reader.h"
#include "transpiler/dialects/nc110/parser/item_reader.h"

namespace plcxx::nc110 {

class MuxReader : private ItemReader {
 public:
  MuxReader(Parsing& parsing, ExpressionReader& expressions) : ItemReader(parsing), expressions_(expressions) {}

  MuxId ParseMux(Type target_type, source::Range target);

 private:
  bool ParseMuxList(Type type, std::vector<ExprId>& list);
  void CheckMuxInput(Type type, ExprId input);

  ExpressionReader& expressions_;
};

}  // namespace plcxx::nc110
