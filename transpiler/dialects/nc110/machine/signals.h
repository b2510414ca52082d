// The predefined signals of the control (signals.csv): names and meanings, for documentation and a few warnings.
//
// A program can use a name only after it has defined it in a symbol file (specification D20), so nothing here takes
// part in the translation. The table is parsed at its first use.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/nc110/machine/operands.h"
#include "transpiler/support/embedded_file.h"

namespace plcxx::nc110 {

using support::EmbeddedFile;

extern const EmbeddedFile kSignalTable[];
extern const unsigned kSignalTableCount;

struct Signal {
  Operand operand;  // I is stored as U: one bit
  std::string name;
  std::string meaning;
};

/// All rows, by address; those of process 1.
std::span<const Signal> AllSignals();
/// All rows for one address of process 1 .. `processes` (an address may have one row per panel type).
std::span<const Signal> SignalsAt(const Operand& operand, uint32_t processes);

/// "RSPEPN"; several joined by ", "; empty where the control has no name.
std::string PredefinedName(const Operand& operand, uint32_t processes);
std::string Meaning(const Operand& operand, uint32_t processes);
/// A word of BCD digits.
bool HoldsBcd(const Operand& operand, uint32_t processes);

}  // namespace plcxx::nc110
