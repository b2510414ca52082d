#include "transpiler/dialects/common/statement_ids.h"

#include "transpiler/support/hex.h"

namespace plcxx::dialects {

uint32_t StatementIds::Next(TextHash text) {
  for (uint32_t count = equal_texts_[text.value()]++;; ++count) {
    TextHash number = text;
    for (uint32_t rest = count; rest > 0; rest >>= 8) number.Add(static_cast<char>(rest & 0xFF));
    if (number.value() != 0 && used_.insert(number.value()).second) return number.value();
  }
}

std::string NameInStatement(std::string_view name, uint32_t statement) {
  return std::string(name) + '_' + support::HexDigits(statement & 0xFFFF, 4);
}

}  // namespace plcxx::dialects
