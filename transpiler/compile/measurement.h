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
#include <string_view>
#include <vector>

#include "transpiler/compile/program_code.h"

namespace plcxx::compile {

/// A loop of the text that was compiled.
struct KnownLoop {
  std::string file;                // "mill.cpp", "plcxx/bcd.h"
  uint32_t first = 0, last = 0;    // its lines, from 1: head and closing brace
  std::optional<uint64_t> rounds;  // the most; none: the loop is known, its bound is not
  std::optional<uint32_t> budget;  // shares its rounds with all loops of this number
};

/// A loop whose head is that line of a well indented text.
KnownLoop LoopAt(const std::string& file, std::string_view text, uint32_t line, std::optional<uint64_t> rounds);

/// The loops of the runtime's headers whose heads say "at most N rounds", or "at most one round for each element": of
/// an array of State, of which the longest has `elements`.
void AddRuntimeLoops(std::vector<KnownLoop>& loops, uint64_t elements);

/// What bounds loops beside the text's own bounds.
struct LoopBounds {
  std::vector<KnownLoop> loops;
  /// Bytes of the largest object. A block that goes back to itself, calls nothing and is no loop of the text is one
  /// that the compiler made to clear or to copy an object, a byte or more a round. 0: not told.
  uint64_t largest_object = 0;
};

struct Path {
  uint64_t instructions = 0;  // saturates
  uint64_t cycles = 0;        // saturates
};

struct StackFrame {
  std::string function;  // as the source calls it
  uint64_t bytes = 0;    // its own, return address included
};

struct Figures {
  Path longest;
  uint64_t stack_bytes = 0;
  std::vector<StackFrame> deepest;  // the calls that take them, from the partition on
  uint64_t code_bytes = 0;          // of all functions that can be reached
  uint64_t constant_bytes = 0;      // that these functions refer to
  uint64_t shared_rounds = 0;       // of the budgets that its loops take from
  std::set<std::string> host;       // functions called that no object has, as the source calls them
  std::set<std::string> not_whole;  // in words: what is missing from the figures
};

class Measurement {
 public:
  /// `impossible`, by function: none of the paths that are measured calls it. Empty: all may be called.
  Measurement(const ProgramCode& code, const LoopBounds& bounds, std::vector<bool> impossible = {});

  /// From a function on, with all that it calls. Calls in circles count once: the audit refuses them. `budgets`: how
  /// many rounds the loops of a budget make together, all of them as dear as the dearest one.
  Figures From(uint32_t function, const std::map<uint32_t, uint64_t>& budgets = {});

 private:
  struct Own {
    Path longest;
    std::optional<uint64_t> stack_bytes;
    uint32_t deepest_callee = kNoFunction;
    std::set<std::string> not_whole;                                // callees excluded
    std::map<uint32_t, uint64_t> round_instructions, round_cycles;  // by budget: the dearest round
    std::map<uint32_t, std::string> budget_loops;                   // one for each budget, in words
    bool done = false;
    bool open = false;
  };
  const Own& Measure(uint32_t function);
  uint64_t StackOf(uint32_t function);
  bool IsPossible(uint32_t caller, const CodeBlock& block) const;

  const ProgramCode& code_;
  const LoopBounds& bounds_;
  std::vector<bool> impossible_;  // by function
  std::vector<Own> own_;          // likewise
};

}  // namespace plcxx::compile
