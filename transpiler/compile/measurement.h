// The longest path and the deepest stack of a partition, in compiled code.
//
// In: the objects' functions as blocks, and how often the loops of generated code and runtime go round at most. Out:
// instructions, cycles, stack and code bytes from an entry on, and what is not in them. Host functions and support
// routines of the compiler are never in them. A bound on the machine code: each loop at its most rounds, each branch
// the dearer way, all calls added.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/compile/program_code.h"

namespace plcxx::compile {

/// A loop of the text that was compiled.
struct KnownLoop {
  std::string file;                // "mill.cpp", "plcxx/bcd.h"
  uint32_t first = 0, last = 0;    // its lines, from 1: head and closing brace
  std::optional<uint64_t> rounds;  // the most; none: the loop is known, its bound is not
};

/// A loop whose head is that line of a well indented text.
KnownLoop LoopAt(const std::string& file, std::string_view text, uint32_t line, std::optional<uint64_t> rounds);

/// The loops of the runtime's headers whose heads say "at most N rounds", or "at most one round for each element": of
/// an array of State, of which the longest has `elements`.
void AddRuntimeLoops(std::vector<KnownLoop>& loops, uint64_t elements);

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
  Measurement(const ProgramCode& code, const std::vector<KnownLoop>& loops);

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

  const ProgramCode& code_;
  const std::vector<KnownLoop>& loops_;
  std::vector<Own> own_;  // by function
};

}  // namespace plcxx::compile
