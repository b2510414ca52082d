// The predefined signals of the control (signals.csv): names, directions and meanings, for documentation and warnings.
//
// The language has no symbol names, so nothing here takes part in the translation. The table is parsed at its first
// use.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "transpiler/dialects/prostep/machine/machine.h"
#include "transpiler/support/embedded_file.h"

namespace plcxx::prostep {

using support::EmbeddedFile;

extern const EmbeddedFile kSignalTable[];
extern const unsigned kSignalTableCount;

/// Who writes a signal.
enum class SignalDirection : uint8_t { kMachineIn, kMachineOut, kNcToPlc, kPlcToNc, kInternal };

struct Signal {
  Space space = Space::kNone;
  uint32_t byte = 0;
  uint8_t bit = 0;    // the lowest; 0 of bytes, words and double words
  uint8_t width = 0;  // in bits: 1 to 4, 8, 16, 32
  SignalDirection direction = SignalDirection::kInternal;
  std::string name;
  std::string meaning;
};

/// By space, byte, bit and width. An address may have several rows: one location, two meanings.
std::span<const Signal> Signals();
/// Of exactly this place.
std::span<const Signal> SignalsAt(Space space, uint32_t byte, uint8_t bit, uint8_t width);

}  // namespace plcxx::prostep
