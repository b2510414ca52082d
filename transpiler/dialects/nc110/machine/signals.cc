#include "transpiler/dialects/nc110/machine/signals.h"

#include <algorithm>
#include <tuple>

#include "transpiler/dialects/common/signal_rows.h"
#include "transpiler/dialects/nc110/machine/machine.h"
#include "transpiler/dialects/nc110/source/tokens.h"

namespace plcxx::nc110 {
namespace {

auto Order(const Operand& operand) {
  return std::tuple(operand.kind == OperandKind::kWord, operand.package, operand.number, operand.index);
}

std::vector<Signal> ReadTable() {
  std::vector<Signal> signals;
  signals.reserve(1100);
  dialects::ForEachSignalRow({kSignalTable[0].text, kSignalTable[0].size}, [&](std::string_view line) {
    const Decoded decoded = Decode(dialects::TakeField(line));
    PLCXX_CHECK(decoded.fault == OperandFault::kNone);
    Signal signal{.operand = decoded.operand, .name = dialects::TakeField(line), .meaning = {}};
    if (signal.operand.kind == OperandKind::kInput) signal.operand.kind = OperandKind::kOutput;
    dialects::TakeField(line);  // width: the address tells it
    dialects::TakeField(line);  // direction: machine.def has it
    signal.meaning = dialects::TakeField(line);
    signals.push_back(std::move(signal));
  });
  std::stable_sort(signals.begin(), signals.end(),
                   [](const Signal& a, const Signal& b) { return Order(a.operand) < Order(b.operand); });
  return signals;
}

/// As process 1 has it, I as U.
Operand Canonical(Operand operand, uint32_t processes) {
  if (operand.kind == OperandKind::kInput) operand.kind = OperandKind::kOutput;
  const bool shared = operand.package == Package::kK || operand.package == Package::kN;
  if (shared && operand.number < kProcessConnectors * processes) {
    operand.number = static_cast<uint16_t>(operand.number % kProcessConnectors);
  }
  return operand;
}

/// Signals that exist once: RSPEPN acts for all processes, the keys of connector 2N belong to the panel.
bool ExistsOnce(const Operand& signal) {
  const bool relay = signal.package == Package::kK && signal.number == 10 && signal.index == 20;
  return (relay && signal.kind == OperandKind::kOutput) || (signal.package == Package::kN && signal.number == 2);
}

}  // namespace

std::span<const Signal> AllSignals() {
  static const std::vector<Signal> signals = ReadTable();
  return signals;
}

std::span<const Signal> SignalsAt(const Operand& operand, uint32_t processes) {
  const std::span<const Signal> signals = AllSignals();
  if (!IsMemory(operand)) return {};
  const Operand wanted = Canonical(operand, processes);
  if (wanted.number != operand.number && ExistsOnce(wanted)) return {};
  const auto [first, last] =
      std::equal_range(signals.begin(), signals.end(), Signal{wanted, {}, {}},
                       [](const Signal& a, const Signal& b) { return Order(a.operand) < Order(b.operand); });
  return {first, last};
}

std::string PredefinedName(const Operand& operand, uint32_t processes) {
  std::string names;
  std::string_view before;
  for (const Signal& signal : SignalsAt(operand, processes)) {
    if (signal.name.empty() || signal.name == before) continue;
    before = signal.name;
    if (!names.empty()) names += ", ";
    names += signal.name;
  }
  return names;
}

std::string Meaning(const Operand& operand, uint32_t processes) {
  std::string meanings;
  for (const Signal& signal : SignalsAt(operand, processes)) {
    if (!meanings.empty()) meanings += "; ";
    meanings += signal.meaning;
  }
  return meanings;
}

bool HoldsBcd(const Operand& operand, uint32_t processes) {
  const auto signals = SignalsAt(operand, processes);
  return operand.kind == OperandKind::kWord && std::any_of(signals.begin(), signals.end(), [](const Signal& signal) {
           return signal.meaning.find("BCD") != std::string::npos;
         });
}

}  // namespace plcxx::nc110
