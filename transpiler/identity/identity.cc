#include "transpiler/identity/identity.h"

#include <algorithm>
#include <optional>

#include "transpiler/identity/intel_hex.h"

namespace plcxx::identity {
namespace {

constexpr std::string_view kMagic = "plcxx-id";
constexpr uint8_t kLayout = 1;
constexpr size_t kVersionAt = 9, kOptionsAt = 12, kSourcesAt = 16, kGeneratedAt = 32, kNameAt = 48;
constexpr size_t kOptionsBytes = 4, kDigestBytes = 16, kNameBytes = 16;
constexpr std::string_view kHexDigits = "0123456789abcdef";

uint8_t ValueOfDigit(char c) {
  const size_t at = kHexDigits.find(c);
  return at == std::string_view::npos ? uint8_t{0} : static_cast<uint8_t>(at);
}

void Put(std::array<uint8_t, kBytes>& bytes, size_t at, size_t count, std::string_view digits) {
  for (size_t i = 0; i < count && 2 * i + 1 < digits.size(); ++i)
    bytes[at + i] = static_cast<uint8_t>(ValueOfDigit(digits[2 * i]) << 4 | ValueOfDigit(digits[2 * i + 1]));
}

std::string Digits(std::string_view bytes) {
  std::string digits;
  for (const char c : bytes) {
    const auto byte = static_cast<uint8_t>(c);
    digits += kHexDigits[byte >> 4];
    digits += kHexDigits[byte & 0xF];
  }
  return digits;
}

/// As much of a UTF-8 text as fits, in whole characters.
std::string_view Beginning(std::string_view text, size_t most) {
  if (text.size() <= most) return text;
  size_t end = most;
  while (end > 0 && (static_cast<uint8_t>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end);
}

std::optional<Identity> IdentityAt(std::string_view bytes) {
  if (bytes.size() < kBytes || static_cast<uint8_t>(bytes[kMagic.size()]) != kLayout) return std::nullopt;
  Identity identity;
  for (size_t i = 0; i < identity.version.size(); ++i)
    identity.version[i] = static_cast<uint8_t>(bytes[kVersionAt + i]);
  identity.options = Digits(bytes.substr(kOptionsAt, kOptionsBytes));
  identity.sources = Digits(bytes.substr(kSourcesAt, kDigestBytes));
  identity.generated = Digits(bytes.substr(kGeneratedAt, kDigestBytes));
  const std::string_view name = bytes.substr(kNameAt, kNameBytes);
  identity.program = name.substr(0, name.find('\0'));
  // Bytes that only look like the constant have no name.
  if (identity.program.empty()) return std::nullopt;
  return identity;
}

}  // namespace

std::string FirstDigits(std::string_view digest, size_t digits) {
  return digest.size() < digits ? std::string(digits, '0') : std::string(digest.substr(0, digits));
}

std::array<uint8_t, kBytes> BytesOf(const Identity& identity) {
  std::array<uint8_t, kBytes> bytes{};
  std::ranges::copy(kMagic, bytes.begin());
  bytes[kMagic.size()] = kLayout;
  std::ranges::copy(identity.version, bytes.begin() + kVersionAt);
  Put(bytes, kOptionsAt, kOptionsBytes, identity.options);
  Put(bytes, kSourcesAt, kDigestBytes, identity.sources);
  Put(bytes, kGeneratedAt, kDigestBytes, identity.generated);
  std::ranges::copy(Beginning(identity.program, kNameBytes), bytes.begin() + kNameAt);
  return bytes;
}

std::string ConstantText(const Identity& identity) {
  std::string text =
      "\n"
      "// What `plcxx identify` finds in the compiled program: which sources it was made from.\n"
      "// Some targets have no sections that a linker keeps: there it is kept by the compiler alone.\n"
      "#pragma GCC diagnostic push\n"
      "#pragma GCC diagnostic ignored \"-Wattributes\"\n"
      "[[gnu::used, gnu::retain]] static const unsigned char kPlcxxIdentity[" +
      std::to_string(kBytes) + "] = {";
  constexpr size_t kPerLine = 16;
  const std::array<uint8_t, kBytes> bytes = BytesOf(identity);
  for (size_t i = 0; i < bytes.size(); ++i) {
    text += i % kPerLine == 0 ? "\n    0x" : " 0x";
    text += kHexDigits[bytes[i] >> 4];
    text += kHexDigits[bytes[i] & 0xF];
    if (i + 1 != bytes.size()) text += ',';
  }
  return text + "};\n#pragma GCC diagnostic pop\n";
}

std::vector<Identity> FindIdentities(std::string_view bytes) {
  const std::string decoded = DecodeIntelHex(bytes);
  if (!decoded.empty()) bytes = decoded;
  std::vector<Identity> found;
  for (size_t at = bytes.find(kMagic); at != std::string_view::npos; at = bytes.find(kMagic, at + 1)) {
    const std::optional<Identity> identity = IdentityAt(bytes.substr(at));
    if (identity && std::ranges::find(found, *identity) == found.end()) found.push_back(*identity);
  }
  return found;
}

}  // namespace plcxx::identity
