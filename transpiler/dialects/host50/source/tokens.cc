#include "transpiler/dialects/host50/source/tokens.h"

#include <bit>
#include <charconv>
#include <limits>
#include <system_error>

#include "transpiler/dialects/host50/machine/machine.h"
#include "transpiler/support/check.h"

namespace plcxx::host50 {
namespace {

int64_t DecimalOf(std::string_view text) {
  const bool negative = text.front() == '-';
  if (negative || text.front() == '+') text.remove_prefix(1);
  constexpr int64_t kMost = std::numeric_limits<int64_t>::max();
  int64_t value = 0;
  for (const char c : text) {
    const int64_t digit = c - '0';
    if (value > (kMost - digit) / 10) return negative ? -kMost : kMost;
    value = value * 10 + digit;
  }
  return negative ? -value : value;
}

/// Of a number that from_chars cannot give: is it beyond the greatest float, or below the least one? The power of ten
/// of its first digit that is not 0 tells.
bool IsAboveOne(std::string_view text) {
  constexpr int64_t kMost = 1'000'000'000;
  int64_t power = 0;
  bool behind_point = false, found = false;
  size_t at = 0;
  for (; at < text.size() && Upper(text[at]) != 'E'; ++at) {
    if (text[at] == '.') {
      behind_point = true;
    } else if (!found && behind_point) {
      --power;
      found = text[at] != '0';
    } else if (!found) {
      found = text[at] != '0';
    } else if (!behind_point) {
      ++power;
    }
  }
  int64_t exponent = 0;
  bool negative = false;
  for (size_t i = at + 1; i < text.size(); ++i) {
    if (text[i] == '-') negative = true;
    if (IsDigit(text[i]) && exponent < kMost) exponent = exponent * 10 + (text[i] - '0');
  }
  return power + (negative ? -exponent : exponent) > 0;
}

}  // namespace

std::string_view Name(TokenKind kind) {
  switch (kind) {
    case TokenKind::kEnd:
      return "end";
    case TokenKind::kWord:
      return "word";
    case TokenKind::kQuotedSymbol:
      return "quoted-symbol";
    case TokenKind::kAddress:
      return "address";
    case TokenKind::kInteger:
      return "integer";
    case TokenKind::kHex:
      return "hex";
    case TokenKind::kFloat:
      return "float";
    case TokenKind::kString:
      return "string";
    case TokenKind::kQuote:
      return "quote";
    case TokenKind::kText:
      return "text";
    case TokenKind::kRow:
      return "row";
    case TokenKind::kComma:
      return "','";
    case TokenKind::kEquals:
      return "'='";
    case TokenKind::kAssign:
      return "':='";
    case TokenKind::kExclamation:
      return "'!'";
    case TokenKind::kOpenParenthesis:
      return "'('";
    case TokenKind::kCloseParenthesis:
      return "')'";
    case TokenKind::kPlus:
      return "'+'";
    case TokenKind::kMinus:
      return "'-'";
    case TokenKind::kStar:
      return "'*'";
    case TokenKind::kSlash:
      return "'/'";
    case TokenKind::kAmpersand:
      return "'&'";
    case TokenKind::kBar:
      return "'|'";
    case TokenKind::kLess:
      return "'<'";
    case TokenKind::kGreater:
      return "'>'";
    case TokenKind::kLessEqual:
      return "'<='";
    case TokenKind::kGreaterEqual:
      return "'>='";
    case TokenKind::kNotEqual:
      return "'<>'";
    case TokenKind::kOpenString:
      return "open-string";
    case TokenKind::kOpenQuotedSymbol:
      return "open-quoted-symbol";
    case TokenKind::kCharacter:
      return "character";
  }
  PLCXX_UNREACHABLE();
}

Integer IntegerOf(const Token& token, std::string_view text) {
  if (token.kind == TokenKind::kHex) {
    constexpr size_t kMostDigits = 8;
    const std::string_view digits = text.substr(1);
    uint32_t pattern = 0;
    if (digits.size() > kMostDigits) return {};
    std::from_chars(digits.data(), digits.data() + digits.size(), pattern, 16);
    return {static_cast<int32_t>(pattern), true};
  }
  Integer integer{.value = DecimalOf(text)};
  integer.fits =
      integer.value >= std::numeric_limits<int32_t>::min() && integer.value <= std::numeric_limits<int32_t>::max();
  return integer;
}

std::optional<uint32_t> FloatBitsOf(const Token& token, std::string_view text) {
  if (token.kind == TokenKind::kHex) {
    const Integer integer = IntegerOf(token, text);
    if (!integer.fits) return std::nullopt;
    return std::bit_cast<uint32_t>(static_cast<float>(integer.value));
  }
  const bool negative = text.front() == '-';
  if (negative || text.front() == '+') text.remove_prefix(1);
  float value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec == std::errc::result_out_of_range) {
    if (IsAboveOne(text)) return std::nullopt;
    value = 0;
  }
  return std::bit_cast<uint32_t>(negative ? -value : value);
}

std::optional<uint32_t> NumberBehind(std::string_view prefix, std::string_view word) {
  constexpr uint32_t kMost = 100'000;
  if (word.size() <= prefix.size() || !EqualIgnoringCase(word.substr(0, prefix.size()), prefix)) return std::nullopt;
  uint32_t number = 0;
  for (const char c : word.substr(prefix.size())) {
    if (!IsDigit(c)) return std::nullopt;
    number = number * 10 + static_cast<uint32_t>(c - '0');
    if (number > kMost) number = kMost;
  }
  return number;
}

}  // namespace plcxx::host50
