#include "transpiler/dialects/prostep/machine/signals.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "transpiler/dialects/common/signal_rows.h"
#include "transpiler/support/check.h"

namespace plcxx::prostep {
namespace {

auto Order(const Signal& signal) { return std::tuple(signal.space, signal.byte, signal.bit, signal.width); }

uint32_t TakeColumnNumber(std::string_view& text) {
  uint32_t number = 0;
  for (; !text.empty() && text.front() >= '0' && text.front() <= '9'; text.remove_prefix(1)) {
    number = number * 10 + static_cast<uint32_t>(text.front() - '0');
  }
  return number;
}

/// "I20.7", "FB201", or the bits "O27.1-0", of which the signal's `bit` is the lowest.
void TakeAddress(std::string_view text, Signal& signal) {
  const size_t letters = std::min(text.find_first_of("0123456789"), text.size());
  // DD and the like are notation here as in the manual: the space and the number count.
  const OperandClass operand_class = ClassByName(text.substr(0, letters));
  PLCXX_CHECK(operand_class != OperandClass::kNone);
  signal.space = SpaceOf(operand_class);
  text.remove_prefix(letters);
  signal.byte = TakeColumnNumber(text);
  if (!text.starts_with('.')) return;
  text.remove_prefix(1);
  const uint32_t first = TakeColumnNumber(text);
  uint32_t last = first;
  if (text.starts_with('-')) {
    text.remove_prefix(1);
    last = TakeColumnNumber(text);
  }
  signal.bit = static_cast<uint8_t>(std::min(first, last));
}

SignalDirection DirectionByName(std::string_view name) {
  if (name == "machine_in") return SignalDirection::kMachineIn;
  if (name == "machine_out") return SignalDirection::kMachineOut;
  if (name == "nc_to_plc") return SignalDirection::kNcToPlc;
  if (name == "plc_to_nc") return SignalDirection::kPlcToNc;
  PLCXX_CHECK(name == "internal");
  return SignalDirection::kInternal;
}

std::vector<Signal> ReadTable() {
  std::vector<Signal> signals;
  signals.reserve(1000);
  dialects::ForEachSignalRow({kSignalTable[0].text, kSignalTable[0].size}, [&](std::string_view line) {
    Signal signal;
    TakeAddress(dialects::TakeField(line), signal);
    signal.name = dialects::TakeField(line);
    const std::string width = dialects::TakeField(line);
    std::string_view digits = width;
    signal.width = static_cast<uint8_t>(TakeColumnNumber(digits));
    signal.direction = DirectionByName(dialects::TakeField(line));
    signal.meaning = dialects::TakeField(line);
    signals.push_back(std::move(signal));
  });
  std::ranges::stable_sort(signals, {}, Order);
  return signals;
}

}  // namespace

std::span<const Signal> Signals() {
  static const std::vector<Signal> signals = ReadTable();
  return signals;
}

std::span<const Signal> SignalsAt(Space space, uint32_t byte, uint8_t bit, uint8_t width) {
  const Signal wanted{.space = space, .byte = byte, .bit = bit, .width = width, .name = {}, .meaning = {}};
  const auto found = std::ranges::equal_range(Signals(), Order(wanted), {}, Order);
  return {found.begin(), found.end()};
}

}  // namespace plcxx::prostep
