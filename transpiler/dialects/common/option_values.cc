#include "transpiler/dialects/common/option_values.h"

#include <charconv>

namespace plcxx::dialects {

bool Number(std::string_view text, uint32_t low, uint32_t high, uint32_t& into) {
  uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < low || value > high) return false;
  into = value;
  return true;
}

bool Switch(std::string_view text, bool& into) {
  const bool on = text == "on" || text == "true", off = text == "off" || text == "false";
  if (on || off) into = on;
  return on || off;
}

}  // namespace plcxx::dialects
