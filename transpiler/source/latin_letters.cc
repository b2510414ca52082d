// Names in any script, written in Latin letters, by ICU's rules.
#include <unicode/translit.h>
#include <unicode/unistr.h>

#include <memory>

#include "transpiler/source/characters.h"

namespace plcxx::source {

std::string InLatinLetters(std::string_view text) {
  icu::UnicodeString letters =
      icu::UnicodeString::fromUTF8(icu::StringPiece(text.data(), static_cast<int32_t>(text.size())));
  UErrorCode status = U_ZERO_ERROR;
  const std::unique_ptr<icu::Transliterator> rules(
      icu::Transliterator::createInstance("Any-Latin; Latin-ASCII", UTRANS_FORWARD, status));
  if (U_SUCCESS(status) && rules != nullptr) rules->transliterate(letters);
  std::string ascii;
  for (int32_t i = 0; i < letters.length(); ++i) {
    const char16_t c = letters[i];
    ascii += c < 0x80 ? static_cast<char>(c) : '_';
  }
  return ascii;
}

}  // namespace plcxx::source
