#include "transpiler/ir/text_format.h"

#include <charconv>
#include <unordered_map>
#include <unordered_set>

#include "transpiler/support/hex.h"

namespace plcxx::ir::text {
namespace {

constexpr std::string_view kPunctuation = "()[]{},:=";

bool IsWordCharacter(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte > ' ' && byte != 0x7F && c != ';' && c != '"' && kPunctuation.find(c) == std::string_view::npos;
}

/// The string literal at `line[i]`, which is a quote; leaves `i` after the closing quote.
std::optional<std::string> ReadString(std::string_view line, size_t& i) {
  std::string out;
  for (++i; i < line.size(); ++i) {
    if (line[i] == '"') {
      ++i;
      return out;
    }
    if (line[i] != '\\') {
      out += line[i];
      continue;
    }
    if (++i == line.size()) return std::nullopt;
    if (line[i] == '"' || line[i] == '\\') {
      out += line[i];
    } else if (line[i] == 'n') {
      out += '\n';
    } else if (line[i] == 'x' && i + 2 < line.size()) {
      const std::optional<uint8_t> high = support::HexValue(line[i + 1]), low = support::HexValue(line[i + 2]);
      if (!high || !low) return std::nullopt;
      out += static_cast<char>(*high * 16 + *low);
      i += 2;
    } else {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace

std::string Quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (byte < ' ' || byte == 0x7F) {
      out += "\\x" + support::HexDigits(byte, 2);
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string Word(std::string_view text) {
  bool word = !text.empty();
  for (const char c : text) word = word && IsWordCharacter(c);
  return word ? std::string(text) : Quoted(text);
}

std::optional<std::vector<Token>> Tokens(std::string_view line) {
  std::vector<Token> tokens;
  size_t i = 0;
  while (i < line.size() && line[i] != ';') {
    const char c = line[i];
    if (c == '"') {
      std::optional<std::string> string = ReadString(line, i);
      if (!string) return std::nullopt;
      tokens.push_back({TokenKind::kString, std::move(*string)});
    } else if (kPunctuation.find(c) != std::string_view::npos) {
      tokens.push_back({TokenKind::kPunctuation, std::string(1, c)});
      ++i;
    } else if (IsWordCharacter(c)) {
      const size_t begin = i;
      while (i < line.size() && IsWordCharacter(line[i])) ++i;
      tokens.push_back({TokenKind::kWord, std::string(line.substr(begin, i - begin))});
    } else {
      ++i;
    }
  }
  return tokens;
}

std::optional<uint64_t> Number(std::string_view text) {
  const bool hex = text.starts_with("0x");
  if (hex) text.remove_prefix(2);
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, hex ? 16 : 10);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string Hex(uint64_t value) {
  char digits[16];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value, 16);
  return std::string(digits, end);
}

std::string Spelled(uint64_t value, uint32_t base) { return base == 16 ? "0x" + Hex(value) : std::to_string(value); }

std::vector<std::string> Handles(const std::vector<std::string>& names) {
  std::vector<std::string> handles;
  handles.reserve(names.size());
  std::unordered_map<std::string_view, uint32_t> copies;
  std::unordered_set<std::string> taken(names.begin(), names.end());
  for (const std::string& name : names) {
    uint32_t& copy = copies[name];
    std::string handle = name;
    while (++copy > 1) {
      handle = name + '~' + std::to_string(copy);
      if (taken.insert(handle).second) break;
    }
    if (copy <= 1) handle = name;
    handles.push_back(std::move(handle));
  }
  return handles;
}

std::vector<std::string> StatementHandles(const Program& program) {
  std::vector<std::string> names;
  names.reserve(program.statements.size());
  for (const Statement& statement : program.statements) names.push_back('s' + Hex(statement.id));
  return Handles(names);
}

}  // namespace plcxx::ir::text
