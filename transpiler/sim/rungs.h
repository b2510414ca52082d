// Rungs: stretches of logic of bits that are executed as one decoded instruction.
//
// In a program of thousands of statements a processor foresees hardly any of the jumps to the next instruction's
// function, and these cost more than what the functions do. So the contacts of a rung and what joins them are steps of
// one form, without a jump: a value of two bits, each of which stands in some byte. Each step still leaves its value
// where the instruction would, for whoever looks. Not its job: what a statement's number is for, and how its coil is
// written (instructions.h).
#pragma once

#include <cstddef>
#include <cstdint>

namespace plcxx::sim {

/// In which memory a bit is: values of instructions, fields of instances, or, from kSpaces on, a space.
enum class BitBase : uint16_t { kValues, kInstances, kSpaces };
/// The last space whose bits a step can name.
inline constexpr uint32_t kLastSpaceOfRungs = 0xFFFF - static_cast<uint32_t>(BitBase::kSpaces);

/// Where a bit stands.
struct BitSource {
  uint32_t byte = 0;
  BitBase base = BitBase::kValues;
  uint8_t bit = 0;
};

/// One instruction of a rung.
struct LogicStep {
  BitSource a, b;
  uint32_t id = 0;    // its InstId, which is where its result goes
  uint8_t truth = 0;  // bit a + 2 * b: the result
};
static_assert(sizeof(LogicStep) <= 24);

/// The table of a function of one or two bits.
template <class F>
constexpr uint8_t TruthOf(F function) {
  int truth = 0;
  for (int i = 0; i < 4; ++i) truth |= (function((i & 1) != 0, (i & 2) != 0) ? 1 : 0) << i;
  return static_cast<uint8_t>(truth);
}

}  // namespace plcxx::sim
