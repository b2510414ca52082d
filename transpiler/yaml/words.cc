#include "transpiler/yaml/words.h"

#include <algorithm>

namespace plcxx::yaml {

std::string YamlWord(const std::string& text, std::string_view plain) {
  const bool is_plain = !text.empty() && std::ranges::all_of(text, [plain](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           plain.find(c) != std::string_view::npos;
  });
  if (is_plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

}  // namespace plcxx::yaml
