// Loops of both sides that are not unrolled, in step: what the code's loop has at its head as terms over what the
// program's loop has there, and what remains to be shown of it.
//
// The n-th loop of the code belongs to the n-th one of the program. At a head the cells that the program's loop writes
// are variables, the same for both sides; of the code's values, terms over them that the first rounds suggest
// (loop_guess.h). Claims: at the entry both are related so; from a related head, one round on both sides goes on under
// the same conditions to related heads. Then they are related at the last head, too, which is where execution goes on:
// that it is the last one is given for all that follows, and for nothing that is claimed of the loop itself. A guess
// that is not so is dropped, and everything done again with the next one.
// In: both executions, the program's first. Out: terms for heads, claims, and what is given. Not its job: proving.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/prove/compiled/compiled_code.h"
#include "transpiler/prove/compiled/loop_guess.h"
#include "transpiler/prove/compiled/state_image.h"
#include "transpiler/prove/execute/loop_heads.h"
#include "transpiler/prove/solver/sweep.h"

namespace plcxx::prove {

/// How many guesses have been dropped, by what is guessed.
using DroppedGuesses = std::map<std::string, uint32_t>;

struct LoopClaim {
  std::string what;   // "loop 1, for.body: DB24"
  std::string guess;  // of which it is; empty: of none, it must hold
  TermId given;       // width 1: it is claimed where this holds
  TermPair pair;
};

class LoopRelation : public LoopHeads {
 public:
  /// `initial`: of a cell that nothing has written.
  LoopRelation(Terms& terms, const emit::Emittable& emittable, const Cells& cells, const StateImage& image,
               std::function<TermId(CellId)> initial, const DroppedGuesses& dropped);

  // Of the program.
  void Open() override;
  ProgramLoop::Head AtHead(const ProgramLoop& loop) override;
  void Holds(TermId condition) override;
  void Close(TermId again, std::span<const TermId> values) override;

  // Of the code.
  void OpenInCode();
  /// Empty: the program has no such loop.
  std::vector<TermId> AtHeadInCode(const CodeLoop& loop);
  void CloseInCode(TermId again, std::span<const TermId> values);

  /// What holds behind the loops that the code has left so far.
  TermId given_in_code() const { return given_in_code_; }
  /// Behind all of them.
  TermId Given() { return terms_.And(given_, given_in_code_); }
  const std::vector<LoopClaim>& claims() const { return claims_; }
  /// Whether a loop of the code was not unrolled.
  bool has_code() const { return next_in_code_ != 0; }

 private:
  /// Cells that are one number together, the least significant bit first.
  struct Word {
    std::string name;
    uint8_t width = 1;
    std::vector<size_t> cells;  // indices of ProgramLoop::cells
  };
  /// What is said of a word: what it is for the number of rounds, or which of its bits are fixed.
  struct WordGuess {
    enum class Of : uint8_t { kNothing, kRounds, kItself };
    Of of = Of::kNothing;
    Guess guess;
    std::string key;
  };
  struct OfProgram {
    ProgramLoop known;
    std::vector<Word> words;
    std::vector<std::pair<uint32_t, uint8_t>> places;  // by index of a cell: its word, and bit of it
    std::vector<WordGuess> guesses;                    // by word
    ProgramLoop::Head head, next;
    TermId given_before, given_inside, again, holds;
    size_t claims = 0;  // before it
  };
  struct OfCode {
    size_t number = 0;
    std::string name;
    std::vector<std::string> items, keys;
    std::vector<Guess> guesses;  // by item; none: it is any value
    TermId when, given_before;
    size_t claims = 0;
  };

  TermId Implies(TermId a, TermId b) { return terms_.Or(terms_.Not(a), b); }
  void MakeWords(OfProgram& loop);
  void AddWord(OfProgram& loop, std::string name, std::vector<size_t> cells);
  /// The words, and the number of rounds where it is counted.
  std::vector<TermId> WordsAt(const OfProgram& loop, const ProgramLoop::Head& head);
  void GuessWords(OfProgram& loop, const std::string& prefix);
  static Guess FixedBits(const SampledValue& sampled);
  TermId Apply(const WordGuess& guess, TermId word, TermId round);
  void ClaimWords(const OfProgram& loop, const std::string& where, TermId given, const ProgramLoop::Head& head);
  /// A byte of State, or what a host function was told, as the program's cells say; none: the loop does not write them.
  Guess OwnCells(const OfProgram& loop, uint32_t slot);
  std::vector<Guess> Choose(const OfProgram& loop, const CodeLoop& code, std::vector<std::string>& keys);
  uint32_t Dropped(const std::string& key) const;
  std::string NameOf(const CodeLoop::Item& item) const;
  void Claim(std::string what, std::string guess, TermId given, TermId a, TermId b);

  Terms& terms_;
  const emit::Emittable& emittable_;
  const ir::Program& program_;
  const Cells& cells_;
  const StateImage& image_;
  std::function<TermId(CellId)> initial_;
  const DroppedGuesses& dropped_;
  std::vector<std::unique_ptr<OfProgram>> loops_;
  std::vector<size_t> open_;  // of the program's
  TermId given_;
  std::vector<OfCode> open_in_code_;
  size_t next_in_code_ = 0;
  TermId given_in_code_;
  std::vector<LoopClaim> claims_;
};

}  // namespace plcxx::prove
