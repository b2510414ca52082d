// Tokens of dialect host50 (specification 2.4, 2.5) and the numbers they spell.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "transpiler/source/source.h"

namespace plcxx::host50 {

enum class TokenKind : uint8_t {
  kEnd,           // of the statement; what a cursor shows after the last token
  kWord,          // keyword, mnemonic, bare symbol, unit, pin, SR4, J3, L0003: its place decides
  kQuotedSymbol,  // with its apostrophes and perhaps an attribute: 'axis4-'.Q
  kAddress,       // from '%' to the next delimiter, well formed or not
  kInteger,       // decimal; outside of expressions with its sign
  kHex,
  kFloat,
  kString,  // with its quotes
  kQuote,   // around the argument of COMP or OPRT
  kText,    // of an unquoted REMARK
  kRow,     // of a drawing, with its comment
  kComma,
  kEquals,
  kAssign,  // :=
  kExclamation,
  kOpenParenthesis,
  kCloseParenthesis,
  kPlus,
  kMinus,
  kStar,
  kSlash,
  kAmpersand,
  kBar,
  kLess,
  kGreater,
  kLessEqual,
  kGreaterEqual,
  kNotEqual,
  kOpenString,        // bad: never closed
  kOpenQuotedSymbol,  // bad: never closed
  kCharacter,         // bad: a character without a meaning; its range is that character
};

/// "word", "'='": for `print tokens`.
std::string_view Name(TokenKind kind);
/// E111 instead of a token.
constexpr bool IsBad(TokenKind kind) { return kind >= TokenKind::kOpenString; }

struct Token {
  TokenKind kind = TokenKind::kEnd;
  source::Range range;
};

/// What a decimal or '$' integer spells. Decimal: -2^63 .. 2^63-1, stops at the ends. Hexadecimal: an int32 pattern.
struct Integer {
  int64_t value = 0;
  bool fits = false;  // an int32, or 1 to 8 hexadecimal digits
};
Integer IntegerOf(const Token& token, std::string_view text);

/// The binary32 pattern nearest to a number of any of the three forms (ties to even); none when it is too large.
std::optional<uint32_t> FloatBitsOf(const Token& token, std::string_view text);

/// "SR4", "J3", "L0003": the digits after a prefix of letters (without regard to case), stopping at 100,000; none when
/// the word has another form.
std::optional<uint32_t> NumberBehind(std::string_view prefix, std::string_view word);

}  // namespace plcxx::host50
