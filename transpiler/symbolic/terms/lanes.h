// Values of terms for many assignments of their variables at once, faster by an order than one after the other.
//
// A lane is one assignment. A term of n bits is n planes, the least significant first: plane i is bit i in each lane.
// What has one bit costs a few instructions of the processor for all lanes; arithmetic goes bit by bit, as in hardware.
//
//   terms     (x & y) == z          lane   0 1 2 ...
//   planes    one bit each          x      1 0 1 ...     variables, set by the caller
//                                   x & y  1 0 0 ...     scratch, used again when it is not needed any more
//
// In: terms, where each variable is. Out: planes of the roots. Not its job: which values the variables get.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::terms {

/// One bit in each lane; lane i is bit i % 64 of word i / 64.
struct alignas(64) Plane {
  static constexpr uint32_t kWords = 8, kLanes = 64 * kWords;
  std::array<uint64_t, kWords> words{};

  bool Get(uint32_t lane) const { return (words[lane / 64] >> lane % 64 & 1) != 0; }
  void Set(uint32_t lane, bool value) {
    const uint64_t bit = uint64_t{1} << lane % 64;
    words[lane / 64] = value ? words[lane / 64] | bit : words[lane / 64] & ~bit;
  }
  void Fill(bool value) { words.fill(value ? ~uint64_t{0} : 0); }
  bool IsZero() const {
    uint64_t any = 0;
    for (const uint64_t word : words) any |= word;
    return any == 0;
  }
};

/// Word for word, by a function of the word's number.
template <class Of>
Plane MakePlane(Of&& of) {
  Plane plane;
  for (uint32_t w = 0; w < Plane::kWords; ++w) plane.words[w] = of(w);
  return plane;
}
inline Plane operator~(const Plane& a) {
  return MakePlane([&](uint32_t w) { return ~a.words[w]; });
}
inline Plane operator&(const Plane& a, const Plane& b) {
  return MakePlane([&](uint32_t w) { return a.words[w] & b.words[w]; });
}
inline Plane operator|(const Plane& a, const Plane& b) {
  return MakePlane([&](uint32_t w) { return a.words[w] | b.words[w]; });
}
inline Plane operator^(const Plane& a, const Plane& b) {
  return MakePlane([&](uint32_t w) { return a.words[w] ^ b.words[w]; });
}
inline Plane Choice(const Plane& condition, const Plane& then, const Plane& otherwise) {
  return MakePlane(
      [&](uint32_t w) { return (condition.words[w] & then.words[w]) | (~condition.words[w] & otherwise.words[w]); });
}

/// The number that a term's planes have in a lane.
uint64_t ValueInLane(std::span<const Plane> planes, uint32_t lane);
void SetInLane(std::span<Plane> planes, uint32_t lane, uint64_t value);

class LaneProgram {
 public:
  /// Where the planes of a variable begin in what Run is given.
  struct VariableAt {
    TermId variable;
    uint32_t plane = 0;
  };
  /// `variables`: at least those that the roots are made of. `terms` outlives the program.
  LaneProgram(const Terms& terms, std::span<const VariableAt> variables, std::span<const TermId> roots);

  /// A function without a value (see TermFunction) gives MadeUpValue, as in Evaluate. Reads the variables' planes
  /// alone.
  void Run(std::span<const Plane> variables);
  /// After Run: of a root, as many as it is wide. Where a root is a variable, or a part of one, these are the planes
  /// that Run was given.
  std::span<const Plane> Root(size_t root) const;

  size_t steps() const { return steps_.size(); }

 private:
  struct Step {
    TermKind kind{};
    uint8_t width = 1;  // of the operands where they have one width, else of the result
    uint32_t to = 0;
    std::array<uint32_t, 3> from{};
  };
  struct Application {
    FunctionId function;
    std::vector<uint32_t> from;
    std::vector<uint8_t> widths;
  };
  class Compiler;

  const Plane* At(uint32_t at) const { return bases_[at >> 31] + (at & 0x7FFFFFFF); }
  Plane* To(const Step& step) { return scratch_.data() + (step.to & 0x7FFFFFFF); }
  void Execute(const Step& step);
  void Apply(const Step& step);

  const Terms& terms_;
  std::vector<Step> steps_;
  std::vector<Application> applications_;
  std::vector<Plane> scratch_;  // constants first
  std::vector<uint32_t> roots_;
  std::vector<uint8_t> root_widths_;
  std::array<const Plane*, 2> bases_{};  // variables, scratch
};

}  // namespace plcxx::terms
