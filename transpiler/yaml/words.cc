#include "transpiler/yaml/words.h"

#include <algorithm>

#include "transpiler/support/hex.h"

namespace plcxx::yaml {
namespace {

constexpr int kBlockIndent = 2;  // of a block beyond its key

std::string InDoubleQuotes(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += {'\\', c};
    } else if (c == '\n') {
      quoted += "\\n";
    } else if (byte < 0x20 || byte == 0x7F) {
      quoted += "\\x" + support::HexDigits(byte, 2);
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

/// Without quotes they are no text: a key or a value that is missing.
bool ReadsAsNothing(std::string_view text) { return text == "null" || text == "Null" || text == "NULL" || text == "~"; }

}  // namespace

std::string YamlWord(const std::string& text, std::string_view plain) {
  const bool is_plain = !text.empty() && !ReadsAsNothing(text) && std::ranges::all_of(text, [plain](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           plain.find(c) != std::string_view::npos;
  });
  if (is_plain) return text;
  const bool has_controls = std::ranges::any_of(text, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
  });
  if (has_controls) return InDoubleQuotes(text);  // a line's end within other quotes is read as a blank
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

std::string YamlText(std::string_view text, size_t indent) {
  const size_t content = text.find_last_not_of('\n');
  const bool fits = content != std::string_view::npos && std::ranges::all_of(text, [](char c) {
                      const auto byte = static_cast<unsigned char>(c);
                      return c == '\n' || c == '\t' || (byte >= 0x20 && byte < 0x7F);
                    });
  if (!fits) return InDoubleQuotes(text);
  // The indicators of a block: the indent where the text itself begins with a space, and what becomes of its last
  // lines.
  const size_t ends = text.size() - content - 1;
  std::string block = "|";
  if (std::string_view(" \n\t").find(text.front()) != std::string_view::npos) block += std::to_string(kBlockIndent);
  if (ends != 1) block += ends == 0 ? "-" : "+";
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    block += "\n";
    if (!line.empty()) block.append(indent, ' ').append(line);
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return block;
}

}  // namespace plcxx::yaml
