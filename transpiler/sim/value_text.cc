#include "transpiler/sim/value_text.h"

#include <bit>
#include <charconv>
#include <cmath>

namespace plcxx::sim {
namespace {

template <class Float>
std::string Shortest(Float value) {
  if (std::isnan(value)) return "nan";
  char digits[64];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  return {digits, end};
}

float AsF32(uint64_t value) { return std::bit_cast<float>(static_cast<uint32_t>(value)); }

}  // namespace

std::string ValueDigits(ir::Type type, uint64_t value, Sign sign) {
  if (type == ir::Type::kF32) return Shortest(AsF32(value));
  if (type == ir::Type::kF64) return Shortest(std::bit_cast<double>(value));
  if (sign == Sign::kNone || type == ir::Type::kBit || type == ir::Type::kNone) return std::to_string(value);
  const uint32_t unused = 64 - 8 * ir::Bytes(type);
  return std::to_string(static_cast<int64_t>(value << unused) >> unused);
}

bool SameValue(ir::Type type, uint64_t a, uint64_t b) {
  if (type == ir::Type::kF32 && std::isnan(AsF32(a)) && std::isnan(AsF32(b))) return true;
  if (type == ir::Type::kF64 && std::isnan(std::bit_cast<double>(a)) && std::isnan(std::bit_cast<double>(b)))
    return true;
  return a == b;
}

}  // namespace plcxx::sim
