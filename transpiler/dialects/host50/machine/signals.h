// The documented signals of the control (signals.csv): names and meanings of channel 1's addresses.
//
// Data for predefined symbols (option PREDEFINED), for W11 and for documentation. The table is parsed at its first use.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "transpiler/dialects/host50/machine/machine.h"
#include "transpiler/support/embedded_file.h"

namespace plcxx::host50 {

using support::EmbeddedFile;

extern const EmbeddedFile kSignalTable[];
extern const unsigned kSignalTableCount;

struct Signal {
  Address address;
  std::string name;
  std::string meaning;
};

/// All signals, by address; an address of the panels may have two, one for each type of panel.
std::span<const Signal> Signals();
/// Of an address of any channel; empty: undocumented.
std::span<const Signal> SignalsAt(const Address& address);

}  // namespace plcxx::host50
