// Random single edits of a program's text, in any of the languages.
//
// In: the files of a program. Out: one of them with one place changed, as a tired person would: an operand, a number,
// an operator, a negation, a line that is gone, moved, or has another mnemonic. Not its job: whether the result is a
// program.
#pragma once

#include <map>
#include <string>

#include "transpiler/symbolic/terms/random.h"

namespace plcxx::review::diff {

struct SourceEdit {
  std::string file;  // its key in the map
  std::string text;  // the whole file, edited
  std::string what;  // "line 7: 'A' instead of 'AN'"
};

/// `files`: name and text. The same random numbers give the same edit. An empty `file`: there was nothing to edit.
SourceEdit EditedSource(const std::map<std::string, std::string>& files, terms::Random& random);

}  // namespace plcxx::review::diff
