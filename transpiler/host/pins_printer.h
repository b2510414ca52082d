// How the text of NAME_pins.hpp and NAME_pins.cpp is made; what its two sources share.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "transpiler/host/print_pins.h"

namespace plcxx::host {

inline std::string Number(uint64_t number) { return std::to_string(number); }
/// Of plcxx::host::Value.
std::string_view Member(PinType type);

class PinsPrinter {
 public:
  PinsPrinter(const emit::Emittable& emittable, const Wiring& wiring)
      : emittable_(emittable), program_(*emittable.program), wiring_(wiring), space_(emittable.namespace_name) {}

  std::string Header();
  std::string Source();

 private:
  const std::string& name() const { return emittable_.options.name; }
  uint64_t EventCount() const {
    uint64_t count = 1;  // the period that does not fit
    for (const WiredCall& call : wiring_.calls) count += call.role == CallRole::kEvent ? 1 : 0;
    return count;
  }
  std::string Pin(uint32_t number) const { return "host.pins[Host::At::" + wiring_.pins[number].number + "]"; }
  std::string Of(uint32_t number) const { return Pin(number) + "." + std::string(Member(wiring_.pins[number].type)); }
  std::string Place(ir::PlaceId place) const { return "m[" + emittable_.place_names[place.index] + "]"; }

  void EventTable(std::string& out) const;
  void Inputs(std::string& out) const;
  void Outputs(std::string& out) const;
  void TakeParameters(std::string& out) const;
  void GiveParameters(std::string& out) const;
  /// The value of a pin as its place takes it, and the other way.
  std::string FromPin(ir::PlaceId place, uint32_t pin) const;
  std::string ToPin(const WiredOutput& output) const;
  void Functions(std::string& out) const;
  void Event(const WiredCall& call, uint64_t index, std::string& out) const;
  void Port(const WiredCall& call, std::string& out) const;
  void Messages(std::string& out) const;
  void Step(std::string& out) const;

  const emit::Emittable& emittable_;
  const ir::Program& program_;
  const Wiring& wiring_;
  const std::string& space_;
};

}  // namespace plcxx::host
