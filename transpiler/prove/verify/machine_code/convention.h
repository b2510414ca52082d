// How C++ calls functions on a target.
#pragma once

#include <cstdint>
#include <vector>

namespace plcxx::prove::verify::machine_code {

struct Convention {
  unsigned bits = 32;               // of a register
  unsigned registers = 0;           // of them, by the architecture's numbers
  unsigned flags = 0;               // of width 1
  unsigned stack = 0, link = 0;     // registers: its pointer, the way back
  std::vector<unsigned> arguments;  // in this order; further ones are on the stack
  std::vector<unsigned> results;    // the low half first
  std::vector<unsigned> kept;       // what a callee gives back as it was
  std::vector<unsigned> platform;   // what nobody but the start-up code writes: interrupts and callees use it, too
  std::vector<unsigned> linkers;    // what the linker's own code between a call and its callee may write
  bool pairs_are_even = false;      // a number of two registers begins at an even one
  unsigned stack_align = 16;        // of its pointer, at calls of what is declared
  unsigned least_stack_align = 16;  // everywhere
};

const Convention& RiscvConvention(unsigned bits);
const Convention& ArmConvention();

}  // namespace plcxx::prove::verify::machine_code
