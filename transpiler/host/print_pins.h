// NAME_pins.hpp and NAME_pins.cpp: the table of pins, and the program's host functions on them.
#pragma once

#include <string>

#include "transpiler/emit/emittable.h"
#include "transpiler/host/wiring.h"

namespace plcxx::host {

std::string PrintPinsHeader(const emit::Emittable& emittable, const Wiring& wiring);
std::string PrintPinsSource(const emit::Emittable& emittable, const Wiring& wiring);

/// "lathe_pins", the namespace beside the program's own.
std::string PinsNamespace(const emit::Emittable& emittable);

// The one file of each host.
std::string PrintPosixSource(const emit::Emittable& emittable);
std::string PrintModbusSource(const emit::Emittable& emittable);
std::string PrintHalSource(const emit::Emittable& emittable);
std::string PrintHalFile(const emit::Emittable& emittable, const Wiring& wiring);
std::string PrintHalManual(const emit::Emittable& emittable, const Wiring& wiring);

}  // namespace plcxx::host
