// Writes a program as C++ that executes it for many machines at once: a bit of a machine is a lane of a plane.
//
// In: a structured, optimized program and its layout. Out: one file that includes those of runtime/ and of
// runtime_support, and how much of it has no form in planes. Guards are masks: a region is executed by the lanes that
// reach it, and left out when there is none. Not its job: compiling it (library.h).
#pragma once

#include <cstdint>
#include <string>

#include "transpiler/fleet/layout.h"
#include "transpiler/ir/program.h"

namespace plcxx::fleet {

/// What a fleet is asked to do; the order is that of the generated function.
enum class Piece : uint32_t { kInit, kPeriod, kFastOnly, kElapse };

/// Operations of the program, each once.
struct Share {
  uint32_t sliced = 0;    // one instruction for all lanes
  uint32_t per_lane = 0;  // a loop over the lanes
};

struct Code {
  std::string text;
  Share share;
};

Code WriteCode(const ir::Program& program, const Layout& layout, const SameEverywhere& same);

}  // namespace plcxx::fleet
