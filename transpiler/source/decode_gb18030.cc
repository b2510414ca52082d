// GB18030: ASCII; two bytes (first 81H to FEH, second 40H to FEH but 7FH); four bytes (the second and the fourth are
// digits). What has one of these forms is cut out here, so that a broken character costs one byte and never the line
// end after it; what it means is ICU's.
#include <unicode/ucnv.h>
#include <unicode/ustring.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "transpiler/source/decode.h"

namespace plcxx::source {
namespace {

struct CloseConverter {
  void operator()(UConverter* converter) const { ucnv_close(converter); }
};
using Converter = std::unique_ptr<UConverter, CloseConverter>;

/// None without ICU's data: then nothing can be decoded, but nothing may fail either.
Converter OpenConverter() {
  UErrorCode error = U_ZERO_ERROR;
  Converter converter(ucnv_open("gb18030", &error));
  if (U_FAILURE(error)) return nullptr;
  ucnv_setToUCallBack(converter.get(), UCNV_TO_U_CALLBACK_STOP, nullptr, nullptr, nullptr, &error);
  return U_SUCCESS(error) ? std::move(converter) : nullptr;
}

/// The length of what has the form of a character of more than one byte; 0 where nothing has.
size_t FormLength(std::string_view bytes, size_t at) {
  const auto byte = [&](size_t i) -> unsigned {
    return at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0u;
  };
  const auto is_lead = [&](size_t i) { return byte(i) >= 0x81 && byte(i) <= 0xFE; };
  const auto is_digit = [&](size_t i) { return byte(i) >= 0x30 && byte(i) <= 0x39; };
  if (!is_lead(0)) return 0;
  if (byte(1) >= 0x40 && byte(1) <= 0xFE && byte(1) != 0x7F) return 2;
  return is_digit(1) && is_lead(2) && is_digit(3) ? 4 : 0;
}

/// The end of the stretch at `at` in which everything has the form of such characters.
size_t FormsEnd(std::string_view bytes, size_t at) {
  for (size_t length = FormLength(bytes, at); length != 0; length = FormLength(bytes, at)) at += length;
  return at;
}

/// Appends the UTF-8 of characters of two or four bytes; false, and nothing appended, where one has no meaning.
bool AppendCharacters(UConverter* converter, std::string_view bytes, std::string& text) {
  if (converter == nullptr) return false;
  UErrorCode error = U_ZERO_ERROR;
  std::vector<char16_t> units(bytes.size());
  const int32_t count = ucnv_toUChars(converter, units.data(), static_cast<int32_t>(units.size()), bytes.data(),
                                      static_cast<int32_t>(bytes.size()), &error);
  if (error == U_STRING_NOT_TERMINATED_WARNING) error = U_ZERO_ERROR;
  if (U_FAILURE(error)) return false;
  std::string utf8(static_cast<size_t>(count) * 3, '\0');
  int32_t length = 0;
  u_strToUTF8(utf8.data(), static_cast<int32_t>(utf8.size()), &length, units.data(), count, &error);
  if (U_FAILURE(error)) return false;
  text.append(utf8, 0, static_cast<size_t>(length));
  return true;
}

}  // namespace

Decoded DecodeGb18030(std::string_view bytes) {
  const Converter converter = OpenConverter();
  Decoded decoded;
  decoded.text.reserve(bytes.size() + bytes.size() / 2);
  for (size_t at = 0; at < bytes.size();) {
    const size_t ascii_end = SkipAscii(bytes, at);
    decoded.text.append(bytes, at, ascii_end - at);
    at = ascii_end;
    if (at == bytes.size()) break;
    const size_t end = FormsEnd(bytes, at);
    if (end > at && AppendCharacters(converter.get(), bytes.substr(at, end - at), decoded.text)) {
      at = end;
      continue;
    }
    // Somewhere in it stands what means nothing: one character after the other.
    for (const size_t last = std::max(end, at + 1); at < last;) {
      const size_t length = FormLength(bytes, at);
      if (length != 0 && AppendCharacters(converter.get(), bytes.substr(at, length), decoded.text)) {
        at += length;
      } else {
        decoded.replaced.push_back(static_cast<uint32_t>(decoded.text.size()));
        decoded.text += kReplacementUtf8;
        ++at;
      }
    }
  }
  return decoded;
}

std::string EncodeGb18030(std::string_view utf8) {
  const Converter converter = OpenConverter();
  std::string bytes;
  for (size_t at = 0; at < utf8.size();) {
    const size_t length = std::max<size_t>(Utf8Length(utf8, at), 1);
    const std::string_view character = utf8.substr(at, length);
    at += length;
    if (length == 1) {
      bytes += character;
      continue;
    }
    std::array<char16_t, 2> units{};
    std::array<char, 8> encoded{};
    UErrorCode error = U_ZERO_ERROR;
    int32_t count = 0;
    u_strFromUTF8(units.data(), static_cast<int32_t>(units.size()), &count, character.data(),
                  static_cast<int32_t>(character.size()), &error);
    const bool known = character != kReplacementUtf8 && converter != nullptr;
    const int32_t written = known ? ucnv_fromUChars(converter.get(), encoded.data(),
                                                    static_cast<int32_t>(encoded.size()), units.data(), count, &error)
                                  : 0;
    if (known && U_SUCCESS(error)) {
      bytes.append(encoded.data(), static_cast<size_t>(written));
    } else {
      bytes += '?';
    }
  }
  return bytes;
}

size_t Gb18030Length(std::string_view utf8) { return EncodeGb18030(utf8).size(); }

}  // namespace plcxx::source
