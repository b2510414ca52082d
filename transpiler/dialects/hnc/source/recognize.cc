#include "transpiler/dialects/hnc/source/recognize.h"

#include <algorithm>
#include <initializer_list>

#include "transpiler/dialects/hnc/syntax/characters.h"

namespace plcxx::hnc {
namespace {

/// A name with a '(' after it.
bool HasCall(std::string_view text, std::string_view name) {
  for (size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
    if (at > 0 && IsWord(text[at - 1])) continue;
    const size_t next = text.find_first_not_of(" \t", at + name.size());
    if (next != std::string_view::npos && text[next] == '(') return true;
  }
  return false;
}

bool HasInclude(std::string_view text) {
  for (size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1)) {
    const size_t word = text.find_first_not_of(" \t", at + 1);
    if (word != std::string_view::npos && text.substr(word).starts_with("include")) return true;
  }
  return false;
}

}  // namespace

bool Recognize(std::string_view text) {
  const std::initializer_list<std::string_view> entries = {"init", "plc1", "plc2"};
  const auto found = std::ranges::count_if(entries, [&](std::string_view name) { return HasCall(text, name); });
  return found >= 2 || (found >= 1 && HasInclude(text));
}

}  // namespace plcxx::hnc
