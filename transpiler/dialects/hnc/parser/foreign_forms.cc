#include "transpiler/dialects/hnc/parser/foreign_forms.h"

#include <algorithm>
#include <iterator>

#include "transpiler/dialects/hnc/characters.h"

namespace plcxx::hnc {
namespace {

struct MeantWord {
  std::string_view word, remedy;
};

constexpr std::string_view kBlockEnd = "a block begins with '{' and ends with '}'";
constexpr std::string_view kElseIf = "write 'else if' with its condition in parentheses";
constexpr std::string_view kHexadecimal = "a hexadecimal number begins with 0x: 0xFF";

/// Where the syntax breaks at the word, or in a statement that begins with it.
constexpr MeantWord kForeignWords[] = {
    {"AND", "'&&' joins conditions, '&' works on bits"},
    {"OR", "'||' joins conditions, '|' works on bits"},
    {"NOT", "'!' negates a condition, '~' inverts bits"},
    {"XOR", "exclusive or is '^'"},
    {"MOD", "the remainder is '%'"},
    {"THEN", "C has no 'then': the statement follows the ')' of the condition"},
    {"ENDIF", kBlockEnd},
    {"END_IF", kBlockEnd},
    {"END_WHILE", kBlockEnd},
    {"END_FOR", kBlockEnd},
    {"BEGIN", kBlockEnd},
    {"END", kBlockEnd},
    {"ELSEIF", kElseIf},
    {"ELSIF", kElseIf},
    {"ELIF", kElseIf},
    {"VAR", "variables are declared by their type: int a;"},
    {"FUNCTION", "a function is written with its result, its name and its parameters: void f(int ch)"},
};

/// Undeclared names and types.
constexpr MeantWord kForeignNames[] = {
    {"TRUE", "write 1; a condition is true when it is not 0"},
    {"FALSE", "write 0; a condition is true when it is not 0"},
    {"NULL", "write 0"},
    {"BOOL", "C has no type for bits: write unsigned char, or a bit of a register: R[1] & 0x01"},
    {"BYTE", "write unsigned char"},
    {"UCHAR", "write unsigned char"},
    {"UINT8_T", "write unsigned char"},
    {"INT8_T", "write char"},
    {"WORD", "write unsigned int, which has 16 bits"},
    {"UINT", "write unsigned int, which has 16 bits"},
    {"UINT16_T", "write unsigned int, which has 16 bits"},
    {"INT16_T", "write int, which has 16 bits"},
    {"DWORD", "write unsigned long, which has 32 bits"},
    {"UINT32_T", "write unsigned long, which has 32 bits"},
    {"INT32_T", "write long, which has 32 bits"},
    {"DINT", "write long, which has 32 bits"},
    {"REAL", "write float"},
    {"STRING", "write an array of char"},
};

std::string Capitals(std::string_view text) {
  std::string capitals(text);
  std::ranges::transform(capitals, capitals.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return capitals;
}

template <size_t kCount>
std::string_view RemedyFor(const MeantWord (&words)[kCount], std::string_view word) {
  const std::string capitals = Capitals(word);
  const auto* const row = std::ranges::find(words, capitals, &MeantWord::word);
  return row == std::end(words) ? std::string_view() : row->remedy;
}

bool IsHexDigit(char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f'); }

/// The first word of the statement that the text ends in.
std::string_view FirstWord(std::string_view before) {
  if (const size_t border = before.find_last_of(";{}"); border != std::string_view::npos) {
    before.remove_prefix(border + 1);
  }
  before.remove_prefix(std::min(before.find_first_not_of(" \t"), before.size()));
  return before.substr(0, static_cast<size_t>(std::ranges::find_if_not(before, IsWord) - before.begin()));
}

}  // namespace

bool EndsWithType(std::string_view before) {
  while (!before.empty() && (IsLineBlank(before.back()) || before.back() == '*')) before.remove_suffix(1);
  const auto begin = std::find_if_not(before.rbegin(), before.rend(), IsWord).base();
  const std::string_view word(begin, before.end());
  constexpr std::string_view kTypes[] = {"char",     "short", "int",    "long", "signed",
                                         "unsigned", "float", "double", "void"};
  return std::ranges::find(kTypes, word) != std::end(kTypes);
}

std::string MeantByName(std::string_view name) {
  if (const std::string_view remedy = RemedyFor(kForeignNames, name); !remedy.empty()) return std::string(remedy);
  if (const std::string_view remedy = RemedyFor(kForeignWords, name); !remedy.empty()) return std::string(remedy);
  const std::string_view digits = name.substr(0, name.size() - 1);
  const bool h_form = name.size() > 1 && (name.back() == 'H' || name.back() == 'h');
  if (h_form && std::ranges::all_of(digits, IsHexDigit))
    return "a hexadecimal number begins with 0x: 0x" + std::string(digits);
  return {};
}

std::string MeantBy(std::string_view before, std::string_view token, std::string_view after) {
  const char left = before.empty() ? ' ' : before.back();
  const char right = after.empty() ? ' ' : after.front();
  if (token == ":" && right == '=') return "assign with '=' alone";
  if (token == "=" && left == ':') return "assign with '=' alone";
  if (token == "<" && left == '=') return "'less or equal' is '<='";
  if (token == ">" && left == '=') return "'greater or equal' is '>='";
  if (token == ">" && left == '<') return "'not equal' is '!='";
  const std::string_view first = FirstWord(before);
  if (token == ")" && first == "for") return "the head of for has two ';': for (i = 0; i < 3; i++)";
  if (token == "#") return std::string(kHexadecimal);
  if (const std::string_view remedy = RemedyFor(kForeignWords, token); !remedy.empty()) return std::string(remedy);
  const std::string capitals = Capitals(first);
  if (capitals == "IF" && first != "if") return "keywords are written in small letters: if";
  const bool statement = capitals == "ELSEIF" || capitals == "ELSIF" || capitals == "ELIF" || capitals == "VAR";
  return statement ? std::string(RemedyFor(kForeignWords, first)) : std::string();
}

}  // namespace plcxx::hnc
