// Inputs for many runs beside each other: each lane changes its inputs in its own way, some often, some hardly ever.
//
// In: inputs, and the programs that read them, as terms. Out: period by period which inputs are set in which lanes.
// Bits get every density of ones; words get what a program compares them with, and its neighbours. Not its job: what
// follows from them.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "transpiler/prove/machine/relation.h"
#include "transpiler/symbolic/terms/lanes.h"
#include "transpiler/symbolic/terms/random.h"

namespace plcxx::prove::wide {

/// An input is set to `value` in the lanes of `where`.
struct WideSet {
  uint32_t input = 0;
  terms::Plane where, value;
};

/// A program that reads the inputs.
struct Reader {
  const machine::Relation& relation;
  std::map<uint32_t, uint32_t> numbers;  // by cell of its version: the input's number
};
/// By cell: whether something is computed from it in a part.
std::vector<bool> ReadCells(const terms::Terms& terms, const machine::Relation& relation);

class WideInputs {
 public:
  struct Input {
    execute::CellId cell;      // of one version, of all inputs: those beside each other may be bits of a word
    bool is_machines = false;  // an input of the machine; else memory that nobody writes
  };

  WideInputs(const terms::Terms& terms, std::vector<Input> inputs, std::span<const Reader> readers);

  const std::vector<Input>& inputs() const { return inputs_; }
  /// New habits for all lanes; those of one word of a plane (terms::Plane) share one.
  void Begin();
  void ChangeHabits(uint32_t word);
  /// What is set before the next period. Of `first` all inputs get a value.
  std::vector<WideSet> Next(bool is_first);

 private:
  static constexpr uint32_t kNone = 0xFFFFFFFF;
  struct Habit {
    uint32_t eighths = 4;  // of the inputs are 1
    uint32_t change = 3;   // one in 2^change of them gets a new value
    uint32_t every = 1;    // periods
    bool memory = false;   // memory that nobody writes, too
  };
  /// A word of inputs, or a part of one, the lowest bit first; none: a bit that is no input.
  using Word = std::vector<uint32_t>;

  /// `cone`: all that it computes.
  void AddWords(const terms::Terms& terms, const Reader& reader, std::span<const terms::TermId> cone);
  void AddConjunctions(const terms::Terms& terms, const Reader& reader, std::span<const terms::TermId> cone);
  void AddConstant(Word word, uint64_t constant);
  uint64_t Sparse(uint32_t one_in_power);
  uint64_t Ones(uint32_t eighths);

  std::vector<Input> inputs_;
  std::map<Word, std::vector<uint64_t>> words_;  // with what they are compared
  std::array<Habit, terms::Plane::kWords> habits_;
  terms::Random random_{0xC2B2AE3D27D4EB4F};
  uint32_t period_ = 0;
};

}  // namespace plcxx::prove::wide
