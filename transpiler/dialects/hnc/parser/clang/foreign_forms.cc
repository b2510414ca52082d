#include "transpiler/dialects/hnc/parser/clang/foreign_forms.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <iterator>

#include "transpiler/dialects/hnc/syntax/characters.h"

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

/// Extensions that are words; what is not here says nothing that the program needs.
constexpr MeantWord kExtensionWords[] = {
    {"_Pragma", "write #pragma on a line of its own"},
    {"__int64", "write long, which has 32 bits"},
    {"_int64", "write long, which has 32 bits"},
    {"__int128", "write long, which has 32 bits"},
    {"__int32", "write long, which has 32 bits"},
    {"__int16", "write int, which has 16 bits"},
    {"__int8", "write char"},
    {"_Bool", "write unsigned char"},
    {"_Complex", "write a struct with two members"},
    {"__complex__", "write a struct with two members"},
    {"__func__", "write the function's name in quotation marks"},
    {"__FUNCTION__", "write the function's name in quotation marks"},
    {"__PRETTY_FUNCTION__", "write the function's name in quotation marks"},
    {"_Generic", "write the expression for the type that it has here"},
    {"__typeof", "write the type itself"},
    {"__typeof__", "write the type itself"},
    {"__auto_type", "write the type itself"},
    {"__alignof", "write 1: nothing is aligned here"},
    {"__alignof__", "write 1: nothing is aligned here"},
    {"_Alignof", "write 1: nothing is aligned here"},
    {"_Static_assert", "delete it, or check with #if and #error"},
    {"__const", "write const"},
    {"__const__", "write const"},
    {"__signed", "write signed"},
    {"__signed__", "write signed"},
    {"__volatile", "write volatile"},
    {"__volatile__", "write volatile"},
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

std::string_view RemedyOfTypes(std::string_view words) {
  constexpr MeantWord kRemedies[] = {
      {"more initialisers than there is room for", "make the array larger, or leave values out"},
      {"the string is longer than the array", "make the array longer: a text of 3 characters has 4 bytes"},
      {"an array is initialised with { } or a string", "write the values in braces: {1, 2, 3}"},
      {"a value is returned from a void function",
       "write return alone, or a type for void in front of the function's name"},
      {"a void function returns nothing", "write return alone, or a type for void in front of the function's name"},
      {"what is called is no function", "an element of an array is written in brackets: a[1]"},
      {"'.' needs a struct or union", "a bit of a register is R[1] & 0x01; a member that a pointer leads to is p->m"},
      {"'->' needs a pointer to a struct or union", "write '.' for a member of a variable"},
      {"a bit-field is int, unsigned or char", "write unsigned in front of its name"},
  };
  const auto* const row = std::ranges::find(kRemedies, words, &MeantWord::word);
  return row == std::end(kRemedies) ? std::string_view() : row->remedy;
}

std::string InsteadOfWord(std::string_view word) {
  if (word.starts_with("__builtin_")) return "write the calculation itself";
  const auto* const row = std::ranges::find(kExtensionWords, word, &MeantWord::word);
  return row == std::end(kExtensionWords) ? "delete it" : std::string(row->remedy);
}

std::string InsteadOfBinary(std::string_view number) {
  uint32_t value = 0;
  const std::string_view digits = number.substr(2);
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value, 2);
  const std::string suffix(read.ptr, digits.data() + digits.size());
  const bool other_digit = !suffix.empty() && suffix.front() >= '0' && suffix.front() <= '9';
  if (read.ec != std::errc{} || read.ptr == digits.data() || other_digit) {
    return "write the number in hexadecimal, such as 0x05";
  }
  constexpr size_t kLongest = 11;  // 0xFFFFFFFF and the end
  char text[kLongest];
  std::snprintf(text, sizeof text, value > 0xFF ? "0x%04X" : "0x%02X", value);
  return std::string("write ") + text + suffix;
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
  if (token == "," && first == "case") return "each value has a case of its own: case 1: case 2:";
  if (token == "#") return std::string(kHexadecimal);
  if (const std::string_view remedy = RemedyFor(kForeignWords, token); !remedy.empty()) return std::string(remedy);
  const std::string capitals = Capitals(first);
  if (capitals == "IF" && first != "if") return "keywords are written in small letters: if";
  const bool statement = capitals == "ELSEIF" || capitals == "ELSIF" || capitals == "ELIF" || capitals == "VAR";
  return statement ? std::string(RemedyFor(kForeignWords, first)) : std::string();
}

}  // namespace plcxx::hnc
