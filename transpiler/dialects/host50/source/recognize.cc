#include "transpiler/dialects/host50/source/recognize.h"

#include "transpiler/dialects/host50/source/lexer.h"

namespace plcxx::host50 {

bool Recognize(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::string_view word = FirstWord(line);
    if (EqualIgnoringCase(word, "NETWORK") || PartByEnd(word)) return true;
  }
  return false;
}

}  // namespace plcxx::host50
