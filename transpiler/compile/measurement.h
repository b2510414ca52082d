// The longest path and the deepest stack of a partition, in compiled code.
//
// In: the objects' functions as blocks, and how often the loops of generated code and runtime go round at most. Out:
// instructions, cycles, stack and code bytes from an entry on, and what is not in them. Host functions and support
// routines of the compiler are never in them. A bound on the machine code: each loop at its most rounds, each branch
// the dearer way, all calls added.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/compile/program_code.h"

namespace plcxx::compile {

/// Rounds of the loops whose heads stand in a file at a line; none: the loop is known, its bound is not.
using LoopRounds = std::map<std::pair<std::string, uint32_t>, std::optional<uint64_t>>;

/// The loops of the runtime's headers whose comments say "at most N rounds".
void AddRuntimeLoops(LoopRounds& loops);

struct Path {
  uint64_t instructions = 0;  // saturates
  uint64_t cycles = 0;        // saturates
};

struct Figures {
  Path longest;
  uint64_t stack_bytes = 0;
  uint64_t code_bytes = 0;          // of all functions that can be reached
  std::set<std::string> host;       // functions called that no object has, as the source calls them
  std::set<std::string> not_whole;  // in words: what is missing from the figures
};

class Measurement {
 public:
  Measurement(const ProgramCode& code, const LoopRounds& loops);

  /// From a function on, with all that it calls. Calls in circles count once: the audit refuses them.
  Figures From(uint32_t function);

 private:
  struct Own {
    Path longest;
    std::optional<uint64_t> stack_bytes;
    std::set<std::string> not_whole;  // callees excluded
    bool done = false;
    bool open = false;
  };
  const Own& Measure(uint32_t function);
  uint64_t StackOf(uint32_t function);
  std::optional<uint64_t> RoundsOf(uint32_t function, uint32_t header, const std::set<uint32_t>& blocks) const;
  std::optional<std::optional<uint64_t>> Known(uint32_t function, const CodeLine& line) const;

  const ProgramCode& code_;
  const LoopRounds& loops_;
  std::vector<Own> own_;  // by function
};

}  // namespace plcxx::compile
