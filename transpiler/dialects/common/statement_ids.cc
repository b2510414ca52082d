#include "transpiler/dialects/common/statement_ids.h"

namespace plcxx::dialects {

uint32_t StatementIds::Next(TextHash text) {
  for (uint32_t count = equal_texts_[text.value()]++;; ++count) {
    TextHash number = text;
    for (uint32_t rest = count; rest > 0; rest >>= 8) number.Add(static_cast<char>(rest & 0xFF));
    if (number.value() != 0 && used_.insert(number.value()).second) return number.value();
  }
}

std::string NameInStatement(std::string_view name, uint32_t statement) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  constexpr int kBits = 16;
  std::string result(name);
  result += '_';
  for (int shift = kBits - 4; shift >= 0; shift -= 4) result += kDigits[(statement >> shift) & 0xF];
  return result;
}

}  // namespace plcxx::dialects
