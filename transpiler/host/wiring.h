// Which pins a program has: the decisions of a host's files, before anything is spelled.
//
// A terminal is a place in a zone of inputs or outputs, or a byte of a port that the program reads or writes by a host
// function. What is kept at power-off and never stored by the program (times, numbers of tools) is a parameter: a pin
// that shows it, and that changes it when somebody writes another value. Signals that have a name of their own, and
// events with their parameters, are pins to look at. Every name is made from the generated code's by one rule: small
// letters, '-' for '_'.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/emit/emittable.h"

namespace plcxx::host {

enum class PinType : uint8_t { kBit, kS32, kU32, kFloat };
enum class PinDirection : uint8_t { kIn, kOut, kBoth };
enum class PinRole : uint8_t { kTerminal, kSignal, kEvent, kParameter };

struct WiredPin {
  std::string name;    // "pump-on"
  std::string number;  // its enumerator in generated code, "PUMP_ON"
  PinType type = PinType::kBit;
  PinDirection direction = PinDirection::kIn;
  PinRole role = PinRole::kTerminal;
  std::string address;  // as the source writes it
  std::string comment;
  source::Range range;  // of a statement that uses it
};

/// Bits of a place that come from a pin: a bit, or `bits` bits of a number.
struct InputPart {
  uint32_t pin = 0;
  uint32_t shift = 0, bits = 0;
};
/// A place that gets its value from pins; one part as wide as the place: from one pin.
struct WiredInput {
  ir::PlaceId place;
  std::vector<InputPart> parts;
};
struct WiredOutput {
  ir::PlaceId place;
  uint32_t pin = 0;
};

enum class CallRole : uint8_t {
  kClock,       // gives the time
  kTakeInputs,  // all input pins into State
  kGiveOutputs,
  kLoad,   // the stored retentive memory
  kStore,  // hands the retentive memory over
  kPort,   // a byte for each value of the first parameter: eight bit pins each
  kEvent   // its parameters on pins; its result from one
};
struct WiredPort {
  uint64_t number = 0;
  uint32_t first_pin = 0;
};
struct WiredCall {
  ir::HostFunctionId function;
  CallRole role = CallRole::kEvent;
  uint32_t first_pin = 0;  // of kEvent: calls, the parameters, result, second result
  std::vector<WiredPort> ports;
};

struct WiredMessage {
  uint32_t number = 0;
  std::string text;
  ir::PlaceId bit;  // 1 while it is shown; may be none
};

struct Wiring {
  std::vector<WiredPin> pins;
  std::vector<WiredInput> inputs;
  std::vector<WiredOutput> outputs;
  std::vector<WiredOutput> parameters;
  std::vector<WiredCall> calls;
  std::vector<WiredMessage> messages;
  std::vector<ir::PlaceId> message_words;  // their value is the number of a message that is shown
  uint32_t message_pin = 0;                // where there are messages
  uint32_t base_ms = 1;                    // a period of the host
  bool stores_by_itself = false;           // the retentive memory is handed over after each period
};

/// What cannot be is reported; the wiring is then of no use.
Wiring Wire(const emit::Emittable& emittable, diag::Engine& diagnostics);

/// The longest name of a pin or function that LinuxCNC's HAL takes, instance included.
inline constexpr uint32_t kMaxPinName = 47;
/// "PUMP_ON" -> "pump-on"
std::string PinName(std::string_view name);
/// Gives each pin a name that fits and is its own; those that find none are reported.
void NamePins(const std::string& program, std::vector<WiredPin>& pins, diag::Engine& diagnostics);

}  // namespace plcxx::host
