// What the tests of loading share: text in an 8-bit encoding, and loads that must succeed or must not.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>

#include "transpiler/source/decode.h"
#include "transpiler/source/source.h"

namespace plcxx::source {

/// UTF-8 of characters that `encoding` has, in that encoding.
inline std::string Encoded(std::string_view utf8, Encoding encoding) {
  std::string bytes;
  for (size_t at = 0; at < utf8.size();) {
    const size_t length = Utf8Length(utf8, at);
    unsigned value = static_cast<unsigned char>(utf8[at]);
    if (length > 1) value &= length == 2 ? 0x1Fu : 0x0Fu;
    for (size_t i = 1; i < length; ++i) value = value << 6 | (static_cast<unsigned char>(utf8[at + i]) & 0x3F);
    at += length;
    const auto& upper = UpperHalf(encoding);
    const auto found = std::ranges::find(upper, static_cast<char16_t>(value));
    EXPECT_TRUE(value < 0x80 || found != upper.end()) << value << " does not exist in " << Name(encoding);
    bytes += static_cast<char>(value < 0x80 ? value : 0x80 + static_cast<unsigned>(found - upper.begin()));
  }
  return bytes;
}

inline FileId Loaded(const std::variant<FileId, LoadError>& result) {
  const auto* error = std::get_if<LoadError>(&result);
  EXPECT_EQ(error, nullptr) << error->detail;
  return error != nullptr ? FileId() : std::get<FileId>(result);
}

inline LoadError Refused(const std::variant<FileId, LoadError>& result) {
  const auto* error = std::get_if<LoadError>(&result);
  EXPECT_NE(error, nullptr) << "it was loaded";
  return error != nullptr ? *error : LoadError{};
}

}  // namespace plcxx::source
