// Edges of a signal, with one memory for each instruction that asks.
//
// Implements HOST50 7.1. All zero is the state after power-on; PresetEdge gives it another one.
#pragma once

namespace plcxx {

struct EdgeMemory {
  bool was;  // the signal at the last execution of the instruction
};

/// Whether the signal is 1 now and was 0 at the last call.
constexpr bool Rising(EdgeMemory& edge, bool signal) noexcept {
  const bool rises = signal && !edge.was;
  edge.was = signal;
  return rises;
}

/// Whether the signal is 0 now and was 1 at the last call.
constexpr bool Falling(EdgeMemory& edge, bool signal) noexcept {
  const bool falls = !signal && edge.was;
  edge.was = signal;
  return falls;
}

/// At power-on: a signal that is 1 already gives no rising edge.
constexpr void PresetEdge(EdgeMemory& edge, bool signal) noexcept { edge.was = signal; }

}  // namespace plcxx
