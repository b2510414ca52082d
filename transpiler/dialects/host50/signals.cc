#include "transpiler/dialects/host50/signals.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "transpiler/dialects/host50/addresses.h"
#include "transpiler/support/check.h"

namespace plcxx::host50 {
namespace {

auto Order(const Address& address) { return std::tuple(address.area, address.number); }

/// The next field of a line of comma separated values; quotes around it are removed.
std::string_view TakeField(std::string_view& line) {
  std::string_view field;
  if (line.starts_with('"')) {
    const size_t end = std::min(line.find('"', 1), line.size());
    field = line.substr(1, end - 1);
    line.remove_prefix(std::min(end + 1, line.size()));
  } else {
    field = line.substr(0, line.find(','));
    line.remove_prefix(field.size());
  }
  if (!line.empty()) line.remove_prefix(1);
  return field;
}

std::vector<Signal> ReadTable() {
  std::vector<Signal> signals;
  std::string_view rest(kSignalTable[0].text, kSignalTable[0].size);
  rest.remove_prefix(std::min(rest.find('\n') + 1, rest.size()));  // the heads of the columns
  while (!rest.empty()) {
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (line.empty()) continue;
    const AddressText address = ReadAddressText(TakeField(line), 1);
    PLCXX_CHECK(address.fault == AddressFault::kNone);
    Signal signal{.address = address.address, .name = std::string(TakeField(line)), .meaning = {}};
    TakeField(line);  // width and direction: the address tells them
    TakeField(line);
    signal.meaning = TakeField(line);
    signals.push_back(std::move(signal));
  }
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
