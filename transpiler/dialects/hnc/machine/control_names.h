// The names that the control gives: register areas and functions.
#pragma once

#include <cstdint>

namespace plcxx::hnc {

/// The register areas in the order of 5.1.
enum class Area : uint8_t { kX, kY, kR, kF, kG, kP, kB };

/// Functions that the product supplies (6.10, 6.11). A program's own definition is an ordinary function.
enum class SystemFunction : uint8_t {
#define HNC_FUNCTION(Name, ...) k##Name,
#include "transpiler/dialects/hnc/machine/functions.def"
};

}  // namespace plcxx::hnc
