// Names of pins: unique, and short enough for HAL.

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "transpiler/diagnostics/host_messages.h"
#include "transpiler/host/wiring.h"

namespace plcxx::host {

std::string PinName(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool kept = letter || (c >= '0' && c <= '9') || c == '.';
    const char next = !kept ? '-' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (next == '-' && (out.empty() || out.back() == '-')) continue;
    out += next;
  }
  while (!out.empty() && out.back() == '-') out.pop_back();
  return out;
}

void NamePins(const std::string& program, std::vector<WiredPin>& pins, diag::Engine& diagnostics) {
  const size_t prefix = program.size() + 1;
  const auto fits = [&](const std::string& name) { return !name.empty() && prefix + name.size() <= kMaxPinName; };
  std::map<std::string, const WiredPin*> taken;
  for (WiredPin& pin : pins) {
    const std::string wanted = pin.name;
    const auto other = taken.find(wanted);
    if (fits(wanted) && other == taken.end()) {
      taken.emplace(wanted, &pin);
      continue;
    }
    // The address is short, and no other signal has it.
    const std::string instead = PinName(pin.address);
    if (fits(instead) && !taken.contains(instead)) {
      if (other != taken.end()) {
        diagnostics.Report(pin.range, diag::HostPinTaken, wanted, other->second->address, instead);
      } else {
        diagnostics.Report(pin.range, diag::HostPinShortened, wanted, static_cast<int64_t>(prefix + wanted.size()),
                           static_cast<int64_t>(kMaxPinName), instead);
      }
      pin.name = instead;
      taken.emplace(instead, &pin);
    } else if (other != taken.end()) {
      diagnostics.Report(pin.range, diag::HostPinSame, wanted, pin.address, other->second->address);
    } else {
      diagnostics.Report(pin.range, diag::HostPinTooLong, program + "." + wanted,
                         static_cast<int64_t>(prefix + wanted.size()), static_cast<int64_t>(kMaxPinName));
    }
  }
}

}  // namespace plcxx::host
