#include "transpiler/diagnostics/uri.h"

#include <cctype>

namespace plcxx::diag {
namespace {

/// RFC 3986: what a path segment may hold as it is, and the slash. ':' would make a relative path look like a scheme.
bool IsUriCharacter(unsigned char c) {
  constexpr std::string_view kAllowed = "-._~/!$&'()*+,;=@";
  return (c < 0x80 && std::isalnum(c) != 0) || kAllowed.find(static_cast<char>(c)) != std::string_view::npos;
}

}  // namespace

std::string UriOf(std::string_view path) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char character : path) {
    const auto c = static_cast<unsigned char>(character);
    if (IsUriCharacter(c)) {
      uri += character;
    } else {
      uri += {'%', kDigits[c >> 4], kDigits[c & 15]};
    }
  }
  return uri;
}

}  // namespace plcxx::diag
