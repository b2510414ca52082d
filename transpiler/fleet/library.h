// The code of a fleet, compiled by the installed C++ compiler for this processor and loaded into this process.
//
// In: a program. Out: a function that executes a piece of it for 64, 256 or 512 machines, or why there is none. What
// was compiled once with the same compiler is taken from the cache. Not its job: the machines' State (fleet.h).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "transpiler/compile/child_process.h"
#include "transpiler/fleet/layout.h"
#include "transpiler/fleet/write_code.h"
#include "transpiler/ir/program.h"
#include "transpiler/support/module.h"

namespace plcxx::fleet {

/// How many machines an instruction of this processor serves: 512 with AVX-512, 256 with AVX2, else 64.
unsigned WidestFleet();
/// Why this processor has no fleet of so many machines; empty: it has one.
std::string TooWide(unsigned lanes);

struct LibraryRequest {
  std::string compiler;     // a command
  std::string level = "2";  // as behind -O
  unsigned lanes = 0;       // 64, 256 or 512; 0: WidestFleet()
  bool forces = false;      // bits can be forced; stores cost more then
  std::string cache;        // a directory; empty: none
  int seconds = 0;          // that the compiler may take; 0: as long as the largest programs need
};

/// What generated code calls; see runtime/machine.h.
struct HostTable {
  void* context = nullptr;
  void (*call)(void* context, uint32_t function, const uint64_t* mask, const uint64_t* arguments, uint64_t* results,
               uint64_t* seconds, uint64_t* has_second) = nullptr;
  uint32_t now = 0;
};

/// The times of a timer that all lanes step together; see runtime/clocks.h and runtime/unit_timers.h.
struct Clock {
  uint32_t last = 0, oldest = 0, waiting = 0, runs = 0;
  uint32_t next = 0, preset = 0, unit_ms = 0, counts_by_input = 0;
};

struct Library {
  const ir::Program* program = nullptr;
  Layout layout;
  Share share;
  unsigned lanes = 0;
  bool forces = false;
  uint64_t state_bytes = 0;
  void (*run)(void* state, const void* host, uint32_t piece) = nullptr;
  std::unique_ptr<support::LoadedLibrary> loaded;
};

using LibraryOrFailure = std::variant<std::shared_ptr<const Library>, std::string>;

/// `program` must be structured and outlive the result. What this processor cannot execute is not compiled.
LibraryOrFailure CompileFleet(const ir::Program& program, const LibraryRequest& request);

}  // namespace plcxx::fleet
