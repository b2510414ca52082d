// Guesses of what a value that compiled code keeps in a loop is in the program: from the values that both have in the
// first rounds, on samples.
//
// In: the values of one item of the code and of the words that the program's loop writes, at the same heads. Out: terms
// over the words that agree with the item on all samples, the most likely one first. Not its job: to prove them.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::verify {

/// A term for given values of the words.
using Guess = std::function<terms::TermId(terms::Terms& terms, std::span<const terms::TermId> words)>;

struct SampledValue {
  uint8_t width = 1;
  std::vector<uint64_t> values;  // by sample
};

struct SampledLoop {
  std::vector<SampledValue> words;
  std::shared_ptr<const std::vector<terms::TermId>> words_at_entry;
  std::vector<uint32_t> entries;  // by sample: the one of the entry before it; of an entry itself
  size_t later = 0;               // the word, of width 1, that says that some round was before
};

struct RatedGuess {
  Guess guess;
  bool is_fixed = false;  // over no word: nothing was seen to move it
};

std::vector<RatedGuess> GuessesFor(const SampledValue& item, terms::TermId at_entry, const SampledLoop& loop);

}  // namespace plcxx::prove::verify
