// Lanes of a fleet beside simulators: each compared lane is a machine with inputs and answers of its own.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "transpiler/fleet/library.h"

namespace plcxx::fleet {

/// What the control does: kWild writes fields of timers and counters, too, and its time leaps and wraps.
enum class Hosts : uint8_t { kTame, kWild };

/// What a lane did otherwise than a simulator with the same inputs; empty: nothing, in `periods` periods.
std::string CompareLanes(std::shared_ptr<const Library> library, uint64_t seed, uint32_t periods,
                         Hosts hosts = Hosts::kTame);

}  // namespace plcxx::fleet
