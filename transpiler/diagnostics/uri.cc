#include "transpiler/diagnostics/uri.h"

#include <cctype>

#include "transpiler/support/hex.h"

namespace plcxx::diag {
namespace {

/// RFC 3986: what a path segment may hold as it is, and the slash. ':' would make a relative path look like a scheme.
bool IsUriCharacter(unsigned char c) {
  constexpr std::string_view kAllowed = "-._~/!$&'()*+,;=@";
  return (c < 0x80 && std::isalnum(c) != 0) || kAllowed.find(static_cast<char>(c)) != std::string_view::npos;
}

}  // namespace

std::string UriOf(std::string_view path) {
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char character : path) {
    const auto c = static_cast<unsigned char>(character);
    if (IsUriCharacter(c)) {
      uri += character;
    } else {
      uri += '%' + support::HexDigits(c, 2, support::HexLetters::kCapital);
    }
  }
  return uri;
}

}  // namespace plcxx::diag
