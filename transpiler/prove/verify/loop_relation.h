// Loops of both sides that are not unrolled, in step: what the code's loop has at its head as terms over what the
// program's loop has there, and what remains to be shown of it.
//
// The n-th loop of the code belongs to the n-th one of the program, if both stand in loops that belong together, or in
// none: what is claimed inside of a loop holds in any of its rounds, and behind it in the last one only. At a head the
// cells that the program's loop writes are variables, the same for both sides; of the code's values, terms over them
// that the first rounds suggest (loop_guess.h). Claims: at the entry both are related so; from a related head, one
// round on both sides goes on under the same conditions to related heads. Then they are related at the last head, too,
// which is where execution goes on: that it is the last one is given for all that follows, and for nothing that is
// claimed of the loop itself. So are facts that are no equalities (loop_facts.h): each is claimed at the entry and,
// from a head where all of them hold, at the next. A candidate that does not hold is dropped, and everything is done
// again with the next one. (The literature: a coupling invariant, its candidates dropped as Houdini does.)
//
//   the program                             what the compiler made of it
//     i = 0; sum = 0;                         p = &table[0]; s = 0; left = 8;
//     while (i < 8) {                         do {
//       sum = sum + table[i];                   s += *p++;
//       i = i + 1;                            } while (--left != 0);
//     }                                       sum = s;
//
//   at the headers, after 0, 1, 2 iterations    i = 0, 1, 2     p = table, table + 1, table + 2     left = 8, 7, 6
//   candidates over the program's words         p = table + i,  s = sum,  left = 8 - i
//   claims   entry       table + 0 = table, 0 = 0, 8 - 0 = 8
//            iteration   from p = table + i, s = sum, left = 8 - i: the next p is table + (i + 1), s + *p is
//                        sum + table[i], left - 1 is 8 - (i + 1); i + 1 < 8 exactly where --left != 0
//   fact     i <= 8      no equality of words, but needed: without it 8 - i could wrap
//   given    at the last header s = sum, so the store `sum = s` is the program's
//
// In: both executions, the program's first. Out: terms for headers, claims, and what is given. Not its job: proving.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/prove/verify/compiled_code.h"
#include "transpiler/prove/verify/loop_facts.h"
#include "transpiler/prove/verify/loop_guess.h"
#include "transpiler/prove/verify/state_image.h"
#include "transpiler/prove/verify/substitute.h"
#include "transpiler/symbolic/execute/loop_heads.h"
#include "transpiler/symbolic/solver/sweep.h"

namespace plcxx::prove::verify {

/// How many guesses have been dropped, by what is guessed.
using DroppedGuesses = std::map<std::string, uint32_t>;
constexpr std::string_view kGuessOfCode = "code of ";  // with which those begin that are of no word of the program

/// Which of the guesses that are not so are dropped first: a wrong one makes others fail that are right.
enum class Blame : uint8_t {
  kAtEntry,      // no other guess is behind it
  kWord,         // of the program
  kFactOrFixed,  // facts; that what the compiled loop keeps does not change
  kValue,        // what the compiled loop keeps
  kMemory        // that memory is as the program says
};

struct LoopClaim {
  ir::InstId loop;      // the program's, of which it is
  std::string what;     // "loop 1, for.body: DB24"
  std::string guess;    // of which it is; empty: of none, it must hold
  Blame blame{};        // of the guess
  terms::TermId given;  // width 1: it is claimed where this holds
  solver::TermPair pair;
};

class LoopRelation : public execute::LoopHeads {
 public:
  /// `initial`: of a cell that nothing has written.
  LoopRelation(terms::Terms& terms, const emit::Emittable& emittable, const execute::Cells& cells,
               const StateImage& image, std::function<terms::TermId(execute::CellId)> initial,
               const DroppedGuesses& dropped);

  // Of the program.
  void Open() override;
  execute::ProgramLoop::Head AtHead(const execute::ProgramLoop& loop) override;
  void Holds(terms::TermId condition) override;
  void Close(terms::TermId again, std::span<const terms::TermId> values) override;
  /// Where it does not hold, nothing is claimed.
  void Assume(terms::TermId condition);

  // Of the code.
  void OpenInCode();
  /// Empty: the program has no such loop there.
  std::vector<terms::TermId> AtHeadInCode(const CodeLoop& loop);
  void CloseInCode(terms::TermId again, std::span<const terms::TermId> values);

