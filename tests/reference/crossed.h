// Accepted golden programs, changed and joined: what somebody wrote, with something in it that nobody meant.
//
// In: the golden scenarios of a dialect that have steps. Out: programs with a scenario, as the generators make them.
// Everything follows from the seed and the golden programs. Many are refused: a change knows words, no grammar.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/reference/random_program.h"

namespace plcxx::reference {

class Goldens {
 public:
  /// Reads them all: some hundred small files.
  explicit Goldens(std::string_view dialect);

  size_t size() const { return programs_.size(); }
  /// One of them with 1 to 4 changes: an operand, an operator, an instruction or a number is another one that appears
  /// between such neighbours, lines are swapped, repeated, moved or left out, lines of another golden program are put
  /// in, with its steps. There is at least one golden program.
  RandomProgram Crossed(Random& random) const;

 private:
  /// What is left and right of a word, as kinds; all words that appear there.
  using Words = std::map<std::string, std::vector<std::string>>;

  void Learn(const RandomProgram& program);
  void ChangeLine(std::string& line, Random& random) const;
  void Change(std::vector<Piece>& lines, Random& random) const;

  std::vector<RandomProgram> programs_;
  Words by_neighbours_, by_shape_;
};

}  // namespace plcxx::reference
