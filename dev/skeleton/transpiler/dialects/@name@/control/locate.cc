#include "transpiler/dialects/@name@/control/locate.h"

#include <charconv>

namespace plcxx::@name@ {

std::optional<dialects::Location> Locate(const ir::NameIndex& /*names*/, std::string_view /*text*/) {
  return std::nullopt;  // the dialect has no memory yet
}

std::optional<uint64_t> ParseValue(std::string_view text) {
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace plcxx::@name@
