#include "transpiler/dialects/host50/machine/signals.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "transpiler/dialects/common/signal_rows.h"
#include "transpiler/dialects/host50/machine/addresses.h"
#include "transpiler/support/check.h"

namespace plcxx::host50 {
namespace {

auto Order(const Address& address) { return std::tuple(address.area, address.number); }

std::vector<Signal> ReadTable() {
  std::vector<Signal> signals;
  dialects::ForEachSignalRow({kSignalTable[0].text, kSignalTable[0].size}, [&](std::string_view line) {
    const AddressText address = ReadAddressText(dialects::TakeField(line), 1);
    PLCXX_CHECK(address.fault == AddressFault::kNone);
    Signal signal{.address = address.address, .name = dialects::TakeField(line), .meaning = {}};
    dialects::TakeField(line);  // width and direction: the address tells them
    dialects::TakeField(line);
    signal.meaning = dialects::TakeField(line);
    signals.push_back(std::move(signal));
  });
  std::ranges::stable_sort(signals, {}, [](const Signal& signal) { return Order(signal.address); });
  return signals;
}

}  // namespace

std::span<const Signal> Signals() {
  static const std::vector<Signal> signals = ReadTable();
  return signals;
}

std::span<const Signal> SignalsAt(const Address& address) {
  const auto found = std::ranges::equal_range(Signals(), Order(InChannel1(address)), {},
                                              [](const Signal& signal) { return Order(signal.address); });
  return {found.begin(), found.end()};
}

}  // namespace plcxx::host50
