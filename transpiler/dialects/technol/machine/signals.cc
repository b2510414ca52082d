#include "transpiler/dialects/technol/machine/signals.h"

#include <algorithm>
#include <charconv>

#include "transpiler/dialects/common/signal_rows.h"
#include "transpiler/dialects/technol/source/lexer.h"
#include "transpiler/support/check.h"

namespace plcxx::technol {
namespace {

constexpr std::string_view kDirections[] = {"machine_in", "machine_out", "nc_to_plc", "plc_to_nc", "internal"};

struct ArrayRow {
  std::string_view name;
  uint8_t width;
};
constexpr ArrayRow kArrays[] = {
#define TECHNOL_ARRAY(Text, Width) {Text, Width},
#include "transpiler/dialects/technol/machine/machine.def"
};

std::optional<uint32_t> ReadDecimal(std::string_view text) {
  uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "SYS+7.0", "IN+3".
bool ReadAddress(std::string_view text, Signal& signal) {
  const size_t plus = text.find('+');
  if (plus == std::string_view::npos) return false;
  const std::optional<Area> area = AreaByName(Upper(text.substr(0, plus)));
  text.remove_prefix(plus + 1);
  const size_t dot = std::min(text.find('.'), text.size());
  const std::optional<uint32_t> byte = ReadDecimal(text.substr(0, dot));
  const std::optional<uint32_t> bit = dot < text.size() ? ReadDecimal(text.substr(dot + 1)) : 0;
  if (!area || !byte || !bit || *bit > 7 || (dot < text.size()) != (signal.width == 1)) return false;
  signal.area = *area;
  signal.byte = *byte;
  signal.bit = static_cast<uint8_t>(*bit);
  return uint64_t{*byte} + (signal.width + 7) / 8 <= BytesOf(*area);
}

bool IsPlainName(std::string_view name) {
  return !name.empty() && name.size() <= kNameLength && IsNameStart(name.front()) && name != "?" &&
         std::ranges::all_of(name, IsNameCharacter);
}

std::vector<Signal> ReadTable() {
  std::vector<Signal> signals;
  dialects::ForEachSignalRow({kSignalTable[0].text, kSignalTable[0].size}, [&](std::string_view row) {
    std::optional<Signal> signal = ReadSignal(TrimBlanks(row));
    PLCXX_CHECK(signal.has_value());
    signals.push_back(std::move(*signal));
  });
  return signals;
}

}  // namespace

std::span<const Signal> Signals() {
  static const std::vector<Signal> signals = ReadTable();
  return signals;
}

bool IsSignalHead(std::string_view row) { return row.starts_with("address,"); }

std::optional<Signal> ReadSignal(std::string_view row) {
  Signal signal;
  const std::string address = dialects::TakeField(row);
  signal.name = dialects::TakeField(row);
  const std::optional<uint32_t> width = ReadDecimal(dialects::TakeField(row));
  const std::string direction = dialects::TakeField(row);
  signal.meaning = dialects::TakeField(row);
  const auto known = std::ranges::find(kDirections, direction);
  if (!width || (*width != 1 && (*width == 0 || *width % 8 != 0)) || known == std::end(kDirections))
    return std::nullopt;
  signal.width = *width;
  signal.direction = static_cast<Direction>(known - std::begin(kDirections));
  if (!IsPlainName(signal.name) || !ReadAddress(address, signal)) return std::nullopt;
  return signal;
}

uint8_t FieldWidth(const Signal& signal) {
  const auto row = std::ranges::find(kArrays, signal.name, &ArrayRow::name);
  if (row != std::end(kArrays)) return row->width;
  return signal.width <= 32 ? static_cast<uint8_t>(signal.width) : 0;
}

bool IsField(const Signal& signal) {
  return (signal.area == Area::kTabTechnol || signal.area == Area::kSetNctab) && signal.name != Name(signal.area);
}

}  // namespace plcxx::technol
