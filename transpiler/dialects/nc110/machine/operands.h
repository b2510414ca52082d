// What a program of the control can name: signals and words of its packages, timers, counters, one-shots
// (specification 2.5, 4).
//
// Not its job: how they are spelled in a source (tokens.h), where they lie (machine.h).
#pragma once

#include <cstdint>
#include <string>

namespace plcxx::nc110 {

enum class Type : uint8_t { kSignal, kWord, kUnknown };

enum class Package : uint8_t { kA, kK, kN, kT };

enum class OperandKind : uint8_t {
  kNone,          // unreadable, already reported
  kInput,         // I: connector `number`, package, bit `index`
  kOutput,        // U: as kInput; the same bit
  kWord,          // W: connector `number`, package, byte `index`
  kTimerInput,    // TnI
  kTimerHold,     // TnA
  kTimerElapsed,  // TnU
  kTimerRunning,  // TnD
  kCounterInput,  // CnI
  kCounterCarry,  // CnR
  kCounterReset,  // CnZ
  kCounterDown,   // CnA: direction
  kCounterValue,  // CnW: a word
  kOneShot,       // Pn
};

struct Operand {
  OperandKind kind = OperandKind::kNone;
  Package package = Package::kA;  // kInput, kOutput, kWord only
  uint16_t number = 0;            // connector, timer, counter or one-shot
  uint8_t index = 0;              // bit 0..31 or byte 0..3
  bool operator==(const Operand&) const = default;
};

Type TypeOf(OperandKind kind);
/// The canonical spelling without leading zeros: "I0A20", "W3K0", "T5U", "P6"; "?" for kNone.
std::string ToText(const Operand& operand);
char PackageLetter(Package package);

/// The bit that an operand names, read (I) or written (U): both are one location.
inline Operand AsBit(Operand operand) {
  if (operand.kind == OperandKind::kInput) operand.kind = OperandKind::kOutput;
  return operand;
}

}  // namespace plcxx::nc110
