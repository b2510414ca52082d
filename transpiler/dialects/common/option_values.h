// How the values of `--set key=value` are read: what the option tables of the dialects share.
//
// Each function changes `into` only when the text fits, and tells whether it did.
#pragma once

#include <cstdint>
#include <string_view>

namespace plcxx::dialects {

/// A decimal number in [low, high].
bool Number(std::string_view text, uint32_t low, uint32_t high, uint32_t& into);

/// on or off. YAML writes them as true and false.
bool Switch(std::string_view text, bool& into);

/// The first word means `first`, the second `second`.
template <class Enum>
bool OneOf(std::string_view text, std::string_view first_word, Enum first, std::string_view second_word, Enum second,
           Enum& into) {
  if (text != first_word && text != second_word) return false;
  into = text == first_word ? first : second;
  return true;
}

}  // namespace plcxx::dialects