  /// What holds after the loops that the code has left so far.
  terms::TermId given_in_code() const { return given_in_code_; }
  /// What holds in the program where it is now, inside of open loops and after others. Later() then tells the same
  /// with the facts of these loops, which are known when they are closed.
  size_t NoteGiven() {
    noted_.push_back(given_);
    return noted_.size() - 1;
  }
  terms::TermId Later(size_t noted) const { return noted_[noted]; }
  bool is_in_loop() const { return !open_.empty(); }
  /// After all of them.
  terms::TermId Given() { return terms_.And(given_, given_in_code_); }
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
  /// What is said of a word: what it is for the number of rounds and for words before it, or which of its bits are
  /// fixed.
  struct WordGuess {
    enum class Of : uint8_t { kNothing, kOthers, kItself };
    Of of = Of::kNothing;
    Guess guess;
    std::string key;
  };
  struct OfProgram {
    execute::ProgramLoop known;
    std::optional<size_t> outer;  // the loop in which it stands
    std::vector<Word> words;
    std::vector<std::pair<uint32_t, uint8_t>> places;  // by index of a cell: its word, and bit of it
    std::vector<WordGuess> guesses;                    // by word
    std::vector<size_t> others;                        // words that guesses of later ones are over
    std::vector<terms::TermId> any;                    // by word: its variable at the head; none: it is a guess
    execute::ProgramLoop::Head head, next;
    terms::TermId later;      // at its head: some round was before
    terms::TermId facts;      // a variable until it is closed: what is no equality and holds at its head
    uint32_t first_term = 0;  // that is made after its head
    terms::TermId given_before, given_inside, again, holds;
    size_t claims = 0;  // before it
  };
  struct OfCode {
    size_t number = 0;
    std::string name;
    std::vector<std::string> items, keys;
    std::vector<Guess> guesses;  // by item; none: it is any value
    std::vector<Blame> blames;   // by item
    terms::TermId when, given_before;
    size_t claims = 0;
  };

  terms::TermId Implies(terms::TermId a, terms::TermId b) { return terms_.Or(terms_.Not(a), b); }
  void MakeWords(OfProgram& loop);
  void AddWord(OfProgram& loop, std::string name, std::vector<size_t> cells);
  /// The words, the number of rounds, and whether there was one.
  std::vector<terms::TermId> WordsAt(const OfProgram& loop, const execute::ProgramLoop::Head& head);
  void GuessWords(OfProgram& loop, const std::string& prefix);
  static Guess FixedBits(const SampledValue& sampled);
  terms::TermId LaterAt(const OfProgram& loop, const execute::ProgramLoop::Head& head);
  /// `others`: the number of rounds, whether there was one, then OfProgram::others.
  terms::TermId Apply(const WordGuess& guess, terms::TermId word, std::span<const terms::TermId> others);
  std::vector<terms::TermId> OthersOf(const OfProgram& loop, std::span<const terms::TermId> words);
  /// What the variables of a head are at another one.
  Replacements HeadAt(const OfProgram& loop, const execute::ProgramLoop::Head& head);
  /// Those that are claimed, as one term.
  terms::TermId ClaimFacts(const OfProgram& loop, size_t number);
  /// From the condition under which the loop goes round again, as it is over one head and, where it is tested after
  /// what the round writes, over the next one.
  std::vector<FactCandidate> FactsOf(const OfProgram& loop);
  std::vector<terms::TermId> FactsOnSamples(const OfProgram& loop, const std::string& prefix,
                                            std::vector<std::string>& keys);
  void ClaimWords(const OfProgram& loop, const std::string& where, Blame blame, terms::TermId given,
                  const execute::ProgramLoop::Head& head);
  /// A byte of State, or what a host function was told, as the program's cells say; none: the loop does not write them.
  Guess OwnCells(const OfProgram& loop, uint32_t slot);
  /// Of the items of `code`, to `open`.
  void Choose(const OfProgram& loop, const CodeLoop& code, OfCode& open);
  uint32_t Dropped(const std::string& key) const;
  std::string NameOf(const CodeLoop::Item& item) const;
  void Claim(const OfProgram& loop, std::string what, std::string guess, Blame blame, terms::TermId given,
             terms::TermId a, terms::TermId b);

  terms::Terms& terms_;
  const emit::Emittable& emittable_;
  const ir::Program& program_;
  const execute::Cells& cells_;
  const StateImage& image_;
  std::function<terms::TermId(execute::CellId)> initial_;
  const DroppedGuesses& dropped_;
  std::vector<std::unique_ptr<OfProgram>> loops_;
  std::vector<size_t> open_;  // of the program's
  terms::TermId given_;
  std::vector<terms::TermId> noted_;
  std::vector<OfCode> open_in_code_;
  size_t next_in_code_ = 0;
  terms::TermId given_in_code_;
  std::vector<LoopClaim> claims_;
};

}  // namespace plcxx::prove::verify
