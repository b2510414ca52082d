#include "transpiler/dialects/common/statement_ids.h"

#include <algorithm>
#include <utility>

#include "transpiler/support/hex.h"

namespace plcxx::dialects {

void StatementIds::Grow() {
  constexpr size_t kFirst = 1024;
  const std::vector<Hash> before = std::exchange(hashes_, std::vector<Hash>(std::max(kFirst, 2 * hashes_.size())));
  count_ = 0;
  for (const Hash& hash : before) {
    if (hash.texts > 0 || hash.is_used) At(hash.value) = hash;
  }
}

StatementIds::Hash& StatementIds::At(uint32_t value) {
  if (2 * count_ >= hashes_.size()) Grow();
  for (size_t at = value % hashes_.size();; at = (at + 1) % hashes_.size()) {
    Hash& hash = hashes_[at];
    const bool is_free = hash.texts == 0 && !hash.is_used;
    if (!is_free && hash.value != value) continue;
    if (is_free) {
      hash.value = value;
      ++count_;
    }
    return hash;
  }
}

uint32_t StatementIds::Next(TextHash text) {
  for (uint32_t count = At(text.value()).texts++;; ++count) {
    TextHash number = text;
    for (uint32_t rest = count; rest > 0; rest >>= 8) number.Add(static_cast<char>(rest & 0xFF));
    if (number.value() == 0) continue;
    Hash& hash = At(number.value());
    if (hash.is_used) continue;
    hash.is_used = true;
    return number.value();
  }
}

std::string NameInStatement(std::string_view name, uint32_t statement) {
  return std::string(name) + '_' + support::HexDigits(statement & 0xFFFF, 4);
}

}  // namespace plcxx::dialects
