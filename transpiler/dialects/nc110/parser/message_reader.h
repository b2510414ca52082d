// MSG declarations (specification 9.7).
#pragma once

#include <vector>

#include "transpiler/dialects/nc110/parser/item_reader.h"
#include "transpiler/dialects/nc110/parser/operand_reader.h"

namespace plcxx::nc110 {

class MessageReader : private ItemReader {
 public:
  MessageReader(Parsing& parsing, OperandReader& operands) : ItemReader(parsing), operands_(operands) {}

  void ParseMessage(Item& item);

 private:
  OperandReader& operands_;
  std::vector<MessageId> messages_by_number_ = std::vector<MessageId>(256);
};

}  // namespace plcxx::nc110
