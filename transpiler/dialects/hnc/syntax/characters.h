// Characters of C source text: ASCII, whatever the locale.
#pragma once

namespace plcxx::hnc {

constexpr bool IsLineBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
constexpr bool IsBlank(char c) { return IsLineBlank(c) || c == '\r' || c == '\n'; }
/// Of a name or number.
constexpr bool IsWord(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

}  // namespace plcxx::hnc
