// A waveform as loggers, logic analysers and this tool write it: which signal changed to what, and when.
//
// In: the text of a VCD file (value change dump, IEEE 1364, chapter 18). Out: its signals and changes in milliseconds,
// or the first thing that is wrong with it. Not its job: which location of a program a signal is
// (scenarios/traced_run.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace plcxx::sim {

struct VcdSignal {
  std::string name;  // without the range of a vector
  uint32_t width = 1;
  bool is_real = false;
};

struct VcdChange {
  uint64_t time_ms = 0;
  uint32_t signal = 0;   // of Vcd::signals
  uint64_t value = 0;    // the bits; of a real those of the double
  bool is_known = true;  // no bit of it is x or z
};

struct Vcd {
  std::vector<VcdSignal> signals;
  std::vector<VcdChange> changes;      // times ascend
  uint64_t first_ms = 0, last_ms = 0;  // of the times that are written, with changes or without
};

struct VcdError {
  uint32_t line = 0;  // 1-based
  std::string message;
};

/// A signal wider than 64 bits is there without changes. A time between two milliseconds counts as the earlier one.
std::variant<Vcd, VcdError> ReadVcd(std::string_view text);

}  // namespace plcxx::sim
