#include "transpiler/identity/intel_hex.h"

#include <cstdint>
#include <optional>

namespace plcxx::identity {
namespace {

constexpr uint8_t kData = 0, kSegmentAddress = 2, kLinearAddress = 4;

std::optional<uint8_t> DigitOf(char c) {
  if (c >= '0' && c <= '9') return static_cast<uint8_t>(c - '0');
  if (c >= 'A' && c <= 'F') return static_cast<uint8_t>(c - 'A' + 10);
  if (c >= 'a' && c <= 'f') return static_cast<uint8_t>(c - 'a' + 10);
  return std::nullopt;
}

/// The bytes of a record without its sum; none when it is damaged.
std::optional<std::string> BytesOfRecord(std::string_view line) {
  constexpr size_t kLeast = 5;  // length, address, type and sum
  std::string bytes;
  uint8_t sum = 0;
  for (size_t i = 1; i + 1 < line.size(); i += 2) {
    const std::optional<uint8_t> high = DigitOf(line[i]), low = DigitOf(line[i + 1]);
    if (!high || !low) return std::nullopt;
    const auto byte = static_cast<uint8_t>(*high << 4 | *low);
    bytes += static_cast<char>(byte);
    sum = static_cast<uint8_t>(sum + byte);
  }
  if (bytes.size() < kLeast || sum != 0 || bytes.size() != kLeast + static_cast<uint8_t>(bytes[0])) return std::nullopt;
  bytes.pop_back();
  return bytes;
}

}  // namespace

std::string DecodeIntelHex(std::string_view text) {
  if (!text.starts_with(':')) return {};
  std::string all;
  uint64_t base = 0, next = 0;
  while (!text.empty()) {
    const size_t end = text.find_first_of("\r\n");
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.starts_with(':')) continue;
    const std::optional<std::string> record = BytesOfRecord(line);
    if (!record) continue;
    const auto at = [&record](size_t i) { return uint64_t{static_cast<uint8_t>((*record)[i])}; };
    const uint64_t address = at(1) << 8 | at(2);
    const uint64_t type = at(3);
    const std::string_view data = std::string_view(*record).substr(4);
    if (type == kData) {
      if (base + address != next && !all.empty()) all += '\0';
      all += data;
      next = base + address + data.size();
    } else if (data.size() == 2 && (type == kSegmentAddress || type == kLinearAddress)) {
      base = (at(4) << 8 | at(5)) << (type == kLinearAddress ? 16 : 4);
    }
  }
  return all;
}

}  // namespace plcxx::identity
